// The outer loop of `coupled`: follow the path of motions and loads; at each time minimise, update the
// multipliers of seams, soft sections and contacts, find the closest features anew, until gaps are closed,
// nothing penetrates and forces balance. Bodies enter the unknowns when they are moved, joined or touched.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/triangle_surface.h"
#include "surface/paper_contacts.h"
#include "wall/coupled_minimiser.h"
#include "wall/coupled_problem.h"
#include "wall/coupled_report.h"
#include "wall/supports.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

constexpr double first_tolerance = 1e-4;  // while multipliers still move, a rough minimum is enough
constexpr double tolerance_step = 1e-2;
constexpr double finest_tolerance = 1e-13;
// After so many updates a contact that still opens and closes is accepted at ten times its tolerance.
constexpr int patience_with_contact = 40;
// So many minimisations in a row without a minimum end the solve.
constexpr int most_failures = 3;
// A step of the path moves the wall against its rod by a few percent of the radius; a kink by much more.
constexpr double jump = 0.2;
// On the path Newton's steps are bounded by this share of the radius: a soft direction would else carry over
// the low ridge between a smooth minimum and a kinked one.
constexpr double path_step = 0.02;
// Where a seam opens a slit, steps of part of an edge keep triangles from turning over, which the energy
// would not undo.
constexpr double seam_step = 0.3;

size_t index(Eigen::Index i) {
  return static_cast<size_t>(i);
}

}  // namespace

class CoupledSolver::Data {
 public:
  Data(CoupledProblem problem, const CoupledOptions& options)
      : options_(options), problem_(std::move(problem)) {
    if (problem_.vessels.size() != problem_.surfaces.bodies.size())
      throw InputError("found " + std::to_string(problem_.vessels.size()) + " walls for " +
                       std::to_string(problem_.surfaces.bodies.size()) + " bodies, expected one each");
    take_carried(problem_.carried(1));
    scaled_ = scale_bodies(problem_.surfaces);
    contacts_ = std::make_unique<PaperContacts>(problem_.surfaces, scaled_, options.contact_stiffness);
    energies_.resize(problem_.vessels.size());
    for (ScaledBody& body : scaled_.bodies) body.modelled = body.moved;
    for (size_t b = 0; b < problem_.vessels.size(); ++b)
      if (problem_.vessels[b])
        for (const HeldSection& section : problem_.vessels[b]->sections)
          body(b).modelled |= section.force != Vec3::Zero() || section.moment != Vec3::Zero() ||
                              section.body_moment != Vec3::Zero() || section.motion.move != Vec3::Zero() ||
                              section.motion.rotate != Vec3::Zero();
    for (const SeamPair& seam : problem_.surfaces.seams)
      for (const int b : {seam.body_a, seam.body_b}) body(index(b)).modelled = !body(index(b)).obstacle;
    seam_multipliers_.assign(problem_.surfaces.seams.size(), Vec3::Zero());
    seam_radius_ = seam_radius();
    check_supports(problem_, scaled_);
  }

  CoupledSolution solve() {
    start_ = std::chrono::steady_clock::now();
    solution_ = {};
    const bool any = std::any_of(scaled_.bodies.begin(), scaled_.bodies.end(),
                                 [](const ScaledBody& b) { return b.modelled; });
    if (any) {
      follow_path();
    } else {
      solution_.status = CoupledStatus::converged;
      solution_.smallest_curvature_positive = true;
      solution_.reached = 1;
    }
    report_coupled(problem_, scaled_, system_.get(), first_, first_wall_, z_, stacked_, *contacts_,
                   solution_);
    solution_.surface.seam_radius = seam_radius_ * scaled_.length;
    return std::move(solution_);
  }

  void set_sections(int b, const std::vector<HeldSection>& sections) {
    problem_.vessels[index(b)]->sections = sections;
    if (!system_ || first_wall_[index(b)] < 0) return;
    std::vector<HeldSection> mine;
    for (const HeldSection& s : sections) mine.push_back(scale(s));
    system_->set_sections(first_wall_[index(b)], mine);
  }

  void set_material(int b, const WallMaterial& material) {
    problem_.vessels[index(b)]->wall.material = material;
    energies_[index(b)].reset();
    if (!system_ || first_wall_[index(b)] < 0) return;
    system_->set_energy(first_wall_[index(b)], energy_of(index(b)));
    minimiser_->renew_rest();
  }

  void set_carried(std::function<std::vector<CarriedBody>(double)> carried) {
    problem_.carried = std::move(carried);
  }

