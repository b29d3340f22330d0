// Compares surface solvers on a tube (R 8, t 1.6, L 160) bent along the inextensible arc to half
// its Brazier limit: `paper`, `coupled`, and CGAL's Surface_mesh_deformation (SR_ARAP, both rims as
// position handles), each to a relative residual of 1e-4 of its own energy. Lower bounds: analyse,
// factorise and solve once with the constant matrix of `paper`, and with the rest Hessian K0 of
// `coupled`, each in the order with the fewest flops of those known (its name is the label),
// which is found before.
// Counters: vertices, iterations, residual, Gflop of a factorisation.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <Eigen/SparseCore>
#include <benchmark/benchmark.h>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <sys/resource.h>

#include <vasorod/tube.h>

#include "bodies/scaled_bodies.h"
#include "coupled/coupled_problem.h"
#include "geometry/rigid_motion.h"
#include "numerics/blas.h"
#include "numerics/cholesky.h"
#include "paper/paper_energy.h"
#include "paper/paper_solver.h"
#include "rod/binding.h"

namespace {

using namespace vasorod;

constexpr double radius = 8, thickness = 1.6, length = 160, poisson = 0.3;
constexpr double residual_asked = 1e-4;

/// Near-equilateral rows of `around` vertices.
TubeSpec tube_of(int around) {
  TubeSpec tube;
  tube.length = length;
  tube.radius = radius;
  tube.around = around;
  const double edge = 2 * std::numbers::pi * radius / around;
  tube.along = static_cast<int>(std::lround(length / (edge * std::sqrt(3.0) / 2)));
  return tube;
}

/// The angle of half the Brazier limit, k_cr = 0.471 t / (R^2 sqrt(1 - nu^2)), over the length.
double bend_angle() {
  return 0.5 * 0.471 * thickness / (radius * radius * std::sqrt(1 - poisson * poisson)) * length;
}

/// The tube with its sections carried rigidly to an arc of `angle`; both rims are held there.
SurfaceBody carried_body(const TubeSpec& tube, double angle) {
  SurfaceBody body;
  body.name = "tube";
  body.rest = tube_surface(tube);
  body.thickness = thickness;
  body.offset = thickness / 2;
  const Eigen::VectorXd s = tube_arc_lengths(tube);
  TubeSpec arc = tube;
  arc.bend_deg = angle * 180 / std::numbers::pi;
  body.carried.resize(body.rest.points.rows(), 3);
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    const Pose from = tube_axis(tube, s[i]), to = tube_axis(arc, s[i]);
    const Mat3 turn = to.rotation * from.rotation.transpose();
    body.carried.row(i) =
        (to.position + turn * (body.rest.points.row(i).transpose() - from.position)).transpose();
    body.rotations.push_back(turn);
  }
  body.fixed.assign(static_cast<std::size_t>(s.size()), 0);
  for (int k = 0; k < tube.around; ++k)
    body.fixed[static_cast<std::size_t>(k)] =
        body.fixed[body.fixed.size() - 1 - static_cast<std::size_t>(k)] = 1;
  WallGeometry wall;
  wall.thickness = thickness;
  wall.radius = radius;
  wall.mean_edge = 2 * std::numbers::pi * radius / tube.around;
  wall.vertex_area = 2 * std::numbers::pi * radius * length / static_cast<double>(s.size());
  body.k = coefficients_from_wall(Material::isotropic(1, poisson), wall);
  return body;
}

PaperOptions paper_options() {
  PaperOptions options;
  options.tolerance = residual_asked;
  options.balance_tolerance = 1;  // only the residual decides, as for the other solvers
  return options;
}

void paper(benchmark::State& state) {
  const TubeSpec tube = tube_of(static_cast<int>(state.range(0)));
  BodyProblem problem;
  problem.bodies = {carried_body(tube, bend_angle())};
  SurfaceSolution last;
  for (auto _ : state) last = solve_paper(problem, paper_options());
  state.counters["vertices"] = static_cast<double>(problem.bodies[0].rest.points.rows());
  state.counters["iterations"] = last.iterations;
  state.counters["residual"] = last.residual;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;  // of the whole program
  state.SetLabel(to_string(last.status));
}
BENCHMARK(paper)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);
BENCHMARK(paper)->Name("paper_million")->Arg(521)->Iterations(1)->Unit(benchmark::kSecond);

