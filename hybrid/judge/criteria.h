// The values a reader looks at first, each beside its threshold and the source of the threshold.
#pragma once

#include <vector>

#include <vasorod/result.h>

namespace vasorod {

/// One criterion per kind, with the worst value of all vessels:
///
/// lumen: smallest lumen over its rest value. A warning below 0.6, a strong one below 0.4.
///
/// mouth: lumen of the mouth of an operation over that of the cut vein at rest, with the same
/// thresholds.
///
/// twist: largest angle, in degrees, by which one section of a vessel turned about the axis against
/// another. A warning from 90 degrees, a strong one from 180.
///
/// twist_shear, stretch (the value furthest from 1) and contact_pressure (mmHg): no threshold is
/// known.
///
/// What the result's fidelity did not model is left out. Lumen and mouth are never called fine
/// where sections were carried rigidly (fidelity skin). In a state that is no solution every
/// verdict is `unknown`. Reads status, fidelity, units, metrics, operation, contact and vessels of
/// the result.
std::vector<Criterion> criteria_of(const Result& result);

}  // namespace vasorod