  CoupledOptions options_;

 private:
  ScaledBody& body(size_t b) { return scaled_.bodies[b]; }

  // p' and rotations of the end of the path, as scale_bodies wants them.
  void take_carried(const std::vector<CarriedBody>& carried) {
    for (size_t b = 0; b < carried.size(); ++b) {
      problem_.surfaces.bodies[b].carried = carried[b].points;
      problem_.surfaces.bodies[b].rotations = carried[b].rotations;
    }
  }

  HeldSection scale(const HeldSection& section) const {
    return scaled(section, scaled_.length, scaled_.force(), scaled_.origin);
  }

  WallEnergy& energy_of(size_t b) {
    if (!energies_[b]) {
      WallInput wall = problem_.vessels[b]->wall;
      wall.rest = body(b).rest;
      wall.thickness /= scaled_.length;
      wall.mid_offset /= scaled_.length;
      for (double* modulus :
           {&wall.material.young_axial, &wall.material.young_transverse, &wall.material.shear_axial})
        *modulus /= scaled_.pressure();
      wall.name = "vessel " + problem_.surfaces.bodies[b].name;
      wall.glued.assign(index(wall.rest.points.rows()), 0);
      for (const HeldSection& section : problem_.vessels[b]->sections)
        if (section.rigid)
          for (const int v : section.ring) wall.glued[index(v)] = 1;
      energies_[b] = std::make_unique<WallEnergy>(wall);
    }
    return *energies_[b];
  }

  // Of the mouth: RMS distance of its rest vertices from their mean.
  double seam_radius() {
    const auto& seams = problem_.surfaces.seams;
    if (seams.empty()) return 0;
    Points mouth(static_cast<Eigen::Index>(seams.size()), 3);
    for (size_t i = 0; i < seams.size(); ++i)
      mouth.row(static_cast<Eigen::Index>(i)) =
          body(index(seams[i].body_a)).rest.points.row(seams[i].vertex_a);
    return std::sqrt((mouth.rowwise() - mouth.colwise().mean()).rowwise().squaredNorm().mean());
  }