// The factor is kept. Two bends alternate, so that no solve repeats the last one.
void paper_again(benchmark::State& state) {
  const TubeSpec tube = tube_of(static_cast<int>(state.range(0)));
  BodyProblem problems[2];
  problems[0].bodies = {carried_body(tube, bend_angle())};
  problems[1].bodies = {carried_body(tube, 0.9 * bend_angle())};
  PaperSolver solver(paper_options());
  solver.solve(problems[0]);
  SurfaceSolution last;
  std::size_t next = 1;
  for (auto _ : state) {
    last = solver.solve(problems[next]);
    next = 1 - next;
  }
  state.counters["vertices"] = static_cast<double>(problems[0].bodies[0].rest.points.rows());
  state.counters["iterations"] = last.iterations;
  state.counters["residual"] = last.residual;
  state.SetLabel(to_string(last.status));
}
BENCHMARK(paper_again)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

/// Ways to order a matrix, found on groups of unknowns.
struct Way {
  const char* name;
  std::vector<int> groups;
  Ordering ordering;
};

double flops(const Supernodes& nodes) {
  double sum = 0;
  for (int k = 0; k < nodes.size(); ++k)
    for (int j = 0; j < nodes[k].columns; ++j) {
      const double below = nodes[k].rows - j;
      sum += below * below;
    }
  return sum;
}

/// Analyses, factorises and solves once, in the order whose factor takes the fewest flops. The
/// order is found before, as it can be kept between solves.
void floor_of(benchmark::State& state, const Eigen::SparseMatrix<double>& matrix,
              const std::vector<Way>& ways, const Eigen::MatrixXd& b) {
  std::vector<int> best;
  double fewest = std::numeric_limits<double>::infinity();
  for (const Way& way : ways) {
    std::vector<int> order = elimination_order(matrix, way.groups, way.ordering);
    const double count = flops(Analysis(matrix, order).nodes());
    if (!(count < fewest)) continue;
    fewest = count;
    best = std::move(order);
    state.SetLabel(way.name);
  }
  Eigen::MatrixXd x = b;
  bool factorised = false;
  for (auto _ : state) {
    Cholesky factor;
    factor.analyse(matrix, best);
    factorised = factor.factorise(matrix);
    if (factorised) factor.solve(b.data(), x.data(), static_cast<int>(b.cols()));
    benchmark::DoNotOptimize(x.data());
  }
  if (!factorised) state.SkipWithError("the matrix is not positive definite");
  state.counters["Gflop"] = fewest / 1e9;
}

std::vector<int> singles(Eigen::Index unknowns) {
  std::vector<int> first(static_cast<std::size_t>(unknowns));
  std::iota(first.begin(), first.end(), 0);
  return first;
}

void paper_floor(benchmark::State& state) {
  BodyProblem problem;
  problem.bodies = {carried_body(tube_of(static_cast<int>(state.range(0))), bend_angle())};
  const ScaledBodies scaled = scale_bodies(problem);
  const ScaledBody& body = scaled.bodies[0];
  PaperSystem system;
  append_body(system, body.rest, body.carried, body.rotations, body.k, body.fixed);
  const Eigen::SparseMatrix<double> matrix = paper_energy_bound(system, body.carried);
  const std::vector<int> vertices = singles(matrix.cols());
  floor_of(state, matrix,
           {{"AMD", vertices, Ordering::minimum_degree},
            {"METIS", vertices, Ordering::nested_dissection}},
           body.carried);
  state.counters["vertices"] = static_cast<double>(body.rest.points.rows());
}
BENCHMARK(paper_floor)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

CarriedBody carried_wall(const TubeSpec& tube, double angle) {
  const SurfaceBody body = carried_body(tube, angle);
  TubeSpec arc = tube;
  arc.bend_deg = angle * 180 / std::numbers::pi;
  const Mat3 turn = tube_axis(arc, length).rotation * tube_axis(tube, length).rotation.transpose();
  return {body.carried, body.rotations, {Pose{}, Pose{turn, tube_axis(arc, length).position}}};
}

HeldSection rim(const TubeSpec& tube, int row) {
  HeldSection section;
  section.label = row == 0 ? "start" : "end";
  for (int k = 0; k < tube.around; ++k) section.ring.push_back(row * tube.around + k);
  section.rest.position = tube_axis(tube, row == 0 ? 0 : length).position;
  return section;
}

HeldSection moved_rim(const TubeSpec& tube, double angle) {
  HeldSection section = rim(tube, tube.along);
  const Pose target = carried_wall(tube, angle).sections[1];
  section.motion.rotate = log_rotation(target.rotation);
  section.motion.move = target.position - section.rest.position;
  return section;
}

