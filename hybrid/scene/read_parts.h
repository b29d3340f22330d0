// Readers of the parts of a scene file. read_scene combines them.
#pragma once

#include <vasorod/read_scene.h>

#include "scene/field.h"

namespace vasorod {

Units read_units(const Field& units);
/// `pressure_unit`: of the vessels' pressures, in stress units.
std::vector<VesselSpec> read_vessels(const Field& vessels, const std::filesystem::path& folder,
                                     double pressure_unit);
Wall read_wall(const Field& wall);
TubeSpec read_tube(const Field& tube);
RodSpec read_rod(const Field& rod);
std::vector<EndCondition> read_ends(const Field& ends, const std::vector<VesselSpec>& vessels);
std::vector<std::array<std::string, 2>> read_contact(const Field& contact,
                                                     const std::vector<VesselSpec>& vessels);
/// An end of the vessel: start, end, {near: ...} and {face: ...} or, on a bare rod, {at: ...}.
EndSelector read_selector(const Field& end, const VesselSpec& vessel);
/// `folder`: that of the scene file.
GlennSpec read_glenn(const Field& glenn, const std::vector<VesselSpec>& vessels,
                     const std::filesystem::path& folder, const Units& units);
EndToEndSpec read_end_to_end(const Field& end_to_end, const std::vector<VesselSpec>& vessels,
                             const std::filesystem::path& folder, const Units& units);
/// A slit (empty) or an ellipse.
std::optional<IncisionEllipse> read_shape(const Field& field);
ExploreSpec read_explore(const Field& explore, const std::vector<VesselSpec>& vessels);
VarySpec read_vary(const Field& vary, const std::vector<VesselSpec>& vessels);

/// The vessel that a field names. If there is none, the message suggests the nearest name.
const VesselSpec& named_vessel(const Field& name, const std::vector<VesselSpec>& vessels);

}  // namespace vasorod
