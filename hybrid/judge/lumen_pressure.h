// What a pressure in the lumen means for a wall: when its section collapses, what it can bear.
#pragma once

#include <string>

#include <vasorod/result.h>
#include <vasorod/scene.h>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// p_c = 3 D / R^3, D = E_T t^3 / 12 (1 - nu_TT^2): the pressure from outside at which a ring of
/// radius R and thickness t (length) collapses, stress (Levy 1884).
double collapse_pressure(const Material& material, double thickness, double radius);

/// "12 mmHg (0.0016 MPa)".
std::string mmhg_text(double pressure, const Units& units);

/// Throws InputError (one sentence) for a pressure that would stretch or shorten the wall by more
/// than half: it is beyond what vessels bear, or its unit is another.
void require_bearable(const PreparedVessel& vessel, const Scene& scene);

/// A sentence with the vessel's two pressures, for the result's notes.
std::string lumen_note(const VesselSpec& vessel, const Units& units);

/// Warns of a section that its pressure collapses, from 0.9 p_c on, and sets in_range to false.
void warn_of_collapse(const PreparedVessel& vessel, const Units& units, Validity& validity);

}  // namespace vasorod