CoupledProblem coupled_problem(const TubeSpec& tube, double angle) {
  CoupledProblem problem;
  problem.surfaces.bodies = {carried_body(tube, angle)};
  CoupledVessel vessel;
  vessel.wall.rest = problem.surfaces.bodies[0].rest;
  vessel.wall.thickness.setConstant(vessel.wall.rest.points.rows(), thickness);
  vessel.wall.axis.assign(static_cast<std::size_t>(vessel.wall.rest.triangles.rows()),
                          Vec3::UnitZ());
  vessel.wall.material = Material::isotropic(1, poisson);
  vessel.sections = {rim(tube, 0), moved_rim(tube, angle)};
  problem.vessels.push_back(std::make_unique<CoupledVessel>(std::move(vessel)));
  problem.carried = [=](double t) {
    return std::vector<CarriedBody>{carried_wall(tube, t * angle)};
  };
  return problem;
}

CoupledOptions coupled_options() {
  CoupledOptions options;
  options.tolerance = residual_asked;
  options.balance_tolerance = 1;
  options.certify = false;
  return options;
}

void report(benchmark::State& state, const CoupledSolution& last) {
  state.counters["vertices"] = static_cast<double>(last.surface.bodies[0].positions.rows());
  state.counters["iterations"] = last.surface.iterations;
  state.counters["residual"] = last.surface.residual;
  state.SetLabel(to_string(last.status));
}

void coupled(benchmark::State& state) {
  const TubeSpec tube = tube_of(static_cast<int>(state.range(0)));
  CoupledSolution last;
  for (auto _ : state)
    last = CoupledSolver(coupled_problem(tube, bend_angle()), coupled_options()).solve();
  report(state, last);
}
BENCHMARK(coupled)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

void coupled_again(benchmark::State& state) {  // another bend with kept factors
  const TubeSpec tube = tube_of(static_cast<int>(state.range(0)));
  CoupledSolver solver(coupled_problem(tube, bend_angle()), coupled_options());
  solver.solve();
  const double other = 0.9 * bend_angle();
  CoupledSolution last;
  for (auto _ : state) {
    solver.set_sections(0, {rim(tube, 0), moved_rim(tube, other)});
    solver.set_carried(
        [=](double t) { return std::vector<CarriedBody>{carried_wall(tube, t * other)}; });
    last = solver.solve();
  }
  report(state, last);
}
BENCHMARK(coupled_again)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

void coupled_floor(benchmark::State& state) {
  const CoupledProblem problem =
      coupled_problem(tube_of(static_cast<int>(state.range(0))), bend_angle());
  const WallInput& input = problem.vessels[0]->wall;
  WallEnergy wall(input);
  Eigen::SparseMatrix<double> k0 = wall.hessian(wall.rest());
  const auto& fixed = problem.surfaces.bodies[0].fixed;
  for (std::size_t i = 0; i < fixed.size(); ++i)
    for (Eigen::Index k = 0; fixed[i] && k < 3; ++k) {  // both rims held by stiff springs
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(i) + k;
      k0.coeffRef(row, row) *= 1e6;
    }
  std::vector<int> groups;  // the vertices, then an unknown on each edge
  for (int i = 0; i < wall.vertices(); ++i) groups.push_back(3 * i);
  for (int edge = 3 * wall.vertices(); edge < k0.cols(); ++edge) groups.push_back(edge);
  const std::vector<int> unknowns = singles(k0.cols());
  floor_of(state, k0,
           {{"AMD of unknowns", unknowns, Ordering::minimum_degree},
            {"AMD of vertices and edges", groups, Ordering::minimum_degree},
            {"METIS of unknowns", unknowns, Ordering::nested_dissection},
            {"METIS of vertices and edges", groups, Ordering::nested_dissection}},
           wall.rest());
  state.counters["vertices"] = static_cast<double>(input.rest.points.rows());
}
BENCHMARK(coupled_floor)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Deformation =
    CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, CGAL::SRE_ARAP>;

