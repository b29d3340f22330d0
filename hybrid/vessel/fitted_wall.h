// The wall of a vessel that is fitted: what the fit takes from it, set again for another wall.
#pragma once

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// Mid-wall radii, thickness and section stiffness of a rod that was fitted to the given surface.
/// Throws InputError where the wall is too thick.
void add_wall(PreparedVessel& vessel);

/// Gives a fitted vessel the wall and the pressure of `spec`, which is otherwise its own: as if it
/// had been read and fitted with them. Throws InputError as add_wall() does.
void change_wall(PreparedVessel& vessel, const VesselSpec& spec);

}  // namespace vasorod
