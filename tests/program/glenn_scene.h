// The bundled infant scene, which tests can rotate, move and write in other units.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include <vasorod/types.h>

namespace vasorod::testing {

struct GlennScene {
  std::string file = "infant.yaml";  ///< in benchmarks/cases/glenn
  std::optional<double> rotation_deg, incision_length;
  std::optional<Vec3> keep;                   ///< in mm, in place of the file's
  Pose motion;                                ///< applied first, in mm
  double length_scale = 1, stress_scale = 1;  ///< new number = scale * old number
  std::string length_unit = "mm", stress_unit = "MPa";
};

inline GlennScene infant() {
  return {};
}

/// Runs `vasorod solve` on an unchanged case file and returns result.json. Exit codes above 1 fail
/// the test.
nlohmann::json solve_case(const std::string& file, const std::string& options);

enum class Left { all, out_contact, out_pressure };
/// The same with another `rotation_deg`, and perhaps without contact, or without pressure and
/// prestretch.
nlohmann::json solve_turned(const std::string& file, double rotation_deg,
                            const std::string& options, Left left = Left::all);

/// Writes the changed scene with its surfaces and runs it.
nlohmann::json solve_glenn(const GlennScene& scene, const std::string& options);

}  // namespace vasorod::testing