class Arap {
 public:
  explicit Arap(const SurfaceBody& body) {
    std::vector<Mesh::Vertex_index> vertex;
    for (Eigen::Index i = 0; i < body.rest.points.rows(); ++i)
      vertex.push_back(mesh_.add_vertex(
          {body.rest.points(i, 0), body.rest.points(i, 1), body.rest.points(i, 2)}));
    const auto at = [&](int i) { return vertex[static_cast<std::size_t>(i)]; };
    for (Eigen::Index t = 0; t < body.rest.triangles.rows(); ++t)
      mesh_.add_face(at(body.rest.triangles(t, 0)), at(body.rest.triangles(t, 1)),
                     at(body.rest.triangles(t, 2)));
    laplacian_ = cotangent_laplacian();
    deformation_ = std::make_unique<Deformation>(mesh_);
    deformation_->insert_roi_vertices(mesh_.vertices().begin(), mesh_.vertices().end());
    for (std::size_t i = 0; i < body.fixed.size(); ++i)
      if (body.fixed[i]) deformation_->insert_control_vertex(vertex[i]);
    if (!deformation_->preprocess()) throw std::runtime_error("CGAL's matrix is singular");
    for (std::size_t i = 0; i < body.fixed.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (body.fixed[i])
        deformation_->set_target_position(
            vertex[i], {body.carried(row, 0), body.carried(row, 1), body.carried(row, 2)});
    }
    fixed_ = body.fixed;
  }

  void iterate(unsigned count) { deformation_->deform(count, 0.0); }

  Points positions() const {
    Points p(static_cast<Eigen::Index>(mesh_.number_of_vertices()), 3);
    for (const Mesh::Vertex_index v : mesh_.vertices()) {
      const Kernel::Point_3& at = mesh_.point(v);
      p.row(static_cast<Eigen::Index>(v.idx())) << at.x(), at.y(), at.z();
    }
    return p;
  }

  /// Residual after the step from `before`. A local-global step solves
  /// L (p_after - p_before) = force(p_before), so |L dp| is the out-of-balance force;
  /// |L p_before| and |L p_after - L dp| are its two parts.
  double residual(const Points& before, const Points& after) const {
    Points step = laplacian_ * (after - before), now = laplacian_ * before,
           then = laplacian_ * after;
    for (std::size_t i = 0; i < fixed_.size(); ++i)
      if (fixed_[i]) {
        const auto row = static_cast<Eigen::Index>(i);
        step.row(row).setZero();
        now.row(row).setZero();
        then.row(row).setZero();
      }
    return step.norm() / (now.norm() + then.norm());
  }

 private:
  Eigen::SparseMatrix<double> cotangent_laplacian() const {
    std::vector<Eigen::Triplet<double>> entries;
    const CGAL::Weights::Cotangent_weight<Mesh> weight;
    for (const Mesh::Edge_index e : mesh_.edges()) {
      const Mesh::Halfedge_index h = mesh_.halfedge(e);
      const double w = 2 * weight(h, mesh_, get(CGAL::vertex_point, mesh_));
      const int a = static_cast<int>(mesh_.source(h).idx()),
                b = static_cast<int>(mesh_.target(h).idx());
      entries.insert(entries.end(), {{a, a, w}, {b, b, w}, {a, b, -w}, {b, a, -w}});
    }
    const int n = static_cast<int>(mesh_.number_of_vertices());
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    return laplacian;
  }

  Mesh mesh_;
  Eigen::SparseMatrix<double> laplacian_;
  std::unique_ptr<Deformation> deformation_;
  std::vector<char> fixed_;
};

/// Number of iterations that CGAL needs, determined once per mesh outside the timing; at most
/// `most`.
std::pair<unsigned, double> iterations_needed(const SurfaceBody& body, unsigned most) {
  Arap arap(body);
  arap.iterate(1);  // moves the rims
  Points before = arap.positions();
  for (unsigned count = 1;; ++count) {
    arap.iterate(1);
    const Points after = arap.positions();
    const double residual = arap.residual(before, after);
    if (residual <= residual_asked || count == most) return {count, residual};
    before = after;
  }
}

void cgal_sr_arap(benchmark::State& state) {
  const SurfaceBody body = carried_body(tube_of(static_cast<int>(state.range(0))), bend_angle());
  static std::map<int, std::pair<unsigned, double>> known;
  auto [entry, fresh] = known.try_emplace(static_cast<int>(state.range(0)));
  if (fresh) entry->second = iterations_needed(body, 2000);
  const auto [count, residual] = entry->second;
  for (auto _ : state) {
    Arap arap(body);
    arap.iterate(count);
    benchmark::DoNotOptimize(&arap);
  }
  state.counters["vertices"] = static_cast<double>(body.rest.points.rows());
  state.counters["iterations"] = count;
  state.counters["residual"] = residual;
  state.SetLabel(residual <= residual_asked ? "converged" : "iteration_limit");
}
BENCHMARK(cgal_sr_arap)->Arg(29)->Arg(82)->Unit(benchmark::kMillisecond);

}  // namespace
