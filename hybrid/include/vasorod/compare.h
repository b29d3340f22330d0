// How far apart two results of one scene are: A against B.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Distances between the displacements of the same material points, over the vessel's rest radius
/// R.
struct Distances {
  double rms = 0;  ///< weighted by A's rest area (surface) or rest length (centerline)
  double largest = 0;
  Vec3 largest_at = Vec3::Zero();  ///< A's rest point where it occurs, length unit
};

struct VesselComparison {
  std::string name;
  double radius = 0;  ///< R: mean of A's centerline radii by length, else B's, else of A's open
                      ///< ends' perimeters over 2 pi
  std::optional<Distances>
      surface;  ///< each rest point of A against the closest rest point on B's triangles
  std::optional<Distances>
      centerline;  ///< each rest node of A against the closest rest point on B's polylines
  double rest_distance = 0;  ///< the largest distance to that closest rest point, over R: meshes
                             ///< and faces of the wall differ
};

/// The support's force and moment at one end; B's moment is moved to A's centre.
struct ReactionComparison {
  std::string vessel, end;
  Vec3 force_a = Vec3::Zero(), force_b = Vec3::Zero(), moment_a = Vec3::Zero(),
       moment_b = Vec3::Zero();
  double force_difference =
      0;  ///< |A - B| over the largest force of A's ends; null where A has none
  double moment_difference = 0;  ///< likewise for moments
};

struct ComparedResult {
  std::string folder, program, fidelity, status;
  double seconds = 0;  ///< total; NaN where it is not known
};

struct Comparison {
  std::string scene, length_unit, stress_unit;
  ComparedResult a, b;
  std::vector<VesselComparison> vessels;  ///< the deformable ones, in A's order
  std::vector<ReactionComparison> reactions;
};

/// Reads and compares two result folders. Throws InputError, one sentence, where a folder is not a
/// result or where the two are not of one scene: another name, unit, vessel, end or input file, or
/// rest shapes more than half a radius apart.
Comparison compare_results(const std::filesystem::path& folder_a,
                           const std::filesystem::path& folder_b);

/// As JSON, with a line feed at its end; what is not finite is null.
std::string comparison_json(const Comparison& comparison);

/// As a table for a terminal.
std::string comparison_table(const Comparison& comparison);

}  // namespace vasorod
