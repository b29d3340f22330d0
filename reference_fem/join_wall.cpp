#include "reference_fem/join_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/stress_free_search.h"
#include "reference_fem/prestress.h"
#include "reference_fem/tube_ends.h"

namespace vasorod::fem {
namespace {

template <class Wall>
WallModel with_ends(std::unique_ptr<Wall> model, const JoinWall& wall) {
  WallModel out;
  for (const EndProblem& end : wall.ends) {
    out.sections.push_back(end_section(*model, wall.shape, end.side, end.soft));
    apply(end, out.sections.back());
  }
  out.model = std::move(model);
  return out;
}

/// Parameters on the mesh of the vessel as seen of a node of the join's mesh.
Vec3 seen_parameters(const JoinWall& wall, const Vec3& at) {
  const Vec2 place = wall.hole ? wall.hole->place(at[0], at[1]) : Vec2(at[0], at[1]);
  return {place[0], wall.kept_from + place[1] * (wall.kept_to - wall.kept_from), at[2]};
}

/// Degrees of freedom at the nodes of a mesh, interpolated from those of the vessel as seen.
Eigen::VectorXd carried(const JoinWall& wall, const Mesh& mesh, const Mesh& seen,
                        const Eigen::VectorXd& u) {
  std::vector<Vec3> at;
  for (int node = 0; node < mesh.node_count(); ++node)
    at.push_back(seen_parameters(wall, mesh.parameters.row(node)));
  const std::vector<CellRow> rows = seen.rows_at(at);
  const Eigen::Index components = u.size() / seen.node_count();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(components * mesh.node_count());
  for (std::size_t node = 0; node < rows.size(); ++node) {
    const std::vector<int>& nodes = seen.cell_nodes[static_cast<std::size_t>(rows[node].cell)];
    for (std::size_t a = 0; a < nodes.size(); ++a)
      out.segment(components * static_cast<Eigen::Index>(node), components) +=
          rows[node].shape[static_cast<Eigen::Index>(a)] *
          u.segment(components * nodes[a], components);
  }
  return out;
}

/// Where each vessel's strip meets the planes of symmetry.
using PlanesOf = std::array<bool, 2> (*)(const JoinProblem&, const Vec3&);

/// The displacement on one mesh, of the vessel as it was seen or of the join. `supports` has what
/// is prescribed beside the ends and the planes of symmetry.
SeenDisplacement displacement(const JoinProblem& problem, const JoinWall& wall, PlanesOf planes_of,
                              const Mesh& mesh, Supports supports, double largest_linear,
                              const Processes& processes) {
  const WallModel held = wall_model(wall, mesh);
  const bool half_along = planes_of == planes_of_artery && problem.mirror[0];
  for (std::size_t e = 0; e < wall.ends.size(); ++e)
    if (!half_along || wall.ends[e].side == 1) supports.sections.push_back(held.sections[e]);
  const int components = held.model->components();
  for (int node = 0; node < mesh.node_count(); ++node)
    hold_in_planes(planes_of(problem, mesh.parameters.row(node)), components * node, components,
                   true, supports);
  return seen_displacement(*held.model, wall.seen, std::move(supports), largest_linear, processes);
}

/// The values `u` on the rim of the hole.
Supports rim_at(const JoinProblem& problem, const Mesh& mesh, const Eigen::VectorXd& u) {
  Supports supports;
  const Eigen::Index components = u.size() / mesh.node_count();
  const Incision& incision = problem.incision;
  for (int node = 0; node < mesh.node_count(); ++node) {
    const Vec3 at = mesh.parameters.row(node);
    if (std::min(std::abs(at[0]), std::abs(at[0] - 1)) > 1e-12 || at[1] < incision.from - 1e-12 ||
        at[1] > incision.to + 1e-12)
      continue;
    for (Eigen::Index k = components * node; k < components * (node + 1); ++k)
      supports.prescribed.emplace_back(static_cast<int>(k), u[k]);
  }
  return supports;
}

SeenShare prestress_wall(const JoinProblem& problem, const JoinWall& wall, PlanesOf planes_of,
                         const Mesh& mesh, const Mesh& seen_mesh, VesselModel& model,
                         const Processes& processes) {
  constexpr double any = std::numeric_limits<double>::infinity();
  // The displacement on the join's mesh; of the whole vessel into `share`.
  SeenShare share;
  const auto seen = [&](double largest_linear) {
    SeenDisplacement found =
        displacement(problem, as_seen(wall), planes_of, seen_mesh, {}, largest_linear, processes);
    share = {found.largest / wall.whole.mean_radius(), found.steps};
    found.u = carried(wall, mesh, seen_mesh, found.u);
    if (!wall.hole) return found;
    JoinWall held = wall;
    held.ends = wall.ends_when_seen;
    // In the same way as the whole vessel's.
    return displacement(problem, held, planes_of, mesh, rim_at(problem, mesh, found.u),
                        found.steps > 0 ? 0 : any, processes);
  };
  SeenDisplacement found = seen(largest_linear_prestrain);
  if (share.steps > 0 && !(found.steps > 0)) {  // none beside the hole
    found = seen(any);
    share.steps = 0;
  }
  give_prestress(model, wall.seen, found, processes);
  return share;
}

}  // namespace

WallModel wall_model(const JoinWall& wall, const Mesh& mesh) {
  const MaterialLaw law(wall.law, wall.moduli);
  const Axes axes = [&wall](const Vec3& p) { return wall.shape.axes(wall.parameters(p)); };
  if (mesh.dim == 3) {
    auto solid = std::make_unique<Solid>(mesh, law, axes);
    // The strip's depth counts inwards where it turns against the tube's angle.
    if (wall.seen.pressed())
      solid->add_pressure(2, wall.turn > 0 ? 0 : 1, wall.seen.pressure.after);
    return with_ends(std::move(solid), wall);
  }
  const ShellBody body{
      [axes](const Vec3& p) { return Vec3(axes(p).col(0)); },
      [&wall](const Vec3& p) { return wall.shape.thickness_at(wall.parameters(p)[1]); }, axes};
  auto shell = std::make_unique<Shell>(mesh, law, body, wall.law == LawKind::svk ? 2 : 5);
  return with_ends(std::move(shell), wall);
}

void hold_in_planes(const std::array<bool, 2>& planes, int first_dof, int components,
                    bool displacement, Supports& supports) {
  for (const int axis : {0, 1}) {
    if (!planes[static_cast<std::size_t>(axis)]) continue;
    if (displacement) supports.prescribed.emplace_back(first_dof + axis, 0.0);
    if (components == 7) supports.prescribed.emplace_back(first_dof + 3 + axis, 0.0);
  }
}

SeenDisplacements prestress_join(const JoinProblem& problem, const JoinCells& cells,
                                 const JoinMesh& mesh, VesselModel& vein, VesselModel& artery,
                                 const Processes& processes) {
  SeenDisplacements largest;
  if (!problem.stressed()) return largest;
  const JoinMesh seen = make_seen_mesh(problem, cells, processes);
  if (problem.vein.seen.stressed())
    largest.vein = prestress_wall(problem, problem.vein, planes_of_vein, mesh.vein, seen.vein, vein,
                                  processes);
  if (problem.artery.seen.stressed())
    largest.artery = prestress_wall(problem, problem.artery, planes_of_artery, mesh.artery,
                                    seen.artery, artery, processes);
  return largest;
}

}  // namespace vasorod::fem
