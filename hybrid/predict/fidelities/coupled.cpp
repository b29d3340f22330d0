#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

#include "coupled/coupled_problem.h"
#include "data/index.h"
#include "geometry/triangle_surface.h"
#include "numerics/threads.h"
#include "paper/joined_skin.h"
#include "predict/carried_bodies.h"
#include "predict/coarse_start.h"
#include "predict/fidelities/fidelities.h"
#include "predict/joining_path.h"
#include "predict/kept_state.h"
#include "predict/name_crossings.h"
#include "predict/path_rule.h"
#include "predict/sharp_vein.h"
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
// Hoop strains p R / (E t) to which the vessels of a vein that folds are inflated, the second where
// the first leads nowhere.
constexpr std::array inflations{0.02, 0.05};
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

double mean_edge(const Prediction& prediction, const SharpVein& vein) {
  return mean_edge_length(
      prediction.vessels[vessel_named(prediction, vein.name)].prepared.vessel.surface);
}

bool is_minimum(Status status) {
  return status == Status::converged || status == Status::buckled || status == Status::not_unique ||
         status == Status::equilibrium_only;
}

// In a scene in which nothing touches anything, walls may lie in each other.
bool leaves_out_contact(const Prediction& prediction) {
  return prediction.scene->contact && prediction.scene->contact->empty();
}

bool touches_itself(const CoupledSolution& solution) {
  return std::any_of(
      solution.surface.contacts.begin(), solution.surface.contacts.end(),
      [](const ContactSolution& pair) { return pair.a == pair.b && pair.within_reach; });
}

// The prediction with one solution.
struct Outcome {
  Prediction state;
  Status status = Status::iteration_limit;
  double depth = 0;  // in which the walls of a minimum pass through something, length
  bool crossed() const { return depth > 0; }
};

// Sets a flag at the end of its life, whatever ends it.
struct Abandoned {
  std::atomic<bool>& flag;
  ~Abandoned() { flag = true; }
};

// One solve of a prediction.
class Attempt {
 public:
  Attempt(Prediction& prediction, const SolveOptions& options, bool coarse = false)
      : prediction_(prediction), options_(options) {
    coupled_.times = path_times(prediction);
    coupled_.stop = options.stop;
    const std::string walls = coarse ? "coarse walls" : "walls";
    coupled_.step = step_progress(walls, options);
    coupled_.progress = iteration_progress(walls, 10, options);
    if (coarse) {
      only_for_a_start();
      return;
    }
    coupled_.keep = keep_for<CoupledSolution>(prediction, options,
                                              [this](CoupledSolution&& so_far, Prediction& state) {
                                                take(std::move(so_far), sections_, state);
                                              });
  }

