// Compares two results of one scene, A against B: displacements and reactions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Distances between the displacements of the same material points, divided by the vessel's rest
/// radius R (no unit).
struct Distances {
  /// Root mean square, weighted by A's rest area (surface) or rest length (centerline).
  double rms = 0;
  double largest = 0;              ///< the largest distance over R
  Vec3 largest_at = Vec3::Zero();  ///< rest point of A where the largest distance occurs, length
};

/// The comparison of one deformable vessel.
struct VesselComparison {
  std::string name;  ///< the vessel's name in the scene
  /// R, length: the mean of A's centerline radii weighted by length; if A has none, B's; else the
  /// mean of perimeter / (2 pi) over A's open ends.
  double radius = 0;
  /// Each rest point of A against the closest rest point on B's triangles. A point on the boundary
  /// is moved a quarter of the way into its triangles, so that a lip of an incision, which lies on
  /// the other lip at rest, meets its own lip of B. Empty if one of the
  /// results has no surface.
  std::optional<Distances> surface;
  /// Each rest node of A against the closest rest point on B's polylines. Empty if one of the
  /// results has no centerline.
  std::optional<Distances> centerline;
  /// Largest distance from a rest point of A to the closest rest point of B, over R. Not zero where
  /// the meshes differ, or the faces of the wall that they describe.
  double rest_distance = 0;
};

/// The support's force and moment at one end. B's moment is moved to A's centre.
struct ReactionComparison {
  std::string vessel,           ///< name of the vessel
      end;                      ///< name of the end, as in EndReaction
  Vec3 force_a = Vec3::Zero(),  ///< force in A, stress length^2, space axes
      force_b = Vec3::Zero(),   ///< force in B
      moment_a = Vec3::Zero(),  ///< moment in A, stress length^3, space axes
      moment_b = Vec3::Zero();  ///< moment in B, about A's centre
  /// |A - B| over the largest force at any of A's ends; NaN (JSON: null) where all are zero.
  double force_difference = 0;
  /// |A - B| over the largest moment at any of A's ends; NaN (JSON: null) where all are zero.
  double moment_difference = 0;
};

/// An end whose support only one of the two results states.
struct LoneEnd {
  std::string vessel,  ///< name of the vessel
      end;             ///< name of the end, as in EndReaction
  bool in_a = false;   ///< stated by A; else by B
};

/// Where one of the two results comes from.
struct ComparedResult {
  std::string folder,  ///< path of the result folder
      program,         ///< name and version of the program
      fidelity,        ///< name of the fidelity
      status;          ///< name of the status
  double seconds = 0;  ///< total wall-clock time, s; NaN if unknown
};

/// Two results of one scene, compared.
struct Comparison {
  std::string scene,                          ///< name of the scene, common to both results
      length_unit,                            ///< mm, cm or m
      stress_unit;                            ///< name of the stress unit
  ComparedResult a,                           ///< the first result
      b;                                      ///< the second result
  std::vector<VesselComparison> vessels;      ///< deformable vessels, in A's order
  std::vector<ReactionComparison> reactions;  ///< ends that both support, in A's order
  /// Ends that only the fidelity of one supports: `paper` solves no rod of an artery and states
  /// none of its supports, `coupled` does.
  std::vector<LoneEnd> lone_ends;
};

/// Reads and compares two result folders. Throws InputError (one sentence) if a folder is not a
/// result, or if the results belong to different scenes: another name, unit, vessel or input file,
/// rest shapes more than half a radius apart, or other ends: of one fidelity any, of two fidelities
/// if each has an end that the other has not.
Comparison compare_results(const std::filesystem::path& folder_a,
                           const std::filesystem::path& folder_b);

/// The comparison as JSON, with a final line feed. Non-finite numbers become null.
std::string comparison_json(const Comparison& comparison);

/// The comparison as a table for a terminal.
std::string comparison_table(const Comparison& comparison);

}  // namespace vasorod
