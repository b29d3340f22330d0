// Proposes a scene for surfaces of vessels.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vasorod {

/// What to propose a scene for.
struct ProposalRequest {
  std::vector<std::filesystem::path> surfaces;  ///< VTP, STL, PLY or OBJ, one vessel each
  std::filesystem::path scene;                  ///< the file that the scene will be in
  /// mm, cm or m; empty: what the files state (field data Units of VTP), else guessed from the
  /// radii.
  std::optional<std::string> length_unit;
  /// Called with one line of text at each step.
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// A scene that runs.
struct Proposal {
  std::string text;                ///< the scene file
  std::vector<std::string> found,  ///< one line for each vessel and for the operation
      decide;                      ///< one line for each thing that a user has to decide
};

/// Reads and fits the surfaces, proposes units, roles, walls and held ends, and, where a superior
/// vena cava and a pulmonary artery are among them, a cut and an incision that fit: each is tried
/// by building the operation. Surfaces that are closed become obstacles. Throws InputError (one
/// sentence) for files that are no vessels, two of one name, or none with an open end.
Proposal propose_scene(const ProposalRequest& request);

}  // namespace vasorod
