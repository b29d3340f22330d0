// The text of a scene file with another plan in it. Everything else stays as the user wrote it:
// comments, order, spacing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vasorod::planner {

/// New values as YAML on one line.
struct SceneEdit {
  /// Keys of `surgery: glenn:`; what is not named stays as it is. A key that is not there yet is
  /// put behind `incision`.
  std::vector<std::pair<std::string, std::string>> glenn;
  /// In place of `fidelity` or `accuracy`; empty: stays.
  std::optional<std::string> fidelity;
};

struct EditedScene {
  std::string text;
  /// One sentence where more than the values had to be written anew; empty: nothing else changed.
  std::optional<std::string> note;
};

/// Edits the text of a scene with `surgery: glenn:`. Where its lines cannot be edited safely (flow
/// style, anchors), the block `surgery` is written anew, and where that is not safe either, the
/// whole file; the outcome always means the old scene with the new values. A comment behind a value
/// that changed begins with "was:" from then on. Throws InputError where the text is no such scene.
EditedScene edited_scene(const std::string& text, const SceneEdit& edit);

}  // namespace vasorod::planner
