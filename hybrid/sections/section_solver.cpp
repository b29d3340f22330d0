#include "sections/section_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <vasorod/error.h>

#include "coupled/free_motions.h"
#include "data/index.h"
#include "data/sentence.h"
#include "numerics/blas.h"
#include "sections/section_newton.h"
#include "sections/section_prestress.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The first space: harmonics, and spans per radius of length. From space to space there are more
// spans, and more harmonics where the highest ones still move the wall by a share of the error that
// is asked for: an axisymmetric state has none of them, however steep it is beside an end.
constexpr int first_harmonics = 3, more_harmonics = 2, most_harmonics = 13;
constexpr double first_spans = 1, more_spans = 1.5;
constexpr int least_spans = 6, most_spaces = 7, most_beginnings = 3;
constexpr double noticed = 0.2;
constexpr double longest = 300;  // in radii
// A shape that is not yet the last is minimised to this residual.
constexpr double rough = 1e-6;
// With one difference of two spaces, the finer one's error is taken as this share of it; with more,
// as what remains of a geometric series whose ratio is not trusted outside these bounds.
constexpr double first_share = 0.25, least_ratio = 0.1, largest_ratio = 0.8;
// Past this estimate, the sections do not resolve what happens.
constexpr double unresolved = 1e-3;
// A tube's rest shape needs few functions; of an irregular one the mesh resolves no more than these
// shares of its vertices around and along: a span beside an end is half as long as the others.
constexpr int most_fitted_harmonics = 10;
constexpr double harmonics_per_vertex = 1.0 / 3, spans_per_row = 0.4, fitted_spans_per_radius = 2.5;
constexpr int most_recentres = 50;
// A step of the path or a finer space moves the wall by a few percent of the radius; a kink moves
// it much farther.
constexpr double jump = 0.2;

// The problem with lengths over the radius about its middle, and moduli over the largest.
struct Scaled {
  double length, stress;
  Vec3 origin;
  SectionProblem problem;

  explicit Scaled(const SectionProblem& given)
      : length(given.radius),
        stress(std::max(given.material.young_axial, given.material.young_transverse)),
        origin(given.rest.colwise().mean().transpose()),
        problem(given) {
    problem.rest = (given.rest.rowwise() - origin.transpose()) / length;
    problem.thickness /= length;
    problem.mid_offset /= length;
    problem.radius = 1;
    problem.length /= length;
    problem.material.young_axial /= stress;
    problem.material.young_transverse /= stress;
    problem.material.shear_axial /= stress;
    problem.pressure.scan /= stress;
    problem.pressure.after /= stress;
    for (auto& end : problem.ends)
      if (end) end = scaled(*end, length, force(), origin);
    problem.start = [start = given.start, size = length, from = origin](double t) {
      SectionProblem::Start at = start(t);
      at.points = (at.points.rowwise() - from.transpose()) / size;
      for (Pose& pose : at.poses) pose.position = (pose.position - from) / size;
      return at;
    };
  }
  double force() const { return stress * length * length; }
  double energy() const { return force() * length; }
  Vec3 unscaled(const Vec3& place) const { return place * length + origin; }
};

// The vertices' offsets from the fitted surface at rest, in the surface's frames.
class CarriedVertices {
 public:
  CarriedVertices(const SectionProblem& problem, const SectionShape& rest) : at_(problem.at) {
    const Points on_shape = points_of(rest, at_);
    const Points apart = problem.rest - on_shape;
    rms_ = std::sqrt(apart.rowwise().squaredNorm().mean());
    // Rounding is not carried.
    if (rms_ < 1e-9) return;
    local_.resize(apart.rows(), 3);
    for (Eigen::Index p = 0; p < apart.rows(); ++p)
      local_.row(p) = apart.row(p) * surface_frame(rest.jet(at_.u[p], at_.angle[p]));
  }
  double rms() const { return rms_; }
  Points positions(const SectionShape& now) const {
    Points points = points_of(now, at_);
    for (Eigen::Index p = 0; p < local_.rows(); ++p)
      points.row(p) += local_.row(p) * surface_frame(now.jet(at_.u[p], at_.angle[p])).transpose();
    return points;
  }

 private:
  const SectionParameters& at_;
  Points local_;
  double rms_ = 0;
};

// Thickness at u: the mean of the vertices there.
std::function<double(double)> thickness_along(const SectionProblem& problem,
                                              const SectionOptions& options) {
  const double least = problem.thickness.minCoeff(), largest = problem.thickness.maxCoeff();
  if (largest - least <= 1e-12 * largest) return [largest](double) { return largest; };
  const SectionSpace space{
      0, AxialBasis(std::max(least_spans, static_cast<int>(problem.length)), options.degree)};
  Points values = Points::Zero(problem.thickness.size(), 3);
  values.col(0) = problem.thickness;
  const SectionShape fitted = fit_sections(space, problem.at, values);
  return [fitted](double u) { return fitted.point(u, 0)[0]; };
}

