#include "reference_fem/join_solution.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "reference_fem/clock.h"
#include "reference_fem/join_wall.h"
#include "reference_fem/model_pair.h"

namespace vasorod::fem {
namespace {

/// Both walls as one model. The vein's degrees of freedom come first.
struct JoinModel {
  JoinModel(const JoinProblem& problem, const JoinCells& cells, const Processes& processes)
      : mesh(make_join_mesh(problem, cells, processes)),
        vein(wall_model(problem.vein, mesh.vein)),
        artery(wall_model(problem.artery, mesh.artery)),
        pair(*vein.model, *artery.model) {}

  /// Gives the models the stress of the vessels as seen and the pressures of the path.
  SeenDisplacements load(const JoinProblem& problem, const JoinCells& cells,
                         const Processes& processes) {
    const SeenDisplacements largest =
        prestress_join(problem, cells, mesh, *vein.model, *artery.model, processes);
    vein.model->set_pressure(problem.vein.seen.pressure);
    artery.model->set_pressure(problem.artery.seen.pressure);
    return largest;
  }
  int components() const { return pair.components(); }
  int first_of_vein(int node) const { return components() * node; }
  int first_of_artery(int node) const { return vein.model->dof_count() + components() * node; }

  JoinMesh mesh;
  WallModel vein, artery;
  ModelPair pair;
};

void tie_seam(const JoinModel& model, Supports& supports) {
  for (const SeamPair& pair : model.mesh.seam)
    for (int k = 0; k < 3; ++k)
      supports.ties.push_back({model.first_of_vein(pair.vein) + k,
                               model.first_of_artery(pair.artery) + k, -pair.gap[k]});
}

/// In a plane of symmetry displacement and director stay in the plane. The rim's displacement is
/// the lip's; the incision is open.
void hold_planes(const JoinProblem& problem, const JoinModel& model, Supports& supports) {
  const Mesh &vein = model.mesh.vein, &artery = model.mesh.artery;
  std::vector<char> tied(static_cast<std::size_t>(vein.node_count()), 0);
  for (const SeamPair& pair : model.mesh.seam) tied[static_cast<std::size_t>(pair.vein)] = 1;
  for (int node = 0; node < vein.node_count(); ++node)
    hold_in_planes(planes_of_vein(problem, vein.parameters.row(node)), model.first_of_vein(node),
                   model.components(), tied[static_cast<std::size_t>(node)] == 0, supports);
  const Incision& incision = problem.incision;
  for (int node = 0; node < artery.node_count(); ++node) {
    const Vec3 at = artery.parameters.row(node);
    std::array<bool, 2> planes = planes_of_artery(problem, at);
    if (at[0] < 1e-12 && at[1] > incision.from + 1e-12 && at[1] < incision.to - 1e-12)
      planes[1] = false;
    hold_in_planes(planes, model.first_of_artery(node), model.components(), true, supports);
  }
}

/// The condition of an end of the modelled part.
struct ModelledEnd {
  const EndProblem* end = nullptr;
  bool of_vein = false;
};

/// The sections of the modelled part, in the order of the result.
std::vector<ModelledEnd> add_ends(const JoinProblem& problem, const JoinModel& model,
                                  Supports& supports) {
  std::vector<ModelledEnd> ends;
  for (std::size_t e = 0; e < problem.vein.ends.size(); ++e) {
    supports.sections.push_back(model.vein.sections[e]);
    ends.push_back({&problem.vein.ends[e], true});
  }
  for (std::size_t e = 0; e < problem.artery.ends.size(); ++e) {
    const EndProblem& end = problem.artery.ends[e];
    if (problem.mirror[0] && end.side == 0) continue;
    Section section = model.artery.sections[e];
    for (Member& member : section.members) member.first_dof += model.first_of_artery(0);
    supports.sections.push_back(std::move(section));
    ends.push_back({&end, false});
  }
  return ends;
}

/// The reflections that copy the modelled part, as signs of the components.
std::vector<Vec3> reflections(bool x, bool y) {
  std::vector<Vec3> signs;
  for (const double sx : {1.0, -1.0})
    for (const double sy : {1.0, -1.0})
      if ((sx > 0 || x) && (sy > 0 || y)) signs.emplace_back(sx, sy, 1);
  return signs;
}

Vec3 mirrored(const Vec3& sign, const Vec3& vector) {
  return sign.cwiseProduct(vector);
}
/// Of moments and spins.
Vec3 mirrored_turn(const Vec3& sign, const Vec3& vector) {
  return sign.prod() * sign.cwiseProduct(vector);
}

void collect_forces(const JoinProblem& problem, const JoinModel& model,
                    const std::vector<ModelledEnd>& ends, const State& state,
                    const System::Assembly& assembly, JoinSolution& solution) {
  const double load = solution.summary.load;
  const auto [mirror_x, mirror_y] = problem.mirror;
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const EndProblem& end = *ends[s].end;
    const Pose& pose = state.pose[s];
    const Vec3 force = load * end.force;
    Vec3 moment = load * end.moment;
    if (end.moment_in_body) moment = pose.rotation * moment;
    JoinForces::End whole{end.name, Vec3::Zero(), Vec3::Zero(), pose.position};
    for (const Vec3& sign : reflections(ends[s].of_vein && mirror_x, mirror_y)) {
      whole.force += mirrored(sign, assembly.section_force[s].head<3>() - force);
      whole.moment += mirrored_turn(sign, assembly.section_force[s].tail<3>() - moment);
    }
    JoinForces& vessel = ends[s].of_vein ? solution.on_vein : solution.on_artery;
    vessel.load += force;
    if (!ends[s].of_vein && mirror_x) {
      const Vec3 sign(-1, 1, 1);
      std::string name;
      for (const EndProblem& other : problem.artery.ends)
        if (other.side == 0) name = other.name;
      vessel.ends.push_back({name, mirrored(sign, whole.force), mirrored_turn(sign, whole.moment),
                             mirrored(sign, whole.center)});
    }
    vessel.ends.push_back(std::move(whole));
  }
  Vec3 seam = Vec3::Zero();
  for (const SeamPair& pair : model.mesh.seam)
    seam += assembly.nodal.segment<3>(model.first_of_vein(pair.vein));
  for (const Vec3& sign : reflections(mirror_x, mirror_y))
    solution.on_vein.seam += mirrored(sign, seam);
  solution.on_artery.seam = -solution.on_vein.seam;
}

WallPoints unfold(const Mesh& mesh, const DofValues& u, const std::vector<Folded>& folded) {
  const int components = static_cast<int>(u.size()) / mesh.node_count();
  std::vector<Vec3> at;
  at.reserve(folded.size());
  for (const Folded& point : folded) at.push_back(point.parameter);
  WallPoints points = wall_points(mesh, u, components, at);
  for (std::size_t k = 0; k < folded.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    points.rest.row(row) = mirrored(folded[k].sign, points.rest.row(row));
    points.current.row(row) = mirrored(folded[k].sign, points.current.row(row));
  }
  return points;
}

// Points in the sense of the tube's angle, so that triangles face outwards.
double share_of_point(const JoinWall& wall, int point, int around) {
  const double share = static_cast<double>(point) / around;
  return wall.turn > 0 ? share : 1 - share;
}

MidWall rings_at(const std::vector<double>& fractions, const JoinSampling& sampling) {
  MidWall wall;
  wall.around = sampling.around;
  wall.along = static_cast<int>(fractions.size());
  wall.fraction = fractions;
  return wall;
}

MidWall sample_tube(const JoinProblem& problem, const JoinWall& tube, const Mesh& mesh,
                    const DofValues& u, const std::vector<double>& fractions,
                    const JoinSampling& sampling) {
  MidWall wall = rings_at(fractions, sampling);
  std::vector<Folded> grid;
  for (const double s : fractions)
    for (int i = 0; i < wall.around; ++i) {
      const double share = share_of_point(tube, i, wall.around);
      grid.push_back(fold_vein(problem, share == 1 ? 0 : share, s));
    }
  WallPoints points = unfold(mesh, u, grid);
  wall.rest = std::move(points.rest);
  wall.current = std::move(points.current);
  return wall;
}

MidWall sample_artery(const JoinProblem& problem, const Mesh& mesh, const DofValues& u,
                      const JoinSampling& sampling) {
  MidWall wall = rings_at(sampling.artery, sampling);
  std::vector<Folded> grid, lip;
  for (const double s : sampling.artery) {
    const bool open = s > problem.incision.from + 1e-12 && s < problem.incision.to - 1e-12;
    wall.open.push_back(open ? 1 : 0);
    for (int i = 0; i < wall.around; ++i)
      grid.push_back(fold_artery(problem, share_of_point(problem.artery, i, wall.around), s));
    if (open)
      lip.push_back(
          fold_artery(problem, share_of_point(problem.artery, wall.around, wall.around), s));
  }
  WallPoints points = unfold(mesh, u, grid), other = unfold(mesh, u, lip);
  wall.rest = std::move(points.rest);
  wall.current = std::move(points.current);
  wall.other_lip_rest = std::move(other.rest);
  wall.other_lip_current = std::move(other.current);
  return wall;
}

void sample_seam(const JoinProblem& problem, const JoinMesh& mesh, const DofValues& vein,
                 const DofValues& artery, int count, JoinSolution& solution) {
  std::vector<Folded> rim, lips;
  for (int k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / count;
    rim.push_back(fold_vein(problem, share, problem.seam_side));
    const Vec3 lip = problem.other_rim ? Vec3(share, problem.other_rim->side, 0.5)
                                       : problem.incision.rim_parameter(share);
    lips.push_back(fold_artery(problem, lip[0], lip[1]));
  }
  WallPoints points = unfold(mesh.vein, vein, rim);
  solution.rim_rest = std::move(points.rest);
  solution.rim = std::move(points.current);
  WallPoints others = unfold(mesh.artery, artery, lips);
  solution.lips_rest = std::move(others.rest);
  solution.lips = std::move(others.current);
}

/// Stations of the strip's lines, with points between them.
std::vector<double> dense(const std::vector<double>& lines, int parts) {
  std::vector<double> out{lines.front()};
  for (std::size_t k = 0; k + 1 < lines.size(); ++k)
    for (int i = 1; i <= parts; ++i)
      out.push_back(i == parts ? lines[k + 1] : lines[k] + (lines[k + 1] - lines[k]) * i / parts);
  return out;
}

}  // namespace

