// Decides when `coupled` follows a motion or a pressure in steps and does not jump to its end, and
// the steps.
#pragma once

#include <vector>

#include "predict/prediction.h"

namespace vasorod {

/// How close the solved rods come to their walls' limits, where the smooth branch may end:
/// Brazier's curvature for vessels of any length (k R^2 / (0.605 t) converted to 0.471 t / (R^2
/// sqrt(1 - nu^2))), and the twist of wrinkling. Soft sections can flatten and count double. 1: at
/// the limit.
double share_of_limit(const Prediction& prediction);

/// The times, up to 1, of the steps of a motion that ends at this share of the limit. From 0.7 of
/// the limit on, a smooth and a kinked minimum coexist. At half the limit there is one minimum;
/// from there, the path advances in small steps, each extrapolated from the previous two.
std::vector<double> path_times(double share);

/// The times, up to 1, of the steps of a pressure that goes from `scan` to `after`, where outside
/// pressure is negative; `collapse`: the pressure outside at which a long section collapses, p_c of
/// judge/lumen_pressure.h. Below 0.9 p_c outside, one step. Past it a section closes between p_c
/// and 1.75 p_c, or higher where held ends are near: the steps are at most p_c / 6 and a tenth of
/// the pressure, whichever is larger.
std::vector<double> pressure_times(double scan, double after, double collapse);

/// The same of a vessel; one step without a pressure.
std::vector<double> pressure_times(const PreparedVessel& vessel);

/// The times, up to 1, of the steps of a motion that carries a vessel's wall through another
/// vessel: `way`: how far its points move at most, `depth`: how deep they end inside the other
/// vessel, both over the vessel's radius. Up to half a radius, one step; past it the start would
/// lie beyond the other vessel's middle, and contact would push the wall on instead of back.
std::vector<double> pressing_times(double way, double depth);

/// How deep the rods carry the wall of a vessel into other vessels that it may touch and was
/// outside of, over its radius.
double carried_depth(const Prediction& prediction, size_t vessel);

/// The times for a prediction: those of its motion, of what it presses into other vessels, and of
/// its vessels' pressures. An operation jumps: its pose is only a start, and no path leads from
/// rest to it.
std::vector<double> path_times(const Prediction& prediction);

}  // namespace vasorod
