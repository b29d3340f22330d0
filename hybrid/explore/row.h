// What is kept of one option: its row of the table.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <vasorod/result.h>

namespace vasorod {

/// How an option ended.
enum class Ending {
  open,       ///< it was not solved yet
  solved,     ///< there is a result, whatever its status
  not_built,  ///< the operation cannot be built, or the fidelity cannot solve it
  failed      ///< the program failed on it; the next run tries again
};

/// The ending's name in files.
std::string to_string(Ending ending);

/// How a kept result is drawn best: options side by side share one side and one scale per field.
struct Look {
  Vec3 towards_eye = Vec3::UnitX(), up = Vec3::UnitZ(), centre = Vec3::Zero();  ///< centre: length
  double height = 1;  ///< of what is visible, length
  /// Values of the first and the last colour, by names of drawn_fields()
  /// (report/report_pictures.h).
  std::map<std::string, std::array<double, 2>> ranges;
};

/// One option at the last stage that it reached.
struct Row {
  std::vector<std::pair<std::string, std::string>> values;  ///< as in Option
  /// First letters of a hash of all that its numbers depend on but the fidelity.
  std::string option;
  bool refined = false;                    ///< found by a search near the best, not listed
  int stage = -1;                          ///< index of the stage; -1: none
  std::string fidelity;                    ///< of that stage
  Ending ending = Ending::open;            ///< how it ended there
  Status status = Status::interrupted;     ///< of the result, if it is solved
  std::optional<bool> in_range;            ///< of the model; empty: nobody can say
  std::map<std::string, double> criteria;  ///< by the names of ranking_criteria(); known ones only
  std::vector<std::string> sentences;      ///< why it ended so, or the result's warnings
  double seconds = 0;                      ///< wall clock of its solve
  std::string folder;        ///< of its result, below that of the exploration; empty: not kept
  std::optional<Look> look;  ///< of a kept result

  /// OPTION-FIDELITY: the name of its file and its folder.
  std::string name() const { return option + "-" + fidelity; }
};

/// What the row has of a result. A value that the fidelity cannot see is left out: how a lumen or a
/// mouth narrows where sections are carried rigidly, and everything of a state that is no solution.
/// `validity`: the largest of the model's ratios over its limit; at least 1 where the model is out
/// of its range for another reason, as where walls pass through each other.
void take_result(const Result& result, Row& row);

/// Everything but `values`, `option` and `stage` as JSON, and back. Throws InputError where the
/// text is none of ours.
std::string row_json(const Row& row);
void read_row(const std::string& json, Row& row);

}  // namespace vasorod