double rms_between(const Points& a, const Points& b) {
  return std::sqrt((a - b).rowwise().squaredNorm().mean());
}

class Solver {
 public:
  Solver(const SectionProblem& problem, const SectionOptions& options)
      : scaled_(problem), options_(options) {
    const SectionProblem& mine = scaled_.problem;
    const auto around = static_cast<double>(
        std::count_if(mine.at.u.begin(), mine.at.u.end(), [](double u) { return u == 0; }));
    const auto rows = static_cast<double>(mine.rest.rows()) / std::max(around, 1.0);
    const int fitted_harmonics = std::clamp(static_cast<int>(harmonics_per_vertex * around), 1,
                                            most_fitted_harmonics),
              fitted_spans = std::clamp(static_cast<int>(spans_per_row * rows), 1,
                                        spans_of(fitted_spans_per_radius));
    fit_ = fit_sections({fitted_harmonics, AxialBasis(fitted_spans, options.degree)}, mine.at,
                        mine.rest);
    wall_.thickness = thickness_along(mine, options);
    wall_.mid_offset = mine.mid_offset;
    wall_.material = mine.material;
  }

  SolvedSections solve() {
    Points before;
    std::vector<double> changes;
    solution_.error = std::numeric_limits<double>::infinity();
    int harmonics = first_harmonics;
    double spans = first_spans;
    SectionShape now;
    std::array<Pose, 2> poses;
    for (int k = 1;; ++k) {
      const SectionSpace space{harmonics, AxialBasis(spans_of(spans), options_.degree)};
      std::optional<SectionSystem> system;
      kept_.reset();
      VectorXd z;
      bool good = true;
      const int indefinite = indefinite_;
      if (before.rows() == 0) {
        prepare(space, system);
        good = follow_path(*system, z);
      } else {
        // Displacements are carried from space to space, so that each has its own shape at rest.
        SectionShape moved = now;
        moved.coefficients -= in_space(fit_, now.space).coefficients;
        prepare(space, system);
        system->set_time(1);
        z = system->unknowns_of(wall_.rest.coefficients + in_space(moved, space).coefficients,
                                poses);
        good = minimise(*system, z, rough);
      }
      // A space may be too coarse for its own shape at rest.
      if (!good && before.rows() == 0 && k < most_beginnings &&
          newton_ != SectionNewtonStatus::interrupted) {
        harmonics += more_harmonics;
        spans *= more_spans;
        continue;
      }
      now.space = space;
      const CarriedVertices vertices(scaled_.problem, wall_.rest);
      now.coefficients = system->coefficients(z);
      Points here = vertices.positions(now);
      const double tail = highest_harmonics(now);
      const bool more_around = tail > noticed * options_.error && harmonics < most_harmonics;
      if (good && before.rows() > 0) {
        changes.push_back(rms_between(here, before));
        buckled_ |= indefinite_ > indefinite && (here - before).rowwise().norm().maxCoeff() > jump;
        solution_.error = estimate(changes) + tail;
      }
      const bool last = k == most_spaces || solution_.error <= options_.error || !good;
      if (last) {
        if (good) {
          good = minimise(*system, z, options_.tolerance);
          now.coefficients = system->coefficients(z);
          here = vertices.positions(now);
        }
        finish(*system, z, here, vertices, good);
        return std::move(solution_);
      }
      if (more_around) harmonics = std::min(harmonics + more_harmonics, most_harmonics);
      spans *= more_spans;
      before = here;
      poses = poses_of(*system, z);
    }
  }

 private:
  int spans_of(double per_radius) const {
    return std::max(least_spans,
                    static_cast<int>(std::round(per_radius * scaled_.problem.length - 1e-6)));
  }

  // The wall at rest in a space, with the stress that it was seen with.
  void prepare(const SectionSpace& space, std::optional<SectionSystem>& system) {
    const SectionProblem& mine = scaled_.problem;
    wall_.rest = in_space(fit_, space);
    system.emplace(wall_, mine.ends);
    system->set_lumen(mine.pressure);
    if (mine.pressure.scan == 0 && mine.axial_prestretch == 1) return;
    const auto largest = [&](const MatrixXd& displacement) {
      return points_of(SectionShape{space, displacement}, mine.at).rowwise().norm().maxCoeff();
    };
    // In all spaces in the same way, that of the first; linear from one on where no shape is found.
    const SeenSections seen =
        seen_sections(wall_, mine.ends, mine.pressure.scan, mine.axial_prestretch, mine.name,
                      largest_linear_, [this] { return stop_(); });
    largest_linear_ = seen.steps > 0 ? 0 : std::numeric_limits<double>::infinity();
    solution_.prestress_displacement = largest(seen.displacement);
    if (seen.steps) solution_.prestress_steps = seen.steps;
    give_prestress(seen, mine.axial_prestretch, *system);
  }

