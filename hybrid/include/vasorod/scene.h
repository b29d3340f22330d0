// A scene as typed data. The reader (read_scene.h) checks everything stated here.
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

/// The scene's units. All data below are in these units. Forces are stress * length^2, moments
/// stress * length^3.
struct Units {
  std::string length = "mm",  ///< name of the length unit
      stress = "MPa";         ///< name of the stress unit
  double metres = 1e-3;       ///< metres per length unit
  double pascals = 1e6;       ///< pascals per stress unit
};

/// One piece of a bare rod. Strains and stiffness are constant, or the stiffness tapers linearly to
/// `end_stiffness`.
struct RodPiece {
  double length = 0;              ///< arc length, length
  Vec3 curvature = Vec3::Zero();  ///< drawn (u1, u2, u3), 1/length; v = (0, 0, 1)
  int elements = 1;               ///< number of elements
  /// Section stiffness, order v1 v2 v3 u1 u2 u3: stress length^2 for v, stress length^4 for u.
  Mat6 stiffness = Mat6::Zero();
  std::optional<Mat6> end_stiffness;  ///< stiffness at the end; empty: constant
  std::optional<Vec6> natural;        ///< unstressed strain (v, u); empty: the drawn strain
};

/// A bare rod (fidelity `rod`). With a parent, position, tangent and normal are relative to the
/// parent's end frame.
struct RodSpec {
  std::optional<std::string> parent;  ///< name of the rod from whose end this rod branches off
  Vec3 position = Vec3::Zero(),       ///< start point, length
      tangent = Vec3::UnitX(),        ///< d3 at the start
      normal = Vec3::UnitY();         ///< d1 at the start
  std::vector<RodPiece> pieces;       ///< in the order of arc length
};

/// What a vessel does in the scene.
enum class Role {
  deformable,  ///< deforms
  obstacle     ///< stays at rest; other vessels may touch it
};
/// Which face of the wall the given surface is.
enum class SurfaceIs {
  mid,    ///< the middle of the wall
  outer,  ///< the outer face
  inner   ///< the inner face, the lumen's boundary
};

/// The role's name in scene files.
std::string to_string(Role);
/// The face's name in scene files.
std::string to_string(SurfaceIs);

/// One vessel: exactly one of `surface`, `tube` and `rod` is set.
struct VesselSpec {
  std::string name;                              ///< unique in the scene
  std::optional<std::filesystem::path> surface;  ///< file, resolved against the scene's folder
  std::optional<TubeSpec> tube;                  ///< generated tube
  std::optional<RodSpec> rod;                    ///< bare rod without a surface
  std::optional<double> remesh;                  ///< target edge length of a remeshing, length
  SurfaceIs surface_is = SurfaceIs::outer;       ///< face of the wall; generated tubes: mid
  bool check = true;                             ///< check that the radius is plausible
  std::optional<Wall> wall;                      ///< required unless obstacle or bare rod
  std::optional<Coefficients> coefficients;      ///< of `paper`; empty: derived from the wall
  Role role = Role::deformable;                  ///< deformable or obstacle
  std::optional<LumenPressure> pressure;         ///< in the lumen; empty: none
  double axial_prestretch = 1;                   ///< of the wall as seen, along its axis
  int line = 0;                                  ///< line in the scene file, for messages
};

/// Selects one end of a vessel.
struct EndSelector {
  /// How the end is selected.
  enum class Kind {
    start,                   ///< the first end; of a bare rod, arc length 0
    end,                     ///< the other end of a vessel with two ends
    near,                    ///< the end nearest to a point
    at,                      ///< a place on a bare rod
    face                     ///< the end that a lid closed
  } kind = Kind::start;      ///< how the end is selected
  Vec3 near = Vec3::Zero();  ///< kind near: the point, length
  double at = 0;             ///< kind at: fraction of a bare rod's length
  int face = 0;              ///< kind face: ModelFaceID of the lid
};

/// The selector as in result.json: start, end, near(x, y, z), at(f) or face(n).
std::string to_string(const EndSelector&);

/// One entry of `ends:`. A motion (hold, rotate_deg, move) excludes loads and fixes.
struct EndCondition {
  std::string vessel;  ///< name of the vessel
  EndSelector end;     ///< which of its ends
  bool hold = false;   ///< the end stays in its rest pose
  /// Rotation vector in degrees, space axes. Angles beyond 360 degrees are followed as written.
  std::optional<Vec3> rotate_deg;
  std::optional<Vec3> move;     ///< displacement, length, space axes
  std::optional<Vec3> force;    ///< dead force, space axes, stress length^2
  std::optional<Vec3> moment;   ///< moment, stress length^3; axes as `moment_in_body` says
  bool moment_in_body = false;  ///< the moment turns with the section; false: space axes
  /// Fixed degrees of freedom x y z rx ry rz, in the section's rest frame (d1, d2, d3).
  std::array<bool, 6> fix{};
  bool soft_section = false;  ///< only the section's mean pose is held; it may deform
  int line = 0;               ///< line in the scene file, for messages
};

