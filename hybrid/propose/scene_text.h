// A proposed scene as the commented YAML that a reader completes.
#pragma once

#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "propose/proposed_wall.h"
#include "vessel/vessel.h"

namespace vasorod {

/// A vessel of the proposal. `spec` has its name, surface, role, remeshing and wall.
struct ProposedVessel {
  VesselSpec spec;
  VesselKind kind = VesselKind::other;
  std::string surface;        ///< the file as the scene names it
  std::string wall_source;    ///< one line
  std::string remesh_reason;  ///< one line; empty: not remeshed
  Vessel vessel;              ///< fitted; of an obstacle without ends
};

/// An end as a scene writes it: start, {near: [x, y, z]}, {face: 3}.
std::string yaml_of(const EndSelector& end);

/// A text as a YAML value, in quotes where it needs them.
std::string yaml_text(const std::string& text);

/// The whole file. Every end of the vessels is held. `unit_reason`: the comment beside the units,
/// one line; `keep_reason`: why the end in `scene.glenn` is kept, one line.
std::string scene_text(const Scene& scene, const std::vector<ProposedVessel>& vessels,
                       const std::string& unit_reason, const std::string& keep_reason);

}  // namespace vasorod