  static std::array<Pose, 2> poses_of(const SectionSystem& system, const VectorXd& z) {
    std::array<Pose, 2> poses;
    const auto at = system.gradient(z);
    for (int e = 0; e < 2; ++e)
      if (const auto wrench = system.wrench(e, z, at))
        poses[index(e)] = {wrench->rotation, wrench->center};
    return poses;
  }

  // The minimum at the path's end in one space. Each step begins at the minimum before, moved as
  // the start moves.
  bool follow_path(SectionSystem& system, VectorXd& z) {
    const auto start_at = [&](double t) {
      const SectionProblem::Start start = scaled_.problem.start(t);
      const SectionShape moved =
          fit_sections(system.space(), scaled_.problem.at, start.points - scaled_.problem.rest);
      return std::pair(MatrixXd(wall_.rest.coefficients + moved.coefficients), start.poses);
    };
    MatrixXd ahead, before;
    for (const double t : scaled_.problem.times) {
      const auto [start, poses] = start_at(t);
      const MatrixXd from = before.size() > 0 ? MatrixXd(ahead + start - before) : start;
      system.set_time(t);
      z = system.unknowns_of(from, poses);
      const int indefinite = indefinite_;
      if (!minimise(system, z, rough)) return false;
      ahead = system.coefficients(z);
      buckled_ |= before.size() > 0 && indefinite_ > indefinite &&
                  (ahead - from).cwiseAbs().maxCoeff() > jump;
      before = start;
    }
    return true;
  }

  // RMS displacement in the highest two harmonics, over the radius.
  double highest_harmonics(const SectionShape& now) const {
    const int modes = now.space.modes();
    const MatrixXd moved = now.coefficients - wall_.rest.coefficients;
    double square = 0;
    for (int c = 0; c < 3; ++c)
      square += moved.middleRows((c + 1) * modes - 4, 4).squaredNorm() / 2;
    return std::sqrt(square / static_cast<double>(moved.cols()));
  }

  static double estimate(const std::vector<double>& changes) {
    const double last = changes.back();
    if (changes.size() == 1) return first_share * last;
    const double ratio = std::clamp(last / changes[changes.size() - 2], least_ratio, largest_ratio);
    return last * ratio / (1 - ratio);
  }

  // Minimises, and again while the moment of a turning load changes with the end's rotation.
  bool minimise(SectionSystem& system, VectorXd& z, double tolerance) {
    SectionNewtonOptions newton;
    newton.stop = [this] { return stop_(); };
    newton.progress = options_.progress;
    newton.tolerance = tolerance;
    newton.max_iterations = options_.max_iterations;
    for (int turn = 0; turn < most_recentres; ++turn) {
      const SectionNewtonSummary summary =
          minimise_sections(system, z, newton, kept_, solution_.work);
      ++solution_.work.counts.outer;
      solution_.iterations += summary.iterations;
      solution_.residual = summary.residual;
      if (summary.positive) positive_ = summary.positive;
      indefinite_ += summary.indefinite;
      newton_ = summary.status;
      if (newton_ != SectionNewtonStatus::converged) return false;
      if (system.recentre(z) <= options_.moment_tolerance * largest_moment(system, z)) return true;
    }
    return false;
  }

  double largest_moment(const SectionSystem& system, const VectorXd& z) const {
    const auto at = system.gradient(z);
    double largest = 1e-300;
    for (int e = 0; e < 2; ++e)
      if (const auto wrench = system.wrench(e, z, at))
        largest = std::max(largest, wrench->moment.norm());
    return largest;
  }

  Status status_of(const SectionSystem& system, bool good) const {
    if (newton_ == SectionNewtonStatus::interrupted) return Status::interrupted;
    if (!good || solution_.error > unresolved) return Status::iteration_limit;
    if (!solution_.smallest_curvature_positive) return Status::unstable;
    if (buckled_) return Status::buckled;
    return system.has_potential() ? Status::converged : Status::equilibrium_only;
  }

