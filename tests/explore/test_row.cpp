#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "explore/row.h"

namespace vasorod::testing {
namespace {

Result solved(const std::string& fidelity, Status status = Status::converged) {
  Result result;
  result.fidelity = fidelity;
  result.status = status;
  const auto add = [&](const std::string& name, double value, Verdict verdict) {
    Criterion& criterion = result.criteria.emplace_back();
    criterion.name = name;
    criterion.value = value;
    criterion.verdict = verdict;
  };
  add("lumen", 1, fidelity == "skin" ? Verdict::not_judged : Verdict::fine);
  add("mouth", 0.3, Verdict::strong_warning);
  add("twist_shear", 0.04, Verdict::not_judged);
  result.validity.brazier_ratio = 0.45;
  result.validity.largest_strain = 0.02;
  result.validity.warnings = {"a warning"};
  return result;
}

TEST(Row, TakesWhatIsKnownOfAResult) {
  Row row;
  take_result(solved("coupled"), row);
  EXPECT_EQ(row.ending, Ending::solved);
  EXPECT_EQ(row.criteria,
            (std::map<std::string, double>{
                {"lumen", 1}, {"mouth", 0.3}, {"twist_shear", 0.04}, {"validity", 0.5}}));
  EXPECT_EQ(row.sentences, std::vector<std::string>{"a warning"});
}

// Also where no ratio says so: walls that pass through each other.
TEST(Row, OutOfRangeIsAtLeastOneOfValidity) {
  Result result = solved("skin");
  result.validity.in_range = false;
  Row row;
  take_result(result, row);
  EXPECT_EQ(row.criteria.at("validity"), 1);
  result.validity.twist_ratio = 1.8;
  take_result(result, row);
  EXPECT_EQ(row.criteria.at("validity"), 2);
}

// Sections that are carried rigidly say nothing about how they narrow.
TEST(Row, SkinSeesNeitherLumenNorMouth) {
  Row row;
  take_result(solved("skin"), row);
  EXPECT_FALSE(row.criteria.contains("lumen"));
  EXPECT_FALSE(row.criteria.contains("mouth"));
  EXPECT_TRUE(row.criteria.contains("twist_shear"));
}

TEST(Row, AStateThatIsNoSolutionHasNoNumbers) {
  for (const Status status : {Status::iteration_limit, Status::interrupted, Status::unstable}) {
    Row row;
    row.criteria["mouth"] = 1;
    take_result(solved("coupled", status), row);
    EXPECT_TRUE(row.criteria.empty()) << to_string(status);
    EXPECT_FALSE(row.in_range);
    EXPECT_GT(row.sentences.front().size(), 20U);
  }
}

TEST(Row, ComesBackFromItsText) {
  Row row;
  row.fidelity = "coupled";
  take_result(solved("coupled"), row);
  row.criteria["twist_shear"] = 0.1 + 0.2;  // the same double
  row.sentences = {"a \"quoted\" sentence, with a comma\n", "\xc3\xa9"};
  row.seconds = 12.5;
  row.folder = "options/a-coupled";
  row.look = Look{{1, 0, 0}, {0, 0, 1}, {1, 2, 3}, 40, {{"twist_shear", {-0.1, 0.1}}}};
  Row back;
  back.option = "kept";
  read_row(row_json(row), back);
  EXPECT_EQ(back.option, "kept");
  EXPECT_EQ(back.fidelity, row.fidelity);
  EXPECT_EQ(back.ending, row.ending);
  EXPECT_EQ(back.status, row.status);
  EXPECT_EQ(back.in_range, row.in_range);
  EXPECT_EQ(back.criteria, row.criteria);
  EXPECT_EQ(back.sentences, row.sentences);
  EXPECT_EQ(back.seconds, row.seconds);
  EXPECT_EQ(back.folder, row.folder);
  ASSERT_TRUE(back.look);
  EXPECT_EQ(back.look->centre, row.look->centre);
  EXPECT_EQ(back.look->ranges, row.look->ranges);
}

TEST(Row, DamagedTextIsRefused) {
  Row row;
  const std::string whole = row_json(row);
  for (const std::string& text :
       {std::string(), std::string("{}"), whole.substr(0, whole.size() / 2), std::string("[1]")})
    EXPECT_THROW(read_row(text, row), InputError) << text;
}

}  // namespace
}  // namespace vasorod::testing
