#include "explore/table.h"

#include <algorithm>
#include <cmath>

#include "data/sentence.h"

namespace vasorod {
namespace {

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string cell(double value) {
  return std::isfinite(value) ? number_text(value) : "";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : "; ") + word;
  return text;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + cells[i];
  return line + "\r\n";
}

// Criteria and score, of which samples give intervals.
std::vector<std::string> spread_names() {
  std::vector<std::string> names{"score"};
  for (const RankingCriterion& criterion : ranking_criteria()) names.push_back(criterion.name);
  return names;
}

void add_spread(const std::optional<Spread>& spread, std::vector<std::string>& cells) {
  for (const int count :
       {spread ? spread->samples : 0, spread ? spread->converged : 0, spread ? spread->first : 0})
    cells.push_back(spread ? std::to_string(count) : "");
  for (const std::string& name : spread_names())
    for (const std::size_t end : {0, 1})
      cells.push_back(
          spread && spread->intervals.contains(name) ? cell(spread->intervals.at(name)[end]) : "");
}

std::vector<std::string> cells_of(const RankedRow& ranked, const std::vector<std::string>& keys,
                                  bool with_spread) {
  const Row& row = ranked.row;
  const bool solved = row.ending == Ending::solved;
  std::vector<std::string> cells{ranked.rank > 0 ? std::to_string(ranked.rank) : "", row.option};
  for (const std::string& key : keys) {
    std::string value;
    for (const auto& [name, text] : row.values)
      if (name == key) value = text;
    cells.push_back(cell(value));
  }
  for (const std::string& text :
       {row.fidelity, to_string(row.ending), solved ? to_string(row.status) : "",
        row.in_range ? std::string(*row.in_range ? "true" : "false") : "", to_string(ranked.mark)})
    cells.push_back(cell(text));
  cells.push_back(cell(ranked.score));
  for (const RankingCriterion& criterion : ranking_criteria()) {
    const auto value = row.criteria.find(criterion.name);
    cells.push_back(value == row.criteria.end() ? "" : cell(value->second));
  }
  if (with_spread) add_spread(ranked.spread, cells);
  cells.push_back(row.refined ? "true" : "false");
  cells.push_back(cell(joined(ranked.past)));
  cells.push_back(solved ? cell(row.seconds) : "");
  cells.push_back(cell(row.folder));
  cells.push_back(cell(joined(row.sentences)));
  return cells;
}

}  // namespace

std::string options_csv(const std::vector<RankedRow>& rows, const std::vector<std::string>& keys) {
  std::vector<std::string> names{"rank", "option"};
  names.insert(names.end(), keys.begin(), keys.end());
  for (const char* name : {"fidelity", "ending", "status", "in_range", "mark", "score"})
    names.emplace_back(name);
  for (const RankingCriterion& criterion : ranking_criteria()) names.push_back(criterion.name);
  const bool with_spread = std::any_of(rows.begin(), rows.end(),
                                       [](const RankedRow& row) { return row.spread.has_value(); });
  if (with_spread) {
    for (const char* name : {"samples", "samples_converged", "samples_first"})
      names.emplace_back(name);
    for (const std::string& name : spread_names())
      for (const char* end : {"_low", "_high"}) names.push_back(name + end);
  }
  for (const char* name : {"refined", "past", "seconds", "folder", "sentence"})
    names.emplace_back(name);
  std::string csv = line_of(names);
  for (const RankedRow& row : rows) csv += line_of(cells_of(row, keys, with_spread));
  return csv;
}

}  // namespace vasorod
