// Runs one kernel a number of times: `kernel_instructions NAME RUNS`. instructions.py counts the
// instructions of a run with callgrind; 0 runs measure the set-up alone. Without arguments, lists
// the names. The surfaces are tubes R 8, t 1.6, L 40 with 64 vertices around, bent by half the
// Brazier curvature; the rod is the 45 degree bend of 100 elements.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <vasorod/tube.h>

#include "../chain.h"
#include "bodies/contact_pair.h"
#include "numerics/cholesky.h"
#include "paper/paper_energy.h"
#include "wall/wall_energy.h"

namespace {

using namespace vasorod;

constexpr double radius = 8, thickness = 1.6, length = 40, nu = 0.3;
constexpr int around = 64, along = 58;

// Each `coarser` times as coarse.
TubeSpec straight(int coarser = 1) {
  TubeSpec tube;
  tube.length = length;
  tube.radius = radius;
  tube.around = around / coarser;
  tube.along = along / coarser;
  return tube;
}

TubeSpec bent(int coarser = 1) {
  TubeSpec tube = straight(coarser);
  const double curvature = 0.5 * 0.471 * thickness / (radius * radius * std::sqrt(1 - nu * nu));
  tube.bend_deg = curvature * length * 180 / std::numbers::pi;
  return tube;
}

using Kernel = std::function<void()>;

struct Wall {
  std::unique_ptr<WallEnergy> energy;
  Eigen::VectorXd q, gradient;
  explicit Wall(int coarser = 1) {
    WallInput in;
    in.rest = tube_surface(straight(coarser));
    in.thickness.setConstant(in.rest.points.rows(), thickness);
    in.axis.assign(static_cast<std::size_t>(in.rest.triangles.rows()), Vec3::UnitZ());
    in.material = Material::isotropic(1, nu);
    energy = std::make_unique<WallEnergy>(in);
    q = energy->rest();
    const Points points = tube_surface(bent(coarser)).points;
    for (Eigen::Index i = 0; i < points.rows(); ++i) q.segment<3>(3 * i) = points.row(i);
  }
};

Kernel wall_gradient() {
  const auto wall = std::make_shared<Wall>();
  return [wall] { wall->energy->gradient(wall->q, wall->gradient); };
}

Kernel wall_hessian() {
  const auto wall = std::make_shared<Wall>();
  return [wall] { wall->energy->hessian(wall->q); };
}

// The numbers of a factor whose pattern is known, ordered as `coupled` orders it; of a mesh half as
// fine.
Kernel wall_factor() {
  struct Factor {
    Eigen::SparseMatrix<double> matrix;
    Cholesky cholesky;
  };
  const auto factor = std::make_shared<Factor>();
  const Wall wall(2);
  factor->matrix = wall.energy->hessian(wall.energy->rest());
  factor->matrix.diagonal() *= 1.01;  // a wall that nothing holds is only semidefinite
  const int vertices = wall.energy->vertices();
  std::vector<int> groups;
  for (int i = 0; i < vertices; ++i) groups.push_back(3 * i);
  for (int edge = 3 * vertices; edge < factor->matrix.cols(); ++edge) groups.push_back(edge);
  factor->cholesky.analyse(factor->matrix,
                           elimination_order(factor->matrix, groups, Ordering::nested_dissection));
  return [factor] {
    if (!factor->cholesky.factorise(factor->matrix)) std::abort();
  };
}

// Another such tube at a distance of 1: all closest features are found from scratch.
Kernel contact_search() {
  const TriangleSurface slave = tube_surface(straight());
  TriangleSurface master = slave;
  master.points.col(0).array() += 2 * radius + thickness + 1;
  const auto pair = std::make_shared<ContactPair>(ContactSide{slave, thickness / 2, {}},
                                                  ContactSide{master, thickness / 2, {}}, 1.0);
  return [=] { pair->refresh(slave.points, master.points, 4); };
}

Kernel paper_gradient() {
  struct Paper {
    PaperSystem system;
    Points points;
    PaperGradient gradient;
  };
  const auto paper = std::make_shared<Paper>();
  const TriangleSurface rest = tube_surface(straight());
  const auto count = static_cast<std::size_t>(rest.points.rows());
  paper->points = tube_surface(bent()).points;
  append_body(paper->system, rest, paper->points, std::vector<Mat3>(count, Mat3::Identity()),
              {0.1, 1, 0.3}, std::vector<char>(count, 0));
  paper->points -= paper->system.carried;  // the displacements
  return [paper] { paper_energy_gradient_at(paper->system, paper->points, paper->gradient); };
}

Kernel rod_solve() {
  const auto tree = std::make_shared<RodTree>(bench::chain(
      25 * std::numbers::pi, {0, .01, 0}, 100, bench::stiffness(5e6, 1e7, 1e7 / 12, 833333.3)));
  return [tree] { solve_rod(*tree, bench::cantilever(*tree, {0, 600, 0})); };
}

}  // namespace

int main(int count, char** arguments) {
  const std::map<std::string, Kernel (*)()> kernels{
      {"wall_gradient", wall_gradient},   {"wall_hessian", wall_hessian},
      {"contact_search", contact_search}, {"paper_gradient", paper_gradient},
      {"rod_solve", rod_solve},           {"wall_factor", wall_factor}};
  if (count == 1) {
    for (const auto& [name, make] : kernels) std::printf("%s\n", name.c_str());
    return 0;
  }
  const auto found = kernels.find(arguments[1]);
  if (found == kernels.end() || count != 3) {
    std::fprintf(
        stderr,
        "kernel_instructions: found no kernel and number of runs, expected one of its names\n");
    return 2;
  }
  const Kernel kernel = found->second();
  for (int run = std::atoi(arguments[2]); run > 0; --run) kernel();
  return 0;
}
