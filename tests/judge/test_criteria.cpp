#include <gtest/gtest.h>
#include <map>

#include "judge/criteria.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

Result paper_result() {
  Result result = test::example_result();
  result.fidelity = "paper";
  return result;
}

Criterion named(const Result& result, const std::string& name) {
  for (const Criterion& criterion : criteria_of(result))
    if (criterion.name == name) return criterion;
  ADD_FAILURE() << "no criterion " << name;
  return {};
}

std::vector<std::string> names(const Result& result) {
  std::vector<std::string> all;
  for (const Criterion& criterion : criteria_of(result)) all.push_back(criterion.name);
  return all;
}

TEST(Criteria, ALumenWarnsBelowSixAndStronglyBelowFourTenths) {
  const std::map<double, Verdict> expected{{1.0, Verdict::fine},
                                           {0.6, Verdict::fine},
                                           {0.59, Verdict::warning},
                                           {0.4, Verdict::warning},
                                           {0.39, Verdict::strong_warning},
                                           {0.0, Verdict::strong_warning}};
  for (const auto& [ratio, verdict] : expected) {
    Result result = paper_result();
    result.metrics[0].smallest_lumen_ratio = ratio;
    const Criterion lumen = named(result, "lumen");
    EXPECT_EQ(lumen.value, ratio);
    EXPECT_EQ(lumen.verdict, verdict) << ratio;
    EXPECT_EQ(lumen.threshold, 0.6);
    EXPECT_EQ(lumen.strong_threshold, 0.4);
  }
}

TEST(Criteria, AMouthIsJudgedByTheThresholdsOfALumen) {
  Result result = paper_result();
  EXPECT_EQ(names(result)[1], "twist") << "no mouth where none was measured";
  for (const auto& [ratio, verdict] :
       {std::pair{0.6, Verdict::fine}, {0.5, Verdict::warning}, {0.3, Verdict::strong_warning}}) {
    result.glenn->mouth = MouthReport{};
    result.glenn->mouth->area_ratio = ratio;
    const Criterion mouth = named(result, "mouth");
    EXPECT_EQ(mouth.value, ratio);
    EXPECT_EQ(mouth.vessel, "svc");
    EXPECT_EQ(mouth.verdict, verdict) << ratio;
  }
}

TEST(Criteria, TheWorstVesselCounts) {
  Result result = paper_result();
  VesselResult rpa = result.vessels[0];
  rpa.name = "rpa";
  result.vessels.push_back(rpa);
  result.metrics.push_back(result.metrics[0]);
  result.metrics[1].vessel = "rpa";
  result.metrics[1].smallest_lumen_ratio = 0.3;
  result.metrics[1].stretch = {0.7, 1.1};
  result.metrics[0].largest_twist_shear = 0.3;
  EXPECT_EQ(named(result, "lumen").vessel, "rpa");
  EXPECT_EQ(named(result, "stretch").vessel, "rpa");
  EXPECT_EQ(named(result, "stretch").value, 0.7) << "further from 1 than 1.21";
  EXPECT_EQ(named(result, "twist_shear").vessel, "svc");
}

// The example's tube is twisted at the rate 0.01 over a length of 60: 0.6 radians.
TEST(Criteria, TwistIsTheAngleBetweenTheSectionsThatTurnedMost) {
  const Result result = paper_result();
  EXPECT_NEAR(named(result, "twist").value, 0.6 * 180 / M_PI, 1e-9);
  for (const auto& [degrees, verdict] :
       {std::pair{89.0, Verdict::fine}, {91.0, Verdict::warning}, {181.0, Verdict::strong_warning}})
    for (const double sign : {1.0, -1.0}) {
      Result turned = result;
      for (Vec3& u : turned.vessels[0].centerline->u) u.z() = sign * degrees * M_PI / 180 / 60;
      EXPECT_NEAR(named(turned, "twist").value, degrees, 1e-9);
      EXPECT_EQ(named(turned, "twist").verdict, verdict) << degrees;
    }
}

TEST(Criteria, TwistThereAndBackIsStillTwist) {
  Result result = paper_result();
  CenterlineResult& line = *result.vessels[0].centerline;
  for (std::size_t i = 0; i < line.u.size(); ++i)
    line.u[i].z() = i < 15 ? 0.05 : i == 15 ? 0.0 : -0.05;  // 30 there, 30 back
  // The trapezoidal rule over the corner's two elements of length 2 is exact.
  EXPECT_NEAR(named(result, "twist").value, (0.05 * 28 + 0.05) * 180 / M_PI, 1e-9);
}

TEST(Criteria, WhatHasNoKnownThresholdIsNotJudgedAndSaysSo) {
  Result result = paper_result();
  result.metrics[0].largest_twist_shear = 10;
  result.metrics[0].stretch = {0.1, 9};
  result.metrics[0].largest_pressure = 100;
  for (const char* name : {"twist_shear", "stretch", "contact_pressure"}) {
    const Criterion criterion = named(result, name);
    EXPECT_EQ(criterion.verdict, Verdict::not_judged) << name;
    EXPECT_FALSE(criterion.threshold) << name;
    EXPECT_EQ(criterion.source, "no threshold is known") << name;
  }
}

TEST(Criteria, WithoutContactThereIsNoPressure) {
  Result result = paper_result();
  for (VesselMetrics& metrics : result.metrics) metrics.largest_pressure.reset();
  result.contact.clear();
  const auto criteria = criteria_of(result);
  EXPECT_TRUE(std::none_of(criteria.begin(), criteria.end(), [](const Criterion& criterion) {
    return criterion.name == "contact_pressure";
  }));
}

TEST(Criteria, APressureIsInMillimetresOfMercury) {
  Result result = paper_result();  // 1e-3 MPa
  EXPECT_NEAR(named(result, "contact_pressure").value, 7.50062, 1e-5);
  EXPECT_EQ(named(result, "contact_pressure").unit, "mmHg");
  result.stress_unit = "kPa";
  EXPECT_NEAR(named(result, "contact_pressure").value, 7.50062e-3, 1e-8);
  result.stress_unit = "Pa";
  EXPECT_NEAR(named(result, "contact_pressure").value, 7.50062e-6, 1e-11);
}

TEST(Criteria, WhatTheFidelityDidNotModelIsNotCalledFine) {
  Result skin = test::example_result();
  skin.fidelity = "skin";
  EXPECT_EQ(named(skin, "lumen").verdict, Verdict::not_judged);
  skin.metrics[0].smallest_lumen_ratio = 0.3;
  EXPECT_EQ(named(skin, "lumen").verdict, Verdict::strong_warning);
  Result rod = test::example_result();
  rod.fidelity = "rod";
  for (VesselResult& vessel : rod.vessels) vessel.rest.resize(0, 3);
  for (VesselMetrics& metrics : rod.metrics) metrics.largest_pressure.reset();
  rod.contact.clear();
  EXPECT_EQ(names(rod), (std::vector<std::string>{"twist", "twist_shear", "stretch"}));
}

TEST(Criteria, AStateThatIsNoSolutionIsNotJudged) {
  for (const Status status : {Status::interrupted, Status::iteration_limit, Status::unstable}) {
    Result result = paper_result();
    result.status = status;
    ASSERT_EQ(criteria_of(result).size(), 5U);
    for (const Criterion& criterion : criteria_of(result))
      EXPECT_EQ(criterion.verdict, Verdict::unknown) << criterion.name;
  }
  EXPECT_TRUE(criteria_of(Result{}).empty());
}

}  // namespace
}  // namespace vasorod
