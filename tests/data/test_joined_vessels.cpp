#include <gtest/gtest.h>

#include <vasorod/result.h>

namespace vasorod {
namespace {

TEST(JoinedVessels, AreThoseOfEitherOperation) {
  Result result;
  EXPECT_FALSE(joined_vessels(result).has_value());
  result.glenn.emplace();
  result.glenn->svc = "vein";
  result.glenn->rpa = "artery";
  auto joined = joined_vessels(result);
  EXPECT_EQ(joined->names, (std::array<std::string, 2>{"vein", "artery"}));
  EXPECT_EQ(joined->mouth_of, "vein");
  EXPECT_EQ(joined->seam, &result.glenn->join);
  EXPECT_EQ(joined->mouth, nullptr);
  result.glenn->mouth.emplace();
  EXPECT_EQ(joined_vessels(result)->mouth, &*result.glenn->mouth);
}

TEST(JoinedVessels, TheMouthIsComparedToTheNarrower) {
  Result result;
  result.end_to_end.emplace();
  result.end_to_end->rims[0].vessel = "wide";
  result.end_to_end->rims[1].vessel = "narrow";
  EXPECT_EQ(joined_vessels(result)->mouth_of, "wide");
  result.end_to_end->narrower = 1;
  const auto joined = joined_vessels(result);
  EXPECT_EQ(joined->mouth_of, "narrow");
  EXPECT_EQ(joined->names[1], "narrow");
  EXPECT_EQ(joined->seam, &result.end_to_end->join);
}

}  // namespace
}  // namespace vasorod