  // From where coarser walls went; empty: they found no minimum.
  std::optional<CoupledSolution> from_coarse() {
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
      return Attempt(*coarse, options_, true).closed();
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

  // From a closed seam; with at most so many updates.
  CoupledSolution closed(std::optional<int> updates = {}) {
    CoupledProblem problem = closed_problem(prediction_.work);
    CoupledOptions coupled = coupled_;
    if (updates) {
      coupled.max_outer = *updates;
      coupled.hold_after = hold_after;
    }
    return CoupledSolver(std::move(problem), coupled).solve();
  }

  // From a minimum whose walls pass through each other: joined walls touch right up to the seam,
  // and each itself. `inflation`: pressure in which they found it, to be let out.
  CoupledSolution parted(const CoupledSolution& crossed, bool folds, double inflation = 0) {
    CoupledProblem problem = closed_problem(prediction_.work);
    feel_themselves(prediction_, problem.surfaces);
    problem.meet_up_to_seams = true;
    inflate(prediction_, inflation, problem);
    problem.lets_out = inflation > 0;
    CoupledStart& start = problem.start.emplace();
    // Walls that begin to press from inside each other are far from a positive definite Hessian;
    // but walls that fold would snap into other folds.
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
    return CoupledSolver(std::move(problem), of_folding(most_per_stage)).solve();
  }

  // Inflated vessels stay round, so that little of a vein that folds lies in other walls; then they
  // are parted and let out. Empty: the inflated ones found no minimum.
  std::optional<CoupledSolution> inflated(double strain) {
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

  // From rest, with a barrier in place of the contacts of walls with themselves.
  CoupledSolution guarded() {
    CoupledProblem problem = closed_problem(prediction_.work);
    problem.guarded = true;
    return CoupledSolver(std::move(problem), coupled_).solve();
  }

  // Along the way of a vein that folds.
  CoupledSolution on_its_way() {
    CoupledProblem problem = problem_of(prediction_, sections_);
    go_from_rest(prediction_, sections_, problem);
    return CoupledSolver(std::move(problem), of_folding()).solve();
  }

  void keep(CoupledSolution&& solution, Prediction& in) const {
    take(std::move(solution), sections_, in);
  }

  // Adds the solution's work to the prediction.
  Outcome outcome(const CoupledSolution& solution) {
    Outcome outcome{prediction_, solution.status};
    keep(CoupledSolution(solution), outcome.state);
    prediction_.work += solution.surface.work;
    if (is_minimum(solution.status))
      for (const NamedCrossing& found : named_crossings(outcome.state))
        outcome.depth = std::max(outcome.depth, found.crossing.depth);
    return outcome;
  }

 private:
  CoupledProblem closed_problem(Work& work) {
    CoupledProblem problem = problem_of(prediction_, sections_);
    start_closed(prediction_, sections_, problem, work);
    return problem;
  }

  // Whether joined walls pass through each other or themselves.
  bool passes_through(const std::vector<Points>& now) const {
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
  CoupledOptions of_folding(int factorisations = 0) const {
    CoupledOptions coupled = coupled_;
    coupled.hold_after = hold_after;
    coupled.most_per_stage = factorisations;
    return coupled;
  }

  // A start needs few digits, and no certificate.
  void only_for_a_start() {
    coupled_.start = Roughness::rough;
    coupled_.certify = false;
    coupled_.tolerance = coarse_tolerance;
    coupled_.seam_tolerance = coupled_.balance_tolerance = coarse_share;
    coupled_.pressure_tolerance = coarse_change;
    coupled_.contact_tolerance = coupled_.slip_tolerance = coarse_length;
  }

  Prediction& prediction_;
  const SolveOptions& options_;
  CoupledOptions coupled_;
  std::vector<VesselSections> sections_;
};

}  // namespace

// A wall that crumples may find no end of its contacts with itself, or pass through itself: then a
// barrier takes their place. A vein that has to fold may end at a minimum from a closed seam, which
// is cheap to try. Walls that pass through something there are parted; where that fails, and first
// where they lie in each other by more than an edge, too deep for contact to tell the sides apart,
// a vein that folds is joined inflated, and at last one goes the way from rest. A minimum is better
// than none, whatever passes through it.
void solve_coupled(Prediction& prediction, const SolveOptions& options) {
  Attempt attempt(prediction, options);
  const std::optional<SharpVein> vein = sharp_vein(prediction);
  const bool folds = vein && has_to_fold(*vein);
  std::optional<CoupledSolution> first;
  if (!folds) first = attempt.from_coarse();
  if (!first) first = attempt.closed(folds ? updates_from_closed : std::optional<int>());
  const bool apart = vein ? !folds && leaves_out_contact(prediction) : !touches_itself(*first);
  if (apart) {
    attempt.keep(std::move(*first), prediction);
    return;
  }
  Outcome best = attempt.outcome(*first);
  const auto take_if_better = [&](const CoupledSolution& solution) {
    Outcome next = attempt.outcome(solution);
    const bool better = is_minimum(next.status) && next.depth <= best.depth;
    if (better || !is_minimum(best.status)) best = std::move(next);
  };
  const auto part = [&] {
    if (best.crossed() && !options.stop()) take_if_better(attempt.parted(*first, folds));
  };
  const bool deep = folds && best.depth > mean_edge(prediction, *vein);
  const auto goes_on = [&] {
    return (best.crossed() || (folds && !is_minimum(best.status))) && !options.stop();
  };
  if (!vein) {
    if ((best.crossed() || !is_minimum(best.status)) && !options.stop()) {
      const CoupledSolution guarded = attempt.guarded();
      if (is_minimum(guarded.status) || guarded.reached >= first->reached)
        take_if_better(guarded);
      else
        prediction.work += guarded.surface.work;
    }
  } else {
    if (!deep) part();
    for (const double strain : inflations)
      if (folds && goes_on())
        if (const auto found = attempt.inflated(strain)) take_if_better(*found);
    if (goes_on()) take_if_better(attempt.on_its_way());
    if (deep) part();
  }
  best.state.work = prediction.work;
  prediction = std::move(best.state);
}

}  // namespace vasorod
