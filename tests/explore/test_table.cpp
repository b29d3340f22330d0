#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "explore/table.h"

namespace vasorod::testing {
namespace {

// An independent reader of RFC 4180.
std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> lines(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
      lines.back().back() += csv[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      lines.back().emplace_back();
    else if (!quoted && c == '\r')
      continue;
    else if (!quoted && c == '\n')
      lines.emplace_back(1);
    else
      lines.back().back() += c;
  }
  lines.pop_back();
  return lines;
}

TEST(Table, EveryLineHasEveryColumnAndTextsComeBack) {
  RankedRow solved;
  solved.row.option = "0123456789abcdef";
  solved.row.values = {{"cut_along", "0.5"}, {"rotation_deg", "auto"}};
  solved.row.fidelity = "skin";
  solved.row.ending = Ending::solved;
  solved.row.status = Status::converged;
  solved.row.in_range = true;
  solved.row.criteria = {{"twist_shear", 0.125}};
  solved.row.sentences = {"one, \"quoted\"", "two\nlines"};
  solved.rank = 1;
  solved.score = 0.25;
  solved.past = {"mouth", "lumen"};
  RankedRow refused;
  refused.row.ending = Ending::not_built;
  refused.score = std::numeric_limits<double>::quiet_NaN();
  const auto lines = cells_of(options_csv({solved, refused}, {"cut_along", "rotation_deg"}));
  ASSERT_EQ(lines.size(), 3U);
  for (const auto& line : lines) EXPECT_EQ(line.size(), lines[0].size());
  const auto cell = [&](std::size_t line, const std::string& name) {
    for (std::size_t k = 0; k < lines[0].size(); ++k)
      if (lines[0][k] == name) return lines[line][k];
    return "no column " + name;
  };
  using Cells = std::vector<std::pair<std::string, std::string>>;
  for (const auto& [name, value] : Cells{{"rank", "1"},
                                         {"option", "0123456789abcdef"},
                                         {"rotation_deg", "auto"},
                                         {"status", "converged"},
                                         {"score", "0.25"},
                                         {"twist_shear", "0.125"},
                                         {"mouth", ""},
                                         {"past", "mouth; lumen"},
                                         {"sentence", "one, \"quoted\"; two\nlines"},
                                         {"refined", "false"},
                                         {"samples", "no column samples"}})
    EXPECT_EQ(cell(1, name), value) << name;
  for (const auto& [name, value] :
       Cells{{"rank", ""}, {"ending", "not_built"}, {"status", ""}, {"score", ""}})
    EXPECT_EQ(cell(2, name), value) << name;
}

TEST(Table, IntervalsHaveColumnsWhereThereAreSome) {
  RankedRow sampled, other;
  sampled.row.refined = true;
  sampled.spread = Spread{20, 19, 15, {{"twist_shear", {0.25, 0.5}}, {"score", {1, 2}}}};
  const auto lines = cells_of(options_csv({sampled, other}, {}));
  for (const auto& line : lines) ASSERT_EQ(line.size(), lines[0].size());
  const auto cell = [&](std::size_t line, const std::string& name) {
    const auto found = std::find(lines[0].begin(), lines[0].end(), name);
    return found == lines[0].end()
               ? "no column " + name
               : lines[line][static_cast<std::size_t>(found - lines[0].begin())];
  };
  EXPECT_EQ(cell(1, "refined"), "true");
  EXPECT_EQ(cell(1, "samples"), "20");
  EXPECT_EQ(cell(1, "samples_converged"), "19");
  EXPECT_EQ(cell(1, "samples_first"), "15");
  EXPECT_EQ(cell(1, "twist_shear_low"), "0.25");
  EXPECT_EQ(cell(1, "twist_shear_high"), "0.5");
  EXPECT_EQ(cell(1, "score_high"), "2");
  EXPECT_EQ(cell(1, "mouth_low"), "");
  EXPECT_EQ(cell(2, "samples"), "");
  EXPECT_EQ(cell(2, "score_low"), "");
}

}  // namespace
}  // namespace vasorod::testing
