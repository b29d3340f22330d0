#include "predict/coupled_attempt.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "data/index.h"
#include "numerics/threads.h"
#include "paper/joined_skin.h"
#include "predict/coarse_start.h"
#include "predict/joining_path.h"
#include "predict/kept_state.h"
#include "predict/name_crossings.h"
#include "predict/path_rule.h"
#include "predict/surface_bodies.h"
#include "predict/vessel_wall.h"
#include "predict/walls_means.h"

namespace vasorod {
namespace {

// From a closed start, walls that find their minimum take some ten to thirty updates of
// multipliers.
constexpr int updates_from_closed = 40;
// Factorisations. Walls of the study's shunts that can be parted, joined inflated or let out are so
// in fewer; others go on without end, and to try something else is cheaper.
constexpr int most_per_stage = 150;
// Of coarse walls: on the residual; on gaps of the seam and imbalances; on changes of pressures; on
// penetrations and slips over the edge.
constexpr double coarse_tolerance = 1e-4, coarse_share = 1e-2, coarse_change = 0.1,
                 coarse_length = 0.05;
// Of a vein that folds: contacts that are still found differently after this many updates stick.
constexpr int hold_after = 6;

// A seam's start is closed: a linear solve of the paper's quadratic energies, added to `work`,
// deforms the carried sections as little as possible.
void start_closed(const Prediction& prediction, const std::vector<VesselSections>& sections,
                  CoupledProblem& problem, Work& work) {
  std::vector<Points> joined;
  if (prediction.operation) joined = joined_skin(problem.surfaces, &work);
  problem.carried = [&prediction, &sections, joined](double t) {
    std::vector<CarriedBody> bodies = carried_by_rods(prediction, sections, t, nullptr);
    for (size_t v = 0; v < joined.size(); ++v)
      if (!prediction.vessels[v].prepared.obstacle()) bodies[v].points = joined[v];
    return bodies;
  };
}

// The pressure in both vessels by which the hoop strain of the one that yields more becomes
// `strain`, stress.
double pressure_for(const Prediction& prediction, double strain) {
  double least = std::numeric_limits<double>::infinity();
  for (const OperatedVessel& joined : prediction.operation->vessels) {
    const PreparedVessel& vessel =
        prediction.vessels[vessel_named(prediction, joined.name)].prepared;
    least = std::min(least, strain * vessel.spec.wall->material.young_transverse *
                                vessel.thickness() / vessel.vessel.mean_radius);
  }
  return least;
}

void inflate(const Prediction& prediction, double pressure, CoupledProblem& problem) {
  for (const OperatedVessel& joined : prediction.operation->vessels)
    problem.vessels[vessel_named(prediction, joined.name)]->inflation = pressure;
}

// The vein starts at rest, where nothing passes through it, and goes to its seam.
void go_from_rest(const Prediction& prediction, const std::vector<VesselSections>& sections,
                  CoupledProblem& problem) {
  const auto way = std::make_shared<const JoiningPath>(prediction);
  problem.seam_way = start_at_rest(prediction, way, problem.surfaces);
  problem.carried = [&prediction, &sections, way](double t) {
    return carried_by_rods(prediction, sections, t, way.get());
  };
}

CoupledProblem problem_of(const Prediction& prediction, std::vector<VesselSections>& sections) {
  sections.clear();
  CoupledProblem problem;
  problem.surfaces = body_problem(prediction);
  // Beside a seam the walls meet as they are sewn, and its start may lie through itself.
  if (!prediction.operation)
    for (const auto& itself : self_contacts(problem.surfaces.bodies))
      problem.surfaces.contacts.push_back(itself);
  for (const PredictedVessel& vessel : prediction.vessels) {
    sections.emplace_back();
    problem.vessels.emplace_back();
    if (vessel.prepared.obstacle()) continue;
    sections.back() =
        sections_of(vessel.prepared.vessel, vessel.conditions, mouth_of(prediction, vessel));
    problem.vessels.back() = std::make_unique<CoupledVessel>(CoupledVessel{
        wall_of(vessel.prepared), sections.back().sections, vessel.prepared.spec.pressure});
  }
  return problem;
}

void take(CoupledSolution&& solution, const std::vector<VesselSections>& sections,
          Prediction& prediction) {
  SolvedSurfaces surfaces;
  surfaces.solution = std::move(solution.surface);
  surfaces.solution.status = solution.status;
  surfaces.smallest_curvature_positive = solution.smallest_curvature_positive;
  surfaces.notes = solution.notes;
  surfaces.terms = {"bending", "stretching"};
  for (const PredictedVessel& vessel : prediction.vessels)
    if (vessel.prepared.spec.pressure) surfaces.terms.emplace_back("pressure");
  surfaces.carry_everything = true;
  surfaces.faces = solution.faces;
  for (size_t v = 0; v < prediction.vessels.size(); ++v) {
    Vec3& load = surfaces.load.emplace_back(Vec3::Zero());
    for (const SectionSolution& section : solution.sections[v]) {
      load += section.load;
      if (!section.label.empty())
        surfaces.ends.push_back({prediction.vessels[v].prepared.spec.name, section.label,
                                 section.force, section.moment, section.center});
    }
  }
  take_surfaces(std::move(surfaces), "wall", prediction);
  prediction.left_out["energy of the rods"] =
      "fidelity coupled: the walls carry all of it; the rods are start, frames and report";
  give_rods_the_walls_means(prediction, sections, solution.sections);
}

// Sets a flag at the end of its life, whatever ends it.
struct Abandoned {
  std::atomic<bool>& flag;
  ~Abandoned() { flag = true; }
};

}  // namespace

bool is_minimum(Status status) {
  return status == Status::converged || status == Status::buckled || status == Status::not_unique ||
         status == Status::equilibrium_only;
}

bool leaves_out_contact(const Prediction& prediction) {
  return prediction.scene->contact && prediction.scene->contact->empty();
}

CoupledAttempt::CoupledAttempt(Prediction& prediction, const SolveOptions& options, Walls walls)
    : prediction_(prediction), options_(options) {
  coupled_.times = path_times(prediction);
  coupled_.stop = options.stop;
  const std::string name = walls == Walls::coarse ? "coarse walls" : "walls";
  coupled_.step = step_progress(name, options);
  coupled_.progress = iteration_progress(name, 10, options);
  if (walls == Walls::coarse) {
    only_for_a_start();
    return;
  }
  coupled_.keep = keep_for<CoupledSolution>(prediction, options,
                                            [this](CoupledSolution&& so_far, Prediction& state) {
                                              take(std::move(so_far), sections_, state);
                                            });
}

std::optional<CoupledSolution> CoupledAttempt::from_coarse() {
  std::optional<Prediction> coarse = coarse_prediction(prediction_, options_);
  if (!coarse) return std::nullopt;
  std::unique_ptr<CoupledSolver> fine;
  Work work;  // for the fine walls' closed start
  const auto build = [&] {
    fine = std::make_unique<CoupledSolver>(closed_problem(work), coupled_);
  };
  // With a second thread the fine walls are built while the coarse ones are solved.
  std::atomic<bool> abandoned = false;
  std::future<void> ready = in_background([&] {
    build();
    fine->prepare([&] { return abandoned.load(); });
  });
  const CoupledSolution found = [&] {
    const Abandoned at_the_end{abandoned};
    return CoupledAttempt(*coarse, options_, Walls::coarse).closed(false);
  }();
  try {
    if (ready.valid()) ready.get();
  } catch (...) {
    fine.reset();  // what is really wrong is found again below
    work = {};
  }
  prediction_.work += found.surface.work;
  if (!is_minimum(found.status)) return std::nullopt;
  if (!fine) build();
  prediction_.work += work;
  fine->set_start(start_from_coarse(*coarse, found, prediction_));
  if (!leaves_out_contact(prediction_))
    fine->options().passes_through = [this](const std::vector<Points>& now) {
      return passes_through(now);
    };
  CoupledSolution solution = fine->solve();
  if (is_minimum(solution.status) || solution.status == Status::interrupted) return solution;
  prediction_.work += solution.surface.work;
  return std::nullopt;
}

CoupledSolution CoupledAttempt::closed(bool folds) {
  CoupledProblem problem = closed_problem(prediction_.work);
  CoupledOptions coupled = folds ? of_folding() : coupled_;
  if (folds) coupled.max_outer = updates_from_closed;
  return CoupledSolver(std::move(problem), coupled).solve();
}

CoupledSolution CoupledAttempt::parted(const CoupledSolution& crossed, bool folds,
                                       double inflation) {
  CoupledStart start;
  // Walls that begin to press from inside each other are far from a positive definite Hessian; but
  // walls that fold would snap into other folds.
  if (folds) start.roughness = Roughness::near;
  start.buckled = crossed.status == Status::buckled;
  for (const BodySolution& body : crossed.surface.bodies) {
    start.bodies.emplace_back();
    start.pressure.push_back(body.pressure);
    if (body.modelled) start.bodies.back().points = body.positions;
  }
  for (size_t v = 0; v < start.bodies.size(); ++v)
    for (const SectionSolution& section : crossed.sections[v])
      start.bodies[v].sections.push_back({section.rotation, section.center});
  return parted(std::move(start), inflation);
}

CoupledSolution CoupledAttempt::refined(const Prediction& coarse, const CoupledSolution& found) {
  return parted(start_from_coarse(coarse, found, prediction_), 0);
}

CoupledSolution CoupledAttempt::parted(CoupledStart&& start, double inflation) {
  CoupledProblem problem = closed_problem(prediction_.work);
  feel_themselves(prediction_, problem.surfaces);
  problem.meet_up_to_seams = true;
  inflate(prediction_, inflation, problem);
  problem.lets_out = inflation > 0;
  problem.start = std::move(start);
  return CoupledSolver(std::move(problem), of_folding(most_per_stage)).solve();
}

std::optional<CoupledSolution> CoupledAttempt::inflated(double strain) {
  const double pressure = pressure_for(prediction_, strain);
  CoupledProblem problem = closed_problem(prediction_.work);
  inflate(prediction_, pressure, problem);
  CoupledOptions coupled = of_folding(most_per_stage);
  coupled.max_outer = updates_from_closed;
  coupled.keep = {};  // a state of other pressures than the scene's is none of it
  const CoupledSolution round = CoupledSolver(std::move(problem), coupled).solve();
  if (round.status == Status::interrupted) return round;
  prediction_.work += round.surface.work;
  if (!is_minimum(round.status)) return std::nullopt;
  return parted(round, true, pressure);
}

CoupledSolution CoupledAttempt::guarded() {
  CoupledProblem problem = closed_problem(prediction_.work);
  problem.guarded = true;
  return CoupledSolver(std::move(problem), coupled_).solve();
}

CoupledSolution CoupledAttempt::on_its_way() {
  CoupledProblem problem = problem_of(prediction_, sections_);
  go_from_rest(prediction_, sections_, problem);
  return CoupledSolver(std::move(problem), of_folding()).solve();
}

void CoupledAttempt::keep(CoupledSolution&& solution, Prediction& in) const {
  take(std::move(solution), sections_, in);
}

CoupledOutcome CoupledAttempt::outcome(CoupledSolution&& solution) {
  prediction_.work += solution.surface.work;
  CoupledOutcome outcome{prediction_, std::move(solution)};
  keep(CoupledSolution(outcome.solution), outcome.state);
  if (outcome.minimum()) outcome.depth = deepest_crossing(outcome.state);
  return outcome;
}

CoupledProblem CoupledAttempt::closed_problem(Work& work) {
  CoupledProblem problem = problem_of(prediction_, sections_);
  start_closed(prediction_, sections_, problem, work);
  return problem;
}

// Whether joined walls pass through each other or themselves.
bool CoupledAttempt::passes_through(const std::vector<Points>& now) const {
  Prediction state = prediction_;
  for (size_t v = 0; v < now.size(); ++v) state.vessels[v].positions = now[v];
  const auto joined = [&](const std::string& name) {
    const auto& vessels = prediction_.operation->vessels;
    return name == vessels[0].name || name == vessels[1].name;
  };
  const std::vector<NamedCrossing> found = named_crossings(state);
  return std::any_of(found.begin(), found.end(), [&](const NamedCrossing& named) {
    return named.crossing.depth > 0 && joined(named.a) && joined(named.b);
  });
}

// Of walls that crumple; 0: as many factorisations as they need.
CoupledOptions CoupledAttempt::of_folding(int factorisations) const {
  CoupledOptions coupled = coupled_;
  coupled.hold_after = hold_after;
  coupled.most_per_stage = factorisations;
  return coupled;
}

void CoupledAttempt::only_for_a_start() {
  coupled_.start = Roughness::rough;
  coupled_.certify = false;
  coupled_.tolerance = coarse_tolerance;
  coupled_.seam_tolerance = coupled_.balance_tolerance = coarse_share;
  coupled_.pressure_tolerance = coarse_change;
  coupled_.contact_tolerance = coupled_.slip_tolerance = coarse_length;
}

}  // namespace vasorod
