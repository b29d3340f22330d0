#include "reference_fem/mesh_file.h"

#include <cmath>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>
#include <fstream>
#include <limits>
#include <sstream>

#include <vasorod/error.h>

#include "reference_fem/make_mesh.h"
#include "reference_fem/msh_format.h"

namespace vasorod::fem {
namespace {

using std::size_t;

/// Largest distance of vertices from the tube, in its parameters. Closer vertices are moved onto
/// it.
constexpr double slack = 1e-6;

enum Tag : unsigned { start_tag = 1, end_tag = 2, inner_tag = 3, outer_tag = 4 };

std::string written(const Vec3& v) {
  std::ostringstream s;
  s << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return s.str();
}

/// (angle, abscissa, depth), so that halved cells lie on the tube.
template <int dim>
class TubeManifold final : public dealii::ChartManifold<dim, 3, 3> {
 public:
  explicit TubeManifold(const TubeShape& tube)
      : dealii::ChartManifold<dim, 3, 3>(dealii::Tensor<1, 3>({1., 0., 0.})), tube_(tube) {}
  dealii::Point<3> pull_back(const dealii::Point<3>& x) const override {
    const Vec3 p = tube_.parameters(Vec3(x[0], x[1], x[2]));
    return {p[0], p[1], p[2]};
  }
  dealii::Point<3> push_forward(const dealii::Point<3>& p) const override {
    const Vec3 x = tube_.point(Vec3(p[0], p[1], p[2]));
    return {x[0], x[1], x[2]};
  }
  std::unique_ptr<dealii::Manifold<dim, 3>> clone() const override {
    return std::make_unique<TubeManifold>(tube_);
  }