  // The system of the modelled bodies. Positions are `now`.
  void build() {
    system_ = std::make_unique<CoupledSystem>();
    first_.assign(scaled_.bodies.size(), -1);
    first_wall_.assign(scaled_.bodies.size(), -1);
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      if (!body(b).modelled) continue;
      std::vector<HeldSection> sections;
      for (const HeldSection& section : problem_.vessels[b]->sections) sections.push_back(scale(section));
      first_[b] = system_->vertex_count();
      first_wall_[b] = system_->add_wall(energy_of(b), body(b).rest.points, sections,
                                         options_.tie_stiffness * body(b).k.stretching);
    }
    system_->finish();
    for (size_t i = 0; i < problem_.surfaces.seams.size(); ++i) {
      const SeamPair& seam = problem_.surfaces.seams[i];
      for (const int b : {seam.body_a, seam.body_b})
        system_->k_j =
            std::max(system_->k_j, options_.seam_stiffness *
                                       std::max(body(index(b)).k.bending, body(index(b)).k.stretching));
      system_->joins.push_back({first_[index(seam.body_a)] + seam.vertex_a,
                                first_[index(seam.body_b)] + seam.vertex_b, seam_multipliers_[i]});
    }
    stack_contacts();
    minimiser_ = std::make_unique<CoupledMinimiser>(*system_);
    z_.setZero(system_->unknowns());
  }

  Points scaled_points(const Points& p) const {
    return (p.rowwise() - scaled_.origin.transpose()) / scaled_.length;
  }

  struct Carried {
    std::vector<Points> points;
    std::vector<std::vector<Mat3>> rotations;
    std::vector<std::vector<Pose>> sections;
  };

  // Where the rods carry everything at time t, scaled, nothing empty.
  Carried carried_at(double t) {
    Carried all;
    const std::vector<CarriedBody> given = problem_.carried(t);
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      const CarriedBody& mine = given[b];
      all.points.push_back(mine.points.rows() > 0 ? scaled_points(mine.points) : body(b).rest.points);
      all.rotations.push_back(!mine.rotations.empty()
                                  ? mine.rotations
                                  : std::vector<Mat3>(index(body(b).rest.points.rows()), Mat3::Identity()));
      std::vector<Pose> poses = mine.sections;
      if (poses.empty() && problem_.vessels[b])
        for (const HeldSection& s : problem_.vessels[b]->sections)
          poses.push_back({Mat3::Identity(), s.rest.position});
      for (Pose& pose : poses) pose.position = (pose.position - scaled_.origin) / scaled_.length;
      all.sections.push_back(std::move(poses));
    }
    return all;
  }

  // The walls' state at a time, in the rods' frames: what the next time's start is extrapolated from.
  struct Local {
    double time = 0;
    std::vector<Points> deviation;  // per body: of the vertices, turned back
    std::vector<std::vector<Pose>> sections;
    VectorXd z;
  };

  Local local_state() {
    Local local;
    local.time = time_;
    local.z = z_;
    const CoupledState s = system_->state(z_);
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      local.deviation.emplace_back();
      local.sections.emplace_back();
      if (first_wall_[b] < 0) continue;
      Points& d = local.deviation.back();
      d = body(b).now - carried_.points[b];
      for (Eigen::Index i = 0; i < d.rows(); ++i)
        d.row(i) = (d.row(i) * carried_.rotations[b][index(i)]).eval();
      for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
        const Pose& rod = carried_.sections[b][k];
        const SectionPlacement& at = s.placements[index(first_wall_[b])][k];
        local.sections.back().push_back({rod.rotation.transpose() * at.rotation,
                                         rod.rotation.transpose() * (at.position - rod.position)});
      }
    }
    return local;
  }

  // The walls' start at a time of the path: where the rods carry what the walls had against them at the last
  // times, extrapolated. False at the first time, where there is none.
  bool advance(double t) {
    const bool first = carried_.points.empty();
    const std::optional<Local> before = std::move(last_);
    if (first)
      last_.reset();
    else
      last_ = local_state();
    const bool line = before && last_ && before->z.size() == last_->z.size() && last_->time > before->time;
    const double along = line ? (t - last_->time) / (last_->time - before->time) : 0;
    time_ = t;
    carried_ = carried_at(t);
    system_->set_time(t);
    if (line) z_ = last_->z + along * (last_->z - before->z);
    std::vector<Mat3> frames(index(system_->vertex_count()));
    std::vector<std::vector<Mat3>> section_frames;
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      const int w = first_wall_[b];
      if (w < 0) continue;
      Points x = carried_.points[b];
      for (Eigen::Index i = 0; i < x.rows(); ++i) {
        const Mat3& r = carried_.rotations[b][index(i)];
        frames[index(first_[b] + i)] = r;
        if (first) continue;
        Vec3 deviation = last_->deviation[b].row(i);
        if (line) deviation += along * (last_->deviation[b].row(i) - before->deviation[b].row(i)).transpose();
        x.row(i) += (r * deviation).transpose();
      }
      system_->put(w, x, !first, z_);
      section_frames.emplace_back();
      for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
        Pose pose = carried_.sections[b][k];
        section_frames.back().push_back(pose.rotation);
        if (t < 1) system_->set_target(w, static_cast<int>(k), pose);
        if (!first) pose = pose * last_->sections[b][k];
        system_->put_pose(w, static_cast<int>(k), pose.rotation, pose.position, z_);
      }
    }
    minimiser_->set_turns(system_->turns(frames, section_frames));
    unstack();
    return !first;
  }

  void stack_contacts() {
    stacked_ = contacts_->stacked(scaled_, first_);
    system_->contacts = stacked_.points;
  }

  void unstack() {
    const Points positions = system_->state(z_).positions;
    for (size_t b = 0; b < scaled_.bodies.size(); ++b)
      if (first_[b] >= 0) body(b).now = positions.middleRows(first_[b], body(b).now.rows());
  }

  // New bodies join the unknowns; those there keep what they have.
  void rebuild() {
    const std::unique_ptr<CoupledSystem> old = std::move(system_);
    const std::unique_ptr<CoupledMinimiser> old_minimiser = std::move(minimiser_);
    const std::vector<int> old_wall = first_wall_;
    const CoupledState before = old->state(z_);
    build();
    system_->set_time(time_);
    std::vector<Mat3> frames(index(system_->vertex_count()));
    std::vector<std::vector<Mat3>> section_frames;
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      const int w = first_wall_[b];
      if (w < 0) continue;
      std::copy(carried_.rotations[b].begin(), carried_.rotations[b].end(), frames.begin() + first_[b]);
      system_->put(w, body(b).now, false, z_);
      if (old_wall[b] >= 0) system_->put_edges(w, before.q[index(old_wall[b])], z_);
      section_frames.emplace_back();
      for (size_t k = 0; k < carried_.sections[b].size(); ++k) {
        Pose pose = carried_.sections[b][k];
        section_frames.back().push_back(pose.rotation);
        if (old_wall[b] >= 0) {
          const SectionPlacement& was = before.placements[index(old_wall[b])][k];
          pose = {was.rotation, was.position};
        }
        system_->put_pose(w, static_cast<int>(k), pose.rotation, pose.position, z_);
      }
    }
    minimiser_->set_turns(system_->turns(frames, section_frames));
  }

  bool keep_going(int iteration, double residual) {
    if (options_.time_limit > 0 &&
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() >
            options_.time_limit)
      return false;
    return !options_.keep_going || options_.keep_going({solution_.surface.outer_iterations,
                                                        solution_.surface.iterations + iteration, residual});
  }

  double largest_seam_gap() const {
    double largest = 0;
    if (system_->joins.empty()) return 0;
    const Points positions = system_->state(z_).positions;
    for (const Join& join : system_->joins)
      largest = std::max(largest, (positions.row(join.a) - positions.row(join.b)).norm());
    return largest;
  }

  void follow_path() {
    if (!system_) build();
    carried_ = {};
    last_.reset();
    bool buckled = false;
    for (const double t : options_.times) {
      const bool stepped = advance(t);
      const Points predicted = system_->state(z_).positions;
      const CoupledStatus status = settle(stepped);
      buckled |= left_saddle_;
      if (stepped && predicted.rows() == system_->vertex_count() &&
          (system_->state(z_).positions - predicted).rowwise().norm().maxCoeff() > jump * ring_radius())
        buckled = true;
      solution_.status = status;
      if (status != CoupledStatus::converged && status != CoupledStatus::equilibrium_only) return;
      solution_.reached = t;
    }
    if (buckled) {
      solution_.status = CoupledStatus::buckled;
      solution_.notes.push_back(
          "the smooth branch from rest lost its stability on the way; the result is the minimum below it");
    }
  }

  // Smallest RMS radius of the sections' rings.
  double ring_radius() const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const CoupledWall& wall : system_->walls())
      for (const SectionPose& pose : wall.sections) {
        const std::vector<int>& ring = pose.section().ring;
        Points points(static_cast<Eigen::Index>(ring.size()), 3);
        for (size_t i = 0; i < ring.size(); ++i)
          points.row(static_cast<Eigen::Index>(i)) = wall.rest.row(ring[i]);
        smallest = std::min(
            smallest, std::sqrt((points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().mean()));
      }
    return smallest;
  }

  // The minimum at the present time. `stepped`: from a start extrapolated along the path; the true Hessian
  // keeps to its branch where K0's longer steps may leave it.
  CoupledStatus settle(bool stepped) {
    left_saddle_ = false;
    const auto& surfaces = problem_.surfaces;
    const bool meets = !surfaces.seams.empty() || !surfaces.contacts.empty();
    CoupledMinimiserOptions inner;
    inner.max_iterations = options_.max_iterations;
    inner.max_factorisations = options_.max_factorisations;
    inner.keep_going = [this](int iteration, double, double residual) {
      return keep_going(iteration, residual);
    };
    if (stepped) {
      inner.per_hessian = 3;
      inner.largest_step = path_step * ring_radius();
      inner.release_step = true;
    } else if (!surfaces.seams.empty())
      inner.largest_step = seam_step;
    const bool alone = surfaces.seams.empty() && !system_->has_ties();
    const bool steps = meets || system_->has_ties();
    double tolerance = steps ? std::max(first_tolerance, options_.tolerance) : options_.tolerance;
    int failures = 0;
    VectorXd best;  // the last minimum found, with the unknowns of now
    for (int outer = 1;; ++outer) {
      ++solution_.surface.outer_iterations;
      inner.tolerance = tolerance;
      inner.use_rest = !stepped && alone && outer == 1 && system_->contacts.empty();
      inner.reuse_hessian = outer > 1 && !contacts_->pressing();
      inner.certify = options_.certify && tolerance <= options_.tolerance;
      const CoupledMinimiserSummary summary = minimiser_->minimise(z_, inner);
      solution_.surface.iterations += summary.iterations;
      solution_.rest_iterations += summary.rest_iterations;
      solution_.surface.factorisations += summary.factorisations;
      solution_.surface.residual = summary.residual;
      solution_.smallest_curvature_positive = summary.positive;
      left_saddle_ |= summary.left_saddle;
      const bool minimum = summary.status == LbfgsStatus::converged;
      failures = minimum ? 0 : failures + 1;
      if (minimum || best.size() != z_.size()) best = z_;
      if (failures > most_failures) z_ = best;
      unstack();
      if (summary.status == LbfgsStatus::interrupted) return CoupledStatus::interrupted;
      const double moment_change = system_->recentre(z_);
      const bool at_rest = summary.residual <= options_.tolerance || summary.status == LbfgsStatus::stalled;
      const bool seam_closed = largest_seam_gap() <= options_.seam_tolerance * seam_radius_;
      const bool tied = system_->worst_tie(z_) <= options_.tie_tolerance;
      const bool turned = moment_change <= options_.moment_tolerance * system_->largest_moment();
      const ContactState contact = contacts_->refresh(scaled_);
      const double slackness = outer > patience_with_contact ? 10 : 1;
      const bool pressed_right = contact.touched.empty() &&
                                 contact.penetration <= slackness * options_.contact_tolerance &&
                                 contact.force_change <= slackness * options_.pressure_tolerance;
      const bool good = at_rest && seam_closed && tied && turned && pressed_right;
      if (good && (tolerance <= finest_tolerance || summary.status == LbfgsStatus::stalled ||
                   worst_coupled_balance(scaled_, *system_, first_wall_, z_) <= options_.balance_tolerance)) {
        if (options_.certify && !summary.positive) {
          if (tolerance > options_.tolerance) {
            tolerance = options_.tolerance;
            continue;
          }
          return CoupledStatus::unstable;
        }
        return system_->has_potential() ? CoupledStatus::converged : CoupledStatus::equilibrium_only;
      }
      if (outer >= options_.max_outer || failures > most_failures ||
          (summary.status == LbfgsStatus::iteration_limit && tolerance <= options_.tolerance && !steps))
        return CoupledStatus::iteration_limit;
      if (!seam_closed) {
        update_join_multipliers(system_->k_j, system_->joins, system_->state(z_).positions);
        for (size_t i = 0; i < system_->joins.size(); ++i)
          seam_multipliers_[i] = system_->joins[i].multiplier;
      }
      if (!tied) system_->update_ties(z_);
      const double least = good ? finest_tolerance : options_.tolerance;
      if (summary.residual <= tolerance) tolerance = std::max(least, tolerance * tolerance_step);
      if (!contact.touched.empty()) {
        for (const int b : contact.touched) body(index(b)).modelled = true;
        check_supports(problem_, scaled_);
        rebuild();
      } else {
        stack_contacts();
      }
    }
  }

  CoupledProblem problem_;
  std::chrono::steady_clock::time_point start_;
  ScaledBodies scaled_;
  std::unique_ptr<PaperContacts> contacts_;
  std::vector<std::unique_ptr<WallEnergy>> energies_;
  std::vector<Vec3> seam_multipliers_;
  double seam_radius_ = 0, time_ = 0;
  bool left_saddle_ = false;
  std::unique_ptr<CoupledSystem> system_;
  std::unique_ptr<CoupledMinimiser> minimiser_;
  StackedContacts stacked_;
  std::vector<int> first_, first_wall_;  // of each body, -1: not among the unknowns
  Carried carried_;                      // at the present time
  std::optional<Local> last_;            // at the time before
  VectorXd z_;
  CoupledSolution solution_;
};

CoupledSolver::CoupledSolver(CoupledProblem problem, const CoupledOptions& options)
    : data_(std::make_unique<Data>(std::move(problem), options)) {}
CoupledSolver::~CoupledSolver() = default;
CoupledSolution CoupledSolver::solve() {
  return data_->solve();
}
void CoupledSolver::set_sections(int body, const std::vector<HeldSection>& sections) {
  data_->set_sections(body, sections);
}
void CoupledSolver::set_carried(std::function<std::vector<CarriedBody>(double)> carried) {
  data_->set_carried(std::move(carried));
}
void CoupledSolver::set_material(int body, const WallMaterial& material) {
  data_->set_material(body, material);
}
CoupledOptions& CoupledSolver::options() {
  return data_->options_;
}

std::string to_string(CoupledStatus status) {
  switch (status) {
    case CoupledStatus::converged:
      return "converged";
    case CoupledStatus::equilibrium_only:
      return "equilibrium_only";
    case CoupledStatus::unstable:
      return "unstable";
    case CoupledStatus::buckled:
      return "buckled";
    case CoupledStatus::iteration_limit:
      return "iteration_limit";
    case CoupledStatus::interrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace vasorod
