// A result as data (docs/result.md). It knows no solver.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/status.h>
#include <vasorod/types.h>

namespace vasorod {

/// Not-a-number is written as null.
struct Certificate {
  double relative_residual = 0;
  std::optional<bool> smallest_curvature_positive;  ///< empty: not asked for
  std::vector<std::string> notes;
};

struct Validity {
  bool in_range = true;
  double brazier_ratio = 0, wrinkling_ratio = 0, twist_ratio = 0, largest_strain = 0;
  std::vector<std::string> warnings;
};

struct Energies {
  double rod = 0, binding = 0, bending = 0, stretching = 0, joining = 0, contact = 0;
  double strain =
      0;  ///< of the wall as a continuum: the finite-element reference only, written where not zero
  double total() const { return rod + binding + bending + stretching + joining + contact + strain; }
};

/// What the support does to the vessel at one end, about the end's current centre.
struct EndReaction {
  std::string vessel, end;  ///< end: start, end, near(x, y, z) or at(f), as in the scene
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero(), center = Vec3::Zero();
};

/// Sums of forces on one vessel. `residual` is their length over the largest of them.
struct Balance {
  std::string vessel;
  Vec3 support = Vec3::Zero(), load = Vec3::Zero(), join = Vec3::Zero(), contact = Vec3::Zero();
  double residual = 0;
  std::optional<Vec3> binding;  ///< `paper`: what the rod does to the surface through the binding
  std::optional<Vec3>
      rod_unbalanced;  ///< `paper`: what the surface leaves on the rod, which was solved first
};

struct ContactReport {
  std::string a, b;
  Vec3 force = Vec3::Zero();  ///< on a
  double area = 0, largest_pressure = 0;
  double smallest_gap = 0;
};

/// With where each extreme occurs (a point of the deformed surface or centerline).
struct VesselMetrics {
  std::string vessel;
  double flattening = 0;
  double largest_twist_shear = 0;
  std::array<double, 2> stretch{1, 1};  ///< smallest, largest v3
  double largest_curvature = 0;         ///< length of (u1, u2), 1/length
  double smallest_lumen_ratio = 1;      ///< lumen area over rest
  double largest_pressure = 0, contact_area = 0;
  std::map<std::string, Vec3> where;  ///< keys: the names above
};

struct ModelReport {
  int rod_nodes = 0, vertices = 0, triangles = 0;
  std::vector<std::string> terms;
  std::map<std::string, std::string> left_out;
  std::map<std::string, std::string> cleaning;  ///< per vessel, what reading collapsed or remeshed
};

struct Environment {
  std::string blas;
  int threads = 1;
  std::map<std::string, std::string> inputs;  ///< file name -> "sha256..."
};

struct GlennReport {
  std::string svc, rpa;
  struct {
    double fraction = 0, perimeter = 0;
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
  } cut;
  struct {
    double length = 0;
    std::array<Vec3, 2> ends{};
    double opened_area = 0;
  } incision;
  struct {
    int pairs = 0;
    double rotation_deg = 0, largest_gap = 0, rms_gap = 0;
  } join;
};

/// `vasorod-fem` only.
struct Discretisation {
  long dofs = 0;
  int degree = 0;
  std::optional<double> error_estimate, observed_order;  ///< empty: one mesh only
};

/// A rod as it is written to NAME_centerline.vtp; one row per node, polylines by branch.
struct CenterlineResult {
  Points rest, current;
  std::vector<double> abscissa, radius;  ///< arc length from the branch's root; radius may be empty
  std::vector<Mat3> directors;           ///< current, columns d1 d2 d3
  std::vector<Vec3> u, v, u0, v0;        ///< strains averaged to nodes
  std::vector<Vec3> force, moment;  ///< of the section, averaged to nodes, body axes: what v and u
                                    ///< are worked by; may be empty
  std::vector<std::vector<int>> lines;  ///< node indices per branch
};

/// One vessel as it is written. Per-vertex fields may be empty where they were not modelled
/// (written as zero).
struct VesselResult {
  std::string name;
  bool obstacle = false;
  Points rest, current;
  Triangles triangles;
  Eigen::VectorXd axial_stretch, twist_shear,
      contact_pressure;  ///< per vertex; stretch 1 and 0, 0 where empty
  std::vector<NamedArray> point_arrays, cell_arrays;  ///< the input's own, rows as above
  std::optional<CenterlineResult> centerline;         ///< obstacles have none
  std::optional<TriangleSurface> stump;               ///< closed
};

/// A view of the vessels at one stage of an operation, for report.html only.
struct Stage {
  std::string title;  ///< "rest", "cut", "incision", "result"
  std::vector<TriangleSurface> surfaces;
  std::vector<std::string> names;
};

struct Result {
  std::string scene, program, fidelity;
  std::string length_unit = "mm", stress_unit = "MPa";
  Status status = Status::converged;
  Certificate certificate;
  Validity validity;
  Energies energy;
  std::vector<EndReaction> ends;
  std::vector<Balance> balance;
  std::vector<ContactReport> contact;
  std::vector<VesselMetrics> metrics;
  ModelReport model;
  std::map<std::string, double> seconds;  ///< read, fit, factor, solve, write, total
  std::map<std::string, int> iterations;  ///< rod, surface
  Environment environment;
  std::optional<GlennReport> glenn;
  std::optional<Discretisation> discretisation;
  std::vector<VesselResult> vessels;
  std::vector<Stage> stages;
};

/// The text of result.json. Numbers read back to the same double; what is not finite is null.
std::string to_json(const Result& result);

}  // namespace vasorod