JoinSampling sampling_for(const JoinProblem& problem, const JoinCells& cells) {
  JoinProblem whole = problem;
  whole.mirror = {};
  const JoinLines lines = join_lines(whole, cells);
  JoinSampling sampling;
  sampling.vein = dense(lines.vein, 2 * cells.degree);
  sampling.artery = dense(lines.artery, 2 * cells.degree);
  return sampling;
}

JoinSolution solve_join(const JoinProblem& problem, const JoinCells& cells,
                        const JoinSampling& sampling, const StepperOptions& options,
                        const Processes& processes) {
  JoinSolution solution;
  const double start = now();
  JoinModel model(problem, cells, processes);
  solution.seen = model.load(problem, cells, processes);
  Supports supports;
  tie_seam(model, supports);
  hold_planes(problem, model, supports);
  const std::vector<ModelledEnd> ends = add_ends(problem, model, supports);
  System system(model.pair, std::move(supports), processes);
  if (problem.stressed()) system.start_from(system.rest());
  solution.unknowns = system.size();
  // the nodes at a part's two ends are on planes of symmetry, each shared by two parts
  solution.pairs = static_cast<int>(model.mesh.seam.size());
  if (problem.copies() > 1) solution.pairs = problem.copies() * (solution.pairs - 1);
  solution.mesh_seconds = now() - start;

  State state;
  System::Assembly assembly;
  solution.summary = follow_path(system, state, assembly, options);
  solution.summary.energy *= problem.copies();
  collect_forces(problem, model, ends, state, assembly, solution);
  const auto vein = state.u.head(model.vein.model->dof_count()),
             artery = state.u.tail(model.artery.model->dof_count());
  solution.vein =
      sample_tube(problem, problem.vein, model.mesh.vein, vein, sampling.vein, sampling);
  solution.artery = problem.other_rim ? sample_tube(problem, problem.artery, model.mesh.artery,
                                                    artery, sampling.artery, sampling)
                                      : sample_artery(problem, model.mesh.artery, artery, sampling);
  sample_seam(problem, model.mesh, vein, artery, sampling.seam, solution);
  return solution;
}

}  // namespace vasorod::fem
