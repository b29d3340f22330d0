// The scene's tubes, materials and end conditions as dimensionless parts of a finite-element
// problem.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/scene.h>

#include "reference_fem/law.h"
#include "reference_fem/prestress.h"
#include "reference_fem/section.h"
#include "reference_fem/tube.h"

namespace vasorod::fem {

/// The scene's length and stress per dimensionless length and stress.
struct ProblemUnits {
  double length = 1, stress = 1;
  double force() const { return stress * length * length; }
  double moment() const { return force() * length; }
};

/// One end with a condition, dimensionless, in the order of the scene.
struct EndProblem {
  std::string name;  ///< as in the scene: start, end or near(x, y, z)
  int side = 0;
  bool soft = false;
  std::array<bool, 6> fixed{};
  Vec3 move = Vec3::Zero(), rotation = Vec3::Zero(), force = Vec3::Zero(), moment = Vec3::Zero();
  bool moment_in_body = false;

  bool held() const;  ///< all six components stay as they are, as a rigid section
};

/// The tube's shape in the scene's axes.
TubeShape shape_of(const VesselSpec& vessel, const ProblemUnits& units);
Moduli moduli_of(const Material& material, double stress_unit);
LawKind law_of(const Material& material);
/// The tube's end, 0 or 1, that the scene names; `unit`: the scene's length over the shape's.
int side_of(const Scene& scene, const TubeShape& shape, const EndSelector& end, double unit);
/// The conditions of one vessel, in the scene's axes.
std::vector<EndProblem> ends_of(const Scene& scene, const std::string& vessel,
                                const TubeShape& shape, const ProblemUnits& units);
/// Throws InputError if the ends hold fewer than six components in all. `what` would float away.
void require_held(const Scene& scene, const std::vector<EndProblem>& ends, const std::string& what);
/// Throws InputError, naming the vessel, if the law refuses the moduli.
void require_admissible(const Scene& scene, const std::string& vessel, LawKind law,
                        const Moduli& moduli);
/// The vessel's pressures and prestretch. Throws InputError for a pressure that its wall cannot
/// bear.
SeenState seen_state(const Scene& scene, const VesselSpec& vessel, const ProblemUnits& units);
/// Gives a section of the model the condition of its end.
void apply(const EndProblem& end, Section& section);

}  // namespace vasorod::fem
