// A scene as typed data (docs/scene.md). The reader checks everything that is here.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/material.h>
#include <vasorod/tube.h>
#include <vasorod/types.h>

namespace vasorod {

/// The scene's units. Everything below is in them; forces are stress * length^2.
struct Units {
  std::string length = "mm", stress = "MPa";
  double metres = 1e-3;  ///< metres per length unit
  double pascals = 1e6;  ///< pascals per stress unit
};

/// One piece of a bare rod: strains and stiffness constant, or tapering linearly to
/// `end_stiffness`.
struct RodPiece {
  double length = 0;
  Vec3 curvature = Vec3::Zero();  ///< drawn (u1, u2, u3), 1/length; v = (0, 0, 1)
  int elements = 1;
  Mat6 stiffness = Mat6::Zero();  ///< order v1 v2 v3 u1 u2 u3
  std::optional<Mat6> end_stiffness;
  std::optional<Vec6> natural;  ///< unstressed strain (v, u) where it is not the drawn one
};

/// A bare rod (fidelity rod). With a parent, position, tangent and normal are relative to the
/// parent's end frame.
struct RodSpec {
  std::optional<std::string> parent;
  Vec3 position = Vec3::Zero(), tangent = Vec3::UnitX(),
       normal = Vec3::UnitY();  ///< d3 and d1 at its start
  std::vector<RodPiece> pieces;
};

enum class Role { deformable, obstacle };
enum class SurfaceIs { mid, outer, inner };  ///< which face of the wall the given surface is

std::string to_string(Role);
std::string to_string(SurfaceIs);

/// One vessel: exactly one of `surface`, `tube`, `rod`.
struct VesselSpec {
  std::string name;
  std::optional<std::filesystem::path> surface;  ///< resolved against the scene file's folder
  std::optional<TubeSpec> tube;
  std::optional<RodSpec> rod;
  std::optional<double> remesh;             ///< target edge, length
  SurfaceIs surface_is = SurfaceIs::outer;  ///< generated tubes: mid
  bool check = true;                        ///< radius plausibility
  std::optional<Wall> wall;                 ///< required unless obstacle or bare rod
  std::optional<Coefficients> coefficients;
  Role role = Role::deformable;
  std::optional<double>
      pressure;  ///< lumen pressure, stress; only the finite-element reference takes it
  int line = 0;  ///< in the scene file, for messages
};

/// Which end of a vessel.
struct EndSelector {
  enum class Kind { start, end, near, at } kind = Kind::start;
  Vec3 near = Vec3::Zero();  ///< kind near
  double at = 0;             ///< kind at: fraction of a bare rod's length
};
std::string to_string(
    const EndSelector&);  ///< as result.json names it: start, end, near(x, y, z) or at(f)

/// One entry of `ends:`.
struct EndCondition {
  std::string vessel;
  EndSelector end;
  bool hold = false;
  std::optional<Vec3>
      rotate_deg;  ///< rotation vector in degrees, space axes; angles beyond 360 are meant
  std::optional<Vec3> move;    ///< length
  std::optional<Vec3> force;   ///< dead, space axes, stress length^2
  std::optional<Vec3> moment;  ///< stress length^3
  bool moment_in_body = false;
  std::array<bool, 6> fix{};  ///< x y z rx ry rz in the section's rest frame (d1, d2, d3)
  bool soft_section = false;  ///< only the section's mean pose is held
  int line = 0;               ///< in the scene file, for messages
};
/// Whether two entries for one end exclude each other: a motion stands alone, and two loads or two
/// fixes of one end are a slip of the keyboard.
bool exclude_each_other(const EndCondition& a, const EndCondition& b);

/// "X, expected Y" where one entry contradicts itself or says nothing; empty where it makes sense.
std::string contradiction(const EndCondition& end);

/// The operation.
struct GlennSpec {
  std::string svc, rpa;
  Vec3 cut = Vec3::Zero(), incision = Vec3::Zero();
  std::optional<double> rotation_deg;  ///< added to what auto finds; absent: auto
  Vec3 keep_near = Vec3::Zero();       ///< near the end of the cut SVC that goes on
  int line = 0;
};

struct Scene {
  std::filesystem::path file;
  std::string name;
  Units units;
  std::vector<VesselSpec> vessels;
  std::vector<EndCondition> ends;
  std::optional<std::vector<std::array<std::string, 2>>>
      contact;  ///< absent: every pair within reach
  std::optional<GlennSpec> glenn;
  std::optional<std::string> fidelity;  ///< one of fidelity_names(); absent with `accuracy`
  int fidelity_line = 0;                ///< in the scene file, for messages
  std::optional<double> accuracy;       ///< RMS distance over R
  bool extrapolate = false;  ///< bare rods: solve with n and 2n elements and extrapolate to order 4

  const VesselSpec& vessel(
      const std::string& vessel_name) const;  ///< throws InputError when there is none
};

}  // namespace vasorod