/// Whether two entries for one end exclude each other: a motion with anything else, two loads, or
/// two fixes.
bool exclude_each_other(const EndCondition& a, const EndCondition& b);

/// "X, expected Y" if the entry contradicts itself or has no condition; empty if it is consistent.
std::string contradiction(const EndCondition& end);

/// The ellipse that an incision takes out of the wall; both axes are measured on the wall.
struct IncisionEllipse {
  /// Axis along the vessel, length. Empty: the rim's perimeter is `incision_length` times that of
  /// the vein's mouth.
  std::optional<double> length;
  /// Axis across the vessel, length. Empty: `ratio` times the length.
  std::optional<double> width;
  double ratio = 0.5;  ///< width over length where there is no width
};

/// A place picked on a vessel: a point, or a fraction of the vessel's axis.
struct PickSpec {
  PickSpec() = default;
  PickSpec(const Vec3& picked) : point(picked) {}                      ///< a point
  PickSpec(double x, double y, double z) : PickSpec(Vec3(x, y, z)) {}  ///< a point

  Vec3 point = Vec3::Zero();  ///< at most one radius off the vessel, length
  /// LPS or RAS: the space of `point`; x and y change sign where the vessel's file names the other
  /// one. Empty: the point has the vessel's own axes.
  std::string space;
  std::filesystem::path markup;  ///< file that `point` was read from; empty: none
  /// In place of `point`: fraction of the axis between two ends of the vessel.
  std::optional<double> along;
  /// With `along`, on the artery: angle about the axis in degrees, from d1 towards d2 of the rod's
  /// frame at rest there.
  double around_deg = 0;
  /// With `along`: the end where it is 0. Empty: the kept end of the vein, `start` of the artery.
  std::optional<EndSelector> from;
  /// With `along`: the end where it is 1. Empty: the one farthest from the first along the axis.
  std::optional<EndSelector> to;
};

/// The operation: a bidirectional Glenn shunt.
struct GlennSpec {
  std::string svc,  ///< name of the vessel that is cut: the superior vena cava
      rpa;          ///< name of the vessel that is incised: the right pulmonary artery
  PickSpec cut,     ///< where the SVC is cut
      incision;     ///< middle of the incision on the RPA
  /// Oblique cut, degrees, -75 to 75: the cut's normal (out of the kept part) is turned about the
  /// middle of the section, towards the direction in which the RPA's rod runs once the vein lies on
  /// it. 0: across the vein.
  double cut_tilt_deg = 0;
  /// Length of the incision over half the perimeter of the vein's mouth; of an ellipse without a
  /// length, its perimeter over that of the mouth.
  double incision_length = 1;
  std::optional<IncisionEllipse> ellipse;  ///< empty: the incision is a slit
  /// Rotation of the vein, degrees, added to the automatic one; empty: automatic only.
  std::optional<double> rotation_deg;
  EndSelector keep;  ///< the SVC's end that is kept
  int line = 0;      ///< line in the scene file, for messages
};

/// A rim of an end-to-end join: of a vessel that is cut, or of one that is left whole and joined by
/// one of its open ends.
struct RimSpec {
  std::string vessel;           ///< name of the vessel
  std::optional<PickSpec> cut;  ///< where it is cut; empty: left whole
  /// Oblique cut, degrees, -75 to 75: where positive, the kept part is longest on the side of the
  /// picked point.
  double cut_tilt_deg = 0;
  EndSelector keep,  ///< of a cut vessel: the end that is kept
      end;           ///< of a whole vessel: the end that is joined
  int line = 0;      ///< line in the scene file, for messages
};

/// The operation: two vessels joined end to end.
struct EndToEndSpec {
  std::array<RimSpec, 2> rims;  ///< of two different vessels
  /// Rotation of the second vessel, degrees, right-handed about the first rim's normal out of its
  /// vessel, from the smallest turn by which the two rims face each other; empty: the one with
  /// which the seam carries no torque about that normal.
  std::optional<double> rotation_deg;
  int line = 0;  ///< line in the scene file, for messages
};