 private:
  TubeShape tube_;
};

/// Parameters of a vertex. Vertices within the slack of an end or of a wall's face are moved onto
/// it.
Vec3 on_tube(const TubeShape& tube, const Vec3& x, int dim, const MeshFile& file) {
  Vec3 p = tube.parameters(x), snapped = p;
  if (dim == 2) snapped[2] = 0.5;
  for (int d = 1; d < dim; ++d)
    for (const double face : {0.0, 1.0})
      if (std::abs(p[d] - face) < slack) snapped[d] = face;
  const bool inside = snapped[1] >= 0 && snapped[1] <= 1 && snapped[2] >= 0 && snapped[2] <= 1;
  const double off = (tube.point(snapped) - tube.point(p)).norm();
  if (inside && off < slack) return snapped;
  const Vec3 in_file = file.length_unit * (tube.placement.inverse() * x);
  std::ostringstream distance;
  distance << file.length_unit * std::abs(dim == 2 ? (p[2] - 0.5) * tube.thickness_at(p[1]) : off);
  throw InputError(file.path + ": found the vertex " + written(in_file) +
                   (dim == 2 && p[1] > -slack && p[1] < 1 + slack
                        ? ", " + distance.str() + " off the mid-wall"
                        : "") +
                   "; expected all vertices " + (dim == 2 ? "on the mid-wall" : "in the wall") +
                   " of the scene's tube, in its start section's axes");
}

/// Checks that tagged faces of the boundary lie where their tag says.
template <int dim>
void check_tags(const dealii::Triangulation<dim, 3>& tria, const std::vector<Vec3>& vertices,
                const MeshFile& file) {
  for (const auto& cell : tria.active_cell_iterators())
    for (const auto& face : cell->face_iterators()) {
      if (!face->at_boundary() || face->boundary_id() == 0) continue;
      const unsigned tag = face->boundary_id();
      const int direction = tag <= end_tag ? 1 : 2;
      const double side = tag == end_tag || tag == outer_tag ? 1 : 0;
      bool on = tag <= (dim == 3 ? outer_tag : end_tag);
      for (const auto v : face->vertex_indices())
        on = on && vertices[face->vertex_index(v)][direction] == side;
      if (on) continue;
      const Vec3& p = vertices[face->vertex_index(0)];
      throw InputError(file.path + ": found the physical tag " + std::to_string(tag) +
                       " on a face at the fraction " + std::to_string(p[1]) +
                       " of the length; expected 1 at the start, 2 at the end" +
                       (dim == 3 ? ", 3 on the inner and 4 on the outer wall" : ""));
    }
}

void check_cover(const Mesh& mesh, const MeshFile& file) {
  for (const Eigen::VectorXd& weights : mesh.weights)
    if (weights.size() > 0 && !(weights.minCoeff() > 0))
      throw InputError(file.path + ": found a cell turned inside out; expected positive volumes");
  struct Part {
    const char* name;
    int direction, side;
  };
  for (const Part& part : {Part{"start", 1, 0}, Part{"end", 1, 1}, Part{"inner wall", 2, 0},
                           Part{"outer wall", 2, 1}}) {
    if (mesh.dim == 2 && part.direction == 2) break;
    double covered = 0;
    for (const double e : face_of(mesh, part.direction, part.side).extent) covered += e;
    if (std::abs(covered - 1) < 1e-5) continue;
    std::ostringstream percent;
    percent << 100 * covered;
    throw InputError(file.path + ": found cells on " + percent.str() + " % of the tube's " +
                     part.name + "; expected 100 %");
  }
}

template <int dim>
Mesh read(const MeshFile& file, const TubeShape& tube, int degree, const Processes& processes) {
  check_msh(file.path, dim);
  dealii::Triangulation<dim, 3> tria;
  try {
    dealii::GridIn<dim, 3> reader;
    reader.attach_triangulation(tria);
    std::ifstream stream(file.path);
    reader.read_msh(stream);
  } catch (const dealii::ExceptionBase& error) {
    std::ostringstream why;
    error.print_info(why);
    std::string clause = why.str();
    for (char& c : clause)
      if (c == '\n') c = ' ';
    throw InputError(file.path + ": found a mesh that deal.II refuses (" + clause +
                     "); expected conforming cells with tags on the outer boundary only");
  }
  // to the tube's units and placement
  dealii::GridTools::transform(
      [&](const dealii::Point<3>& p) {
        const Vec3 x = tube.placement * Vec3(Vec3(p[0], p[1], p[2]) / file.length_unit);
        return dealii::Point<3>(x[0], x[1], x[2]);
      },
      tria);
  std::vector<Vec3> parameters;
  for (const auto& v : tria.get_vertices())
    parameters.push_back(on_tube(tube, Vec3(v[0], v[1], v[2]), dim, file));
  check_tags<dim>(tria, parameters, file);

  dealii::Triangulation<dim, 3> fine, *use = &tria;
  if (file.halvings > 0) {
    tria.set_all_manifold_ids(0);
    tria.set_manifold(0, TubeManifold<dim>(tube));
    tria.refine_global(static_cast<unsigned>(file.halvings));
    dealii::GridGenerator::flatten_triangulation(tria, fine);
    use = &fine;
    parameters.clear();
    for (const auto& v : fine.get_vertices())
      parameters.push_back(on_tube(tube, Vec3(v[0], v[1], v[2]), dim, file));
  }
  std::vector<Eigen::Matrix3Xd> corners;
  for (const auto& cell : use->active_cell_iterators()) {
    Eigen::Matrix3Xd own(3, cell->n_vertices());
    for (const auto v : cell->vertex_indices()) {
      own.col(v) = parameters[cell->vertex_index(v)];
      own(0, v) -= std::round(own(0, v) - own(0, 0));  // across the seam
    }
    corners.push_back(std::move(own));
  }
  const Chart chart = [tube](const Vec3& p) { return tube.point(p); };
  Mesh mesh = make_mesh<dim>(*use, std::move(corners), chart, true, degree, processes);
  check_cover(mesh, file);
  return mesh;
}

}  // namespace

Mesh read_solid(const MeshFile& file, const TubeShape& tube, int degree,
                const Processes& processes) {
  return read<3>(file, tube, degree, processes);
}

Mesh read_surface(const MeshFile& file, const TubeShape& tube, int degree,
                  const Processes& processes) {
  return read<2>(file, tube, degree, processes);
}

CellCount count_cells(const Mesh& mesh) {
  const double cells = mesh.cell_count(),
               start = static_cast<double>(face_of(mesh, 1, 0).nodes.size());
  const double wall = mesh.dim == 3 ? static_cast<double>(face_of(mesh, 2, 0).nodes.size()) : cells;
  return {static_cast<int>(std::lround(start * wall / cells)),
          static_cast<int>(std::lround(cells / start))};
}

}  // namespace vasorod::fem
