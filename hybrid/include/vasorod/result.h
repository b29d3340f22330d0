// A result as plain data, independent of the solvers.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/counts.h>
#include <vasorod/named_array.h>
#include <vasorod/status.h>
#include <vasorod/types.h>

namespace vasorod {

/// How well the discrete problem was solved. NaN is written as null.
struct Certificate {
  double relative_residual = 0;  ///< largest relative residual of all solvers
  /// Whether the smallest eigenvalue of the Hessian is positive; empty: not requested.
  std::optional<bool> smallest_curvature_positive;
  std::vector<std::string> notes;  ///< remarks, one sentence each
};

/// How close the vessels are to the limits of the model. The ratios are 1 at the limit.
struct Validity {
  /// False: a ratio is 0.9 or more, or the strain exceeds 0.2. It says nothing where the state is
  /// no solution (is_solution), nor after `fit`; result.json then has null.
  bool in_range = true;
  /// The ratios are those of tubes: they leave the forks out.
  double brazier_ratio = 0,  ///< change of curvature over Brazier's critical one, long vessels only
      wrinkling_ratio = 0,   ///< bending strain over the strain of axial wrinkling
      twist_ratio = 0,       ///< shear stress of twist over the stress of wrinkling
      /// Strain of the wall's outer fibres, no unit. At forks, if walls were solved, of the wall's
      /// triangles.
      largest_strain = 0;
  std::vector<std::string> warnings;  ///< one sentence each, from a ratio of 0.7 on
};

/// The parts of the energy, stress length^3.
struct Energies {
  double rod = 0,      ///< rods [3-5]
      binding = 0,     ///< surfaces bound to rods [7]
      bending = 0,     ///< bending of the surfaces [8]; in `coupled`, of the walls
      stretching = 0,  ///< stretching of the surfaces [9]; in `coupled`, of the walls
      joining = 0,     ///< seams
      contact = 0;     ///< contact
  /// Strain energy of the wall as a continuum. Finite-element reference only; written if not zero.
  double strain = 0;
  /// The sum of all parts.
  double total() const { return rod + binding + bending + stretching + joining + contact + strain; }
};

/// Force and moment of the support on the vessel at one end, about the end's current centre, space
/// axes.
struct EndReaction {
  std::string vessel,         ///< name of the vessel
      end;                    ///< start, end, near(x, y, z) or at(f), as in the scene
  Vec3 force = Vec3::Zero(),  ///< force, stress length^2
      moment = Vec3::Zero(),  ///< moment about `center`, stress length^3
      center = Vec3::Zero();  ///< current centre of the end, length
};

/// Sums of the forces on one vessel, space axes, stress length^2. support + load + join + contact +
/// pressure + binding is zero up to `residual`.
struct Balance {
  std::string vessel;           ///< name of the vessel
  Vec3 support = Vec3::Zero(),  ///< of the supports
      load = Vec3::Zero(),      ///< of the dead loads
      join = Vec3::Zero(),      ///< of the seam
      contact = Vec3::Zero();   ///< of the contacts
  double residual = 0;          ///< length of the sum over the largest force, an end's too
  /// Of the pressure in the lumen on the wall, up to where the vessel ends; empty: none.
  std::optional<Vec3> pressure;
  /// Fidelity `paper` only: force of the rod on the surface through the binding.
  std::optional<Vec3> binding;
  /// Fidelity `paper` only: force of the surface on the rod, the opposite of `binding`. The rod is
  /// solved before the surface, so nothing balances this force.
  std::optional<Vec3> rod_unbalanced;
};

/// Contact between two vessels.
struct ContactReport {
  std::string a,              ///< name of the first vessel
      b;                      ///< name of the second vessel
  Vec3 force = Vec3::Zero();  ///< force on a, stress length^2
  double area = 0,            ///< contact area, length^2
      largest_pressure = 0;   ///< largest contact pressure, stress
  double smallest_gap = 0;    ///< smallest gap, length
};

/// Walls that pass through themselves or each other.
struct SelfIntersection {
  std::string a,     ///< name of the first vessel
      b;             ///< name of the second vessel; `a` again: through itself
  int pairs = 0;     ///< pairs of triangles that cross
  double depth = 0;  ///< from the deepest vertex on the wrong side to the next wall, length
  Vec3 where = Vec3::Zero();  ///< that vertex, length
};

/// Extremes of one vessel, and where each occurs (a point of the deformed surface or centerline).
struct VesselMetrics {
  std::string vessel;                   ///< name of the vessel
  double flattening = 0;                ///< largest 1 - H / H_rest, H a section's width
  double largest_twist_shear = 0;       ///< largest |r (u3 - u3^0)|, no unit
  std::array<double, 2> stretch{1, 1};  ///< smallest and largest v3 over its rest value
  double largest_curvature = 0;     ///< largest (u1, u2) away from forks and incisions, 1/length
  double smallest_lumen_ratio = 1;  ///< smallest lumen area over its rest value
  /// Empty: contact is not modelled.
  std::optional<double> largest_pressure,  ///< largest contact pressure, stress
      contact_area;                        ///< contact area, length^2
  /// Place of each extreme, by the names above; smallest_stretch and largest_stretch for `stretch`.
  std::map<std::string, Vec3> where;
};

/// The mouth of an operation: the opening inside the seam. Mid-wall, but for the lumen. "The cut
/// vein" of an end-to-end join is the narrower of the two vessels.
struct MouthReport {
  double area = 0,             ///< area inside the seam, length^2
      lumen = 0,               ///< that area moved inwards by half the vein's thickness, length^2
      area_ratio = 0,          ///< lumen over the lumen of the cut vein at rest
      span = 0,                ///< largest distance across, length
      width = 0,               ///< extent perpendicular to the span, length
      perimeter = 0,           ///< length of the seam, length
      perimeter_ratio = 0;     ///< perimeter over that of the cut vein at rest
  Vec3 center = Vec3::Zero();  ///< centroid, length
};

/// What a criterion says of its value.
enum class Verdict {
  fine,            ///< on the safe side of the threshold
  warning,         ///< past the threshold
  strong_warning,  ///< past the strong threshold
  not_judged,      ///< no threshold is known, or the model says nothing about the value
  unknown          ///< the state is no solution (is_solution)
};

/// The verdict's name in result.json.
std::string to_string(Verdict verdict);

/// One value of a result beside what is known of its threshold: the worst value of all vessels.
struct Criterion {
  std::string name,                 ///< lumen, mouth, twist, twist_shear, stretch, contact_pressure
      vessel;                       ///< name of the vessel with the worst value
  double value = 0;                 ///< worst value, in `unit`
  std::string unit;                 ///< degrees or mmHg; empty: a ratio
  std::optional<double> threshold,  ///< where a warning begins; empty: none is known
      strong_threshold;             ///< where a strong warning begins; empty: none is known
  Verdict verdict = Verdict::not_judged;  ///< what the thresholds say of the value
  std::string source;                     ///< where the thresholds come from, or that none is known
};

/// Radii along the axis of a vessel or of one of its branches.
struct FittedLength {
  double length = 0,        ///< along the axis, length; of a vessel: sum of its branches
      smallest_radius = 0,  ///< length
      mean_radius = 0,      ///< mean along the axis, length
      largest_radius = 0;   ///< length
};

/// One open end of a fitted vessel.
struct FittedEnd {
  std::string end,             ///< as a scene names it: start, end or near(x, y, z)
      name;                    ///< ModelFaceID of the lid that closed it; empty: there was none
  Vec3 center = Vec3::Zero(),  ///< centroid of the end's edge, length
      normal = Vec3::UnitZ();  ///< unit normal, out of the vessel
  double radius = 0;           ///< of the vessel at its end, length
};

/// What `fit` found.
struct FitReport {
  FittedLength whole;                  ///< the whole vessel
  std::vector<FittedLength> branches;  ///< the pieces between forks and ends
  std::vector<FittedEnd> ends;         ///< in the order of the input: the first is `start`
};

/// What the model contained.
struct ModelReport {
  int rod_nodes = 0,                            ///< rod nodes of all vessels
      vertices = 0,                             ///< vertices of all vessels
      triangles = 0;                            ///< triangles of all vessels
  std::vector<std::string> terms;               ///< terms of the energy
  std::map<std::string, std::string> left_out;  ///< what was left out, and why
  std::map<std::string, std::string> cleaning;  ///< per vessel: what cleaning or remeshing did
};

/// What is needed to repeat a run.
struct Environment {
  std::string blas;                           ///< name of the BLAS library
  int threads = 1;                            ///< number of threads
  std::map<std::string, std::string> inputs;  ///< file name -> "sha256..."
  /// SHA-256 of the scene file, or of the surface that was fitted; empty: a scene made in C++.
  std::string scene_hash;
};

/// A rim that a cut made.
struct CutReport {
  Vec3 pick = Vec3::Zero();   ///< the picked point; of an end as it was seen, its centre, length
  double fraction = 0,        ///< kept length over that of the way along the vessel's rod
      tilt_deg = 0,           ///< angle of the plane to the section across the vessel, degrees
      perimeter = 0;          ///< perimeter of the rim, length
  Vec3 point = Vec3::Zero(),  ///< centroid of the rim, length
      normal = Vec3::Zero();  ///< unit normal of the cut's plane, out of the kept part
};

/// An incision.
struct IncisionReport {
  Vec3 pick = Vec3::Zero();    ///< the picked point on the wall at rest, length
  double along = 0,            ///< its fraction of the way along the vessel's rod; NaN: not on it
      around_deg = 0;          ///< its angle about the rod, degrees; NaN: there is no rod
  std::string shape = "slit";  ///< slit or ellipse
  double length = 0,           ///< of the opening along the wall at rest, length
      width = 0,               ///< of the opening across the wall at rest, length; slit: 0
      perimeter = 0,           ///< of the opening's rim at rest, length
      perimeter_ratio = 0,     ///< `perimeter` over that of the cut
      removed_area = 0;        ///< of the piece of wall that was taken out, length^2; slit: 0
  std::array<Vec3, 2> ends{};  ///< its two ends at rest, length
  double opened_area = 0;      ///< area of the opened rim, length^2; NaN: nothing joined
};

/// A seam.
struct SeamReport {
  int pairs = 0;            ///< number of vertex pairs
  double rotation_deg = 0,  ///< rotation of the mouth about its axis, degrees
      axis_turn_deg = 0,    ///< angle by which the mouth's axis turns to the join, degrees
      largest_gap = 0,      ///< largest gap of a pair, length
      rms_gap = 0;          ///< root mean square gap of the pairs, length
};

/// A Glenn operation as it was performed.
struct GlennReport {
  std::string svc,                   ///< name of the vessel that was cut: the superior vena cava
      rpa;                           ///< name of the vessel that was incised: the pulmonary artery
  CutReport cut;                     ///< the cut through the SVC
  IncisionReport incision;           ///< the incision in the RPA
  SeamReport join;                   ///< the seam
  std::optional<MouthReport> mouth;  ///< the opening inside the seam; empty: no surfaces
};

/// A rim of an end-to-end join.
struct RimReport {
  std::string vessel;  ///< name of its vessel
  CutReport cut;       ///< a vessel joined by an end as it was seen: fraction 1, tilt 0
};

/// An end-to-end join as it was performed.
struct EndToEndReport {
  std::array<RimReport, 2> rims;     ///< in the scene's order
  SeamReport join;                   ///< the seam; the rotation is that of the second vessel
  int narrower = 0;                  ///< the rim of the narrower vessel
  std::optional<MouthReport> mouth;  ///< the opening inside the seam; empty: no surfaces
};

/// The discretisation of `vasorod-fem`; no other program fills this.
struct Discretisation {
  long dofs = 0;                         ///< number of degrees of freedom
  int degree = 0;                        ///< polynomial degree
  std::optional<double> error_estimate,  ///< grid convergence index; empty: one mesh only
      observed_order;                    ///< order of convergence; empty: fewer than three meshes
};

/// A rod as written to NAME_centerline.vtp: one row per node, one polyline per branch.
struct CenterlineResult {
  Points rest,                   ///< node positions at rest, n x 3, length
      current;                   ///< current node positions, n x 3, length
  std::vector<double> abscissa,  ///< arc length from the branch's root, length
      radius;                    ///< radius of the vessel, length; may be empty
  std::vector<Mat3> directors;   ///< current directors, columns d1 d2 d3
  std::vector<Vec3> u,  ///< current bending and twist, 1/length, averaged to nodes, body axes
      v,                ///< current shear and stretch, averaged to nodes, body axes
      u0,               ///< u at rest
      v0;               ///< v at rest
  /// Force of the section, stress length^2, work-conjugate to v; as v; may be empty.
  std::vector<Vec3> force,
      /// Moment of the section, stress length^3, work-conjugate to u; as u; may be empty.
      moment;
  /// Lumen area of each node's section, length^2; NaN where the section is not one closed curve;
  /// may be empty, as flattening.
  std::vector<double> lumen_area, flattening;  ///< 1 - H / H_rest, H: the narrowest mid-wall width
  std::vector<std::vector<int>> lines;         ///< node indices of each branch
};

/// One vessel as written. Per-vertex fields are empty if they were not modelled.
struct VesselResult {
  std::string name;               ///< name of the vessel
  bool obstacle = false;          ///< an obstacle, not deformable
  std::string space;              ///< LPS or RAS where the surface file says so, else empty
  Points rest,                    ///< vertex positions at rest, n x 3, length
      current;                    ///< current vertex positions, n x 3, length
  Triangles triangles;            ///< m x 3
  Eigen::VectorXd axial_stretch,  ///< stretch along the axis, per vertex; empty: written as 1
      twist_shear,                ///< r (u3 - u3^0), no unit, per vertex; empty: written as 0
      contact_pressure;           ///< contact pressure, stress, per vertex; empty: written as 0
  std::vector<NamedArray> point_arrays,        ///< the input's own arrays, one row per vertex
      cell_arrays;                             ///< the input's own arrays, one row per triangle
  std::optional<CenterlineResult> centerline;  ///< empty for obstacles
  std::optional<TriangleSurface> stump;        ///< closed surface of the part cut off
};

/// The vessels at one stage of an operation, for report.html only.
struct Stage {
  std::string title;                      ///< "rest", "cut", "incision" or "result"
  std::vector<TriangleSurface> surfaces;  ///< one per vessel
  std::vector<std::string> names;         ///< names of the vessels
};

/// A result. Lengths and stresses are in the scene's units.
struct Result {
  std::string scene,                   ///< name of the scene
      program,                         ///< name and version of the program
      fidelity;                        ///< name of the fidelity
  std::string length_unit = "mm",      ///< name of the length unit
      stress_unit = "MPa";             ///< name of the stress unit
  Status status = Status::converged;   ///< the worst status of all parts
  Certificate certificate;             ///< how well the discrete problem was solved
  Validity validity;                   ///< how close the model is to its limits
  Energies energy;                     ///< parts of the energy, stress length^3
  std::vector<EndReaction> ends;       ///< reactions of the supports
  std::vector<Balance> balance;        ///< sums of forces, per deformable vessel
  std::vector<ContactReport> contact;  ///< pairs of vessels within reach
  /// Where walls pass through themselves or each other.
  std::vector<SelfIntersection> self_intersections;
  std::vector<VesselMetrics> metrics;  ///< extremes, per deformable vessel
  std::vector<Criterion> criteria;     ///< the worst values beside their thresholds
  ModelReport model;                   ///< what the model contained
  /// Wall clock, s: read, fit, solve, write, total; factor is a part of solve.
  std::map<std::string, double> seconds;
  std::map<std::string, int> iterations;     ///< of the solvers: rod, surface
  std::optional<Counts> counts;              ///< of rods at `rod`, else of surfaces; empty: `fit`
  Environment environment;                   ///< what is needed to repeat the run
  std::optional<GlennReport> glenn;          ///< a Glenn operation; empty: none
  std::optional<EndToEndReport> end_to_end;  ///< an end-to-end join; empty: none
  std::optional<FitReport> fit;              ///< of `fit` only
  std::optional<Discretisation> discretisation;  ///< finite-element reference only
  std::vector<VesselResult> vessels;             ///< in the scene's order
  std::vector<Stage> stages;  ///< stages of the operation, for the report's pictures
};

/// What the results of all operations have.
struct JoinedVessels {
  std::array<std::string, 2> names;    ///< names of the two vessels
  const SeamReport* seam = nullptr;    ///< their seam
  const MouthReport* mouth = nullptr;  ///< the opening inside it; null: no surfaces
  std::string mouth_of;                ///< the vessel to whose lumen the mouth is compared
};

/// The vessels that an operation joined; empty: none. Points into `result`.
std::optional<JoinedVessels> joined_vessels(const Result& result);

/// The text of result.json. Every finite number reads back to the same double; non-finite numbers
/// become null.
std::string to_json(const Result& result);

}  // namespace vasorod