  void finish(SectionSystem& system, const VectorXd& z, const Points& positions,
              const CarriedVertices& vertices, bool good) {
    const auto at = system.gradient(z);
    if (!positive_) positive_ = system.hessian(z, at).factorise();  // nothing moved
    solution_.smallest_curvature_positive = *positive_;
    solution_.positions = (positions * scaled_.length).rowwise() + scaled_.origin.transpose();
    solution_.report = system.energy().report(system.coefficients(z));
    solution_.report.membrane *= scaled_.energy();
    solution_.report.bending *= scaled_.energy();
    for (Vec3* place : {&solution_.report.least_place, &solution_.report.largest_place})
      *place = scaled_.unscaled(*place);
    double largest = 0;
    for (int e = 0; e < 2; ++e) {
      const Vec3 lid = system.carried_lid(e, z);
      solution_.lumen -= lid;
      largest = std::max(largest, lid.norm());
    }
    Vec3 sum = solution_.lumen;
    solution_.lumen *= scaled_.force();
    for (int e = 0; e < 2; ++e) {
      auto& end = solution_.ends[index(e)];
      end = system.wrench(e, z, at);
      if (!end) continue;
      sum += end->force;
      largest = std::max(largest, end->force.norm());
      end->force *= scaled_.force();
      end->load *= scaled_.force();
      end->moment *= scaled_.energy();
      end->center = scaled_.unscaled(end->center);
    }
    // Forces below the rounding of what they are sums of are none.
    solution_.balance = largest > 1e-12 * std::max(at.size, 1e-300) ? sum.norm() / largest : 0;
    solution_.harmonics = system.space().harmonics;
    solution_.spans = system.space().along.spans();
    solution_.fit_error = vertices.rms();
    solution_.status = status_of(system, good);
    add_notes(good);
  }

  void add_notes(bool good) {
    const std::string& name = scaled_.problem.name;
    if (good && buckled_)
      solution_.notes.push_back("the smooth branch of " + name +
                                " from rest lost its stability on the way; the result is the "
                                "minimum below it");
    const std::string size = std::to_string(solution_.harmonics) + " harmonics around and " +
                             std::to_string(solution_.spans) + " spans along";
    if (!good && newton_ != SectionNewtonStatus::interrupted) {
      solution_.notes.push_back("no minimum of the sections of " + name + " was found with " +
                                size + ": fidelity coupled follows the path of the motion");
    } else if (good && solution_.error > options_.error) {
      solution_.notes.push_back("the sections of " + name + " are not resolved: with " + size +
                                " the estimated error is " + number_text(solution_.error, 2) +
                                " of the radius, expected " + number_text(options_.error, 2) +
                                ": fidelity coupled takes what harmonics do not");
    }
    if (good && !solution_.smallest_curvature_positive)
      solution_.notes.push_back("the sections of " + name +
                                " are at an equilibrium with a direction of negative curvature: "
                                "fidelity coupled finds the minimum below it");
  }

  Scaled scaled_;
  SectionOptions options_;
  StopCheck stop_{options_};
  SectionShape fit_;  // at rest
  SectionWall wall_;
  SectionNewtonStatus newton_ = SectionNewtonStatus::converged;
  std::optional<bool> positive_;    // of the last Hessian
  std::optional<BandMatrix> kept_;  // the present system's last factor
  int indefinite_ = 0;              // Newton steps from a negative curvature
  double largest_linear_ = options_.linear_prestrain_up_to;  // of the next space
  bool buckled_ = false;  // the minimum jumped on the path, or from a space to the next
  SolvedSections solution_;
};

}  // namespace

std::optional<std::string> SectionOptions::is_invalid() const {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  return first_fault({
      {positive(error), "error: expected a number above 0"},
      {positive(tolerance), "tolerance: expected a number above 0"},
      {positive(moment_tolerance), "moment_tolerance: expected a number above 0"},
      {max_iterations >= 1, "max_iterations: expected at least 1"},
      {degree >= 3 && degree <= 7, "degree: expected 3 to 7"},
  });
}

SolvedSections solve_sections(const SectionProblem& problem, const SectionOptions& options) {
  if (const auto fault = options.is_invalid()) throw InputError("options of section: " + *fault);
  std::vector<HeldSection> sections;
  for (const auto& end : problem.ends)
    if (end) sections.push_back(*end);
  check_free_motions(problem.name, problem.rest, sections);
  // The last space of a longer vessel would take gigabytes.
  if (!(problem.length <= longest * problem.radius))
    throw InputError("vessel " + problem.name + ": fidelity section: found a vessel of " +
                     number_text(problem.length / problem.radius, 3) + " radii, expected at most " +
                     number_text(longest) + ": fidelity coupled takes longer ones");
  const OneCholmodThread one_thread;  // of the BLAS
  return Solver(problem, options).solve();
}

}  // namespace vasorod
