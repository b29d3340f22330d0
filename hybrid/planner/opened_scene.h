// A scene that the page works on: read and fitted once, its plan turned into fractions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "geometry/ray_hits.h"
#include "planner/plan.h"
#include "planner/scene_edit.h"
#include "predict/fitted_vessels.h"

namespace vasorod::planner {

struct OpenedScene {
  std::string id;  ///< of its source
  Scene scene;
  FittedVessels fitted;
  std::vector<RayHits> walls;  ///< of the vessels at rest
  /// The plan of the scene as it was opened; empty: it cannot be changed.
  std::optional<Plan> plan;
  std::string why_not;  ///< one sentence where there is no plan
  /// Of the joined vessels: where fractions of a plan without routes count.
  RouteEnds cut_route{}, incision_route{};

  /// Index of a vessel; throws Refusal (404).
  std::size_t vessel(const std::string& name) const;
  const PreparedVessel& svc() const { return fitted.vessels[svc_at]; }
  const PreparedVessel& rpa() const { return fitted.vessels[rpa_at]; }
  /// "svc", "rpa" or empty.
  std::string part_of(std::size_t vessel) const;

  std::size_t svc_at = 0, rpa_at = 0;  ///< with `surgery: glenn`
};

/// Reads and fits. Throws as read_scene() and fit_vessels() do.
std::shared_ptr<const OpenedScene> open_scene(const std::string& id,
                                              const std::filesystem::path& file);

/// The routes of a plan in this scene. Throws Refusal for ends that there are not.
RouteEnds cut_route_of(const OpenedScene& opened, const Plan& plan);
RouteEnds incision_route_of(const OpenedScene& opened, const Plan& plan);

/// What the file has to say for the plan: only what differs from the plan as it was opened.
SceneEdit edit_for(const OpenedScene& opened, const Plan& plan,
                   const std::optional<std::string>& fidelity);

/// The scene that a saved file would be read as. Throws Refusal for a plan that does not belong to
/// the scene, InputError as read_scene().
Scene with_plan(const OpenedScene& opened, const Plan& plan,
                const std::optional<std::string>& fidelity);

}  // namespace vasorod::planner