/// A quantity of the scene that is not known exactly, with its distribution.
struct Uncertain {
  /// The first four are multiplied by a factor, the others are moved by a length.
  enum class What {
    young,      ///< all moduli of the wall
    poisson,    ///< both Poisson's ratios of the wall
    thickness,  ///< the wall's thickness
    pressure,   ///< the pressures of all vessels
    cut,        ///< the place of the cut, along the vein's axis from the kept end
    incision    ///< the place of the incision, along the artery's axis
  };
  What what = What::young;  ///< which quantity
  std::string vessel;       ///< of a wall; empty: all deformable vessels, by one factor
  double low = 0;           ///< of a uniform distribution: factor, or length; with `high` 0: normal
  double high = 0;          ///< its other end
  double sd = 0;            ///< of a normal one about 1 (factor) or 0 (length), cut off at 4 sd

  /// Whether it is a factor.
  bool scales() const { return what != What::cut && what != What::incision; }
};

/// The word in scene files: "young", "cut"...
std::string to_string(Uncertain::What what);

/// What is uncertain in a scene, and for which options it is carried through by samples
/// (docs/explore.md).
struct VarySpec {
  std::vector<Uncertain> uncertain;     ///< at least one
  int samples = 20;                     ///< for each option
  int best = 3;                         ///< number of options, the first of the ranking
  int seed = 1;                         ///< of the random numbers
  std::optional<std::string> fidelity;  ///< of the samples; empty: that of the last stage
};

/// A search for better options near the best of the listed ones (docs/explore.md).
struct RefineSpec {
  int evaluations = 20;  ///< at most, of new options
  int best = 1;          ///< number of options from which a search starts
};

/// The options of a Glenn shunt that `vasorod explore` solves and ranks: every combination of the
/// listed values. What is not listed is as in GlennSpec.
struct ExploreSpec {
  std::vector<double> cut_along,  ///< places of the cut, as PickSpec::along
      cut_tilt_deg,               ///< degrees, as in GlennSpec
      incision_along,             ///< places of the incision, as PickSpec::along
      around_deg,                 ///< angles of the incision in degrees, as PickSpec::around_deg
      incision_length;            ///< as in GlennSpec
  std::vector<std::optional<double>> rotation_deg;  ///< degrees; an empty entry: automatic only
  std::vector<std::optional<IncisionEllipse>> incision_shape;  ///< an empty entry: a slit
  /// Fidelities, one for each stage: the first solves all options, each other one the `best` of the
  /// stage before.
  std::vector<std::string> stages{"skin", "coupled"};
  int best = 10;  ///< number of options that go on to the next stage
  /// By names of criteria (docs/explore.md); what is absent has its default.
  std::map<std::string, double> weights;
  /// The same, in the criterion's unit.
  std::map<std::string, double> thresholds;
  std::optional<VarySpec> vary;      ///< empty: nothing is uncertain
  std::optional<RefineSpec> refine;  ///< empty: the listed options alone
  int line = 0;                      ///< line in the scene file, for messages
};

/// A scene: vessels, end conditions and what to solve.
struct Scene {
  std::filesystem::path file;       ///< the scene file; empty: built in memory
  std::string text;                 ///< its YAML as it was read; empty: built in C++
  std::string name;                 ///< the scene's name in results
  Units units;                      ///< units of all numbers
  std::vector<VesselSpec> vessels;  ///< in the file's order
  std::vector<EndCondition> ends;   ///< in the file's order
  /// Pairs of vessels that may touch; empty: every pair within reach. What may touch the vein of a
  /// Glenn operation may touch its stump.
  std::optional<std::vector<std::array<std::string, 2>>> contact;
  std::optional<GlennSpec> glenn;          ///< a Glenn operation; empty: none
  std::optional<EndToEndSpec> end_to_end;  ///< an end-to-end join, instead of it; empty: none
  std::optional<ExploreSpec> explore;      ///< for `vasorod explore` alone; empty: none
  std::optional<std::string> fidelity;     ///< one of fidelity_names(); empty if `accuracy` is set
  int fidelity_line = 0;                   ///< line in the scene file, for messages
  std::optional<double> accuracy;          ///< requested accuracy: RMS distance over R
  /// Bare rods: solve with n and 2n elements and extrapolate to order 4 (Richardson).
  bool extrapolate = false;

  /// The vessel with that name. Throws InputError if there is none.
  const VesselSpec& vessel(const std::string& vessel_name) const;
  /// Names of the two vessels that the operation joins; empty: there is no operation.
  std::optional<std::array<std::string, 2>> joined() const;
  /// The picks of the operation, in the order in which the scene has them.
  std::vector<const PickSpec*> picks() const;
};

}  // namespace vasorod
