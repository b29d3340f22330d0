#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "predict/name_faults.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

Result good_result() {
  Result result = test::example_result();
  result.fidelity = "paper";
  result.validity = {};
  result.certificate.notes.clear();
  return result;
}

TEST(NameFaults, AGoodResultIsLeftAsItIs) {
  Result result = good_result();
  name_faults(result);
  EXPECT_EQ(to_json(result), to_json(good_result()));
}

TEST(NameFaults, WhatIsNotFiniteIsNamedAndNeverGreen) {
  const std::vector<std::pair<std::string, std::function<void(Result&)>>> faults = {
      {"relative residual", [](Result& r) { r.certificate.relative_residual = nan; }},
      {"rod energy", [](Result& r) { r.energy.rod = nan; }},
      {"stretching energy", [](Result& r) { r.energy.stretching = infinity; }},
      {"twist ratio", [](Result& r) { r.validity.twist_ratio = nan; }},
      {"moment at start of svc", [](Result& r) { r.ends[0].moment.y() = nan; }},
      {"balance of svc", [](Result& r) { r.balance[0].join.x() = -infinity; }},
      {"largest contact pressure of svc and aorta",
       [](Result& r) { r.contact[0].largest_pressure = nan; }},
      {"largest curvature of svc", [](Result& r) { r.metrics[0].largest_curvature = nan; }},
      {"place of flattening of svc", [](Result& r) { r.metrics[0].where["flattening"].z() = nan; }},
      {"seam's largest gap", [](Result& r) { r.glenn->join.largest_gap = nan; }},
      {"surface of svc", [](Result& r) { r.vessels[0].current(7, 1) = nan; }},
      {"twist shear of svc", [](Result& r) { r.vessels[0].twist_shear[3] = infinity; }},
      {"strains of svc", [](Result& r) { r.vessels[0].centerline->u[2].x() = nan; }},
      {"directors of svc", [](Result& r) { r.vessels[0].centerline->directors[4](0, 0) = nan; }},
  };
  for (const auto& [name, break_it] : faults) {
    Result result = good_result();
    break_it(result);
    name_faults(result);
    EXPECT_EQ(result.status, Status::iteration_limit) << name;
    EXPECT_FALSE(result.validity.in_range) << name;
    EXPECT_TRUE(std::isnan(result.certificate.relative_residual)) << name;
    EXPECT_FALSE(result.certificate.smallest_curvature_positive) << name;
    ASSERT_EQ(result.certificate.notes.size(), 1U) << name;
    EXPECT_NE(result.certificate.notes[0].find("not finite: " + name + ";"), std::string::npos)
        << result.certificate.notes[0];
  }
}

TEST(NameFaults, WhatSaysThatThereIsNoneIsNoFault) {
  Result result = good_result();
  result.contact[0].smallest_gap = infinity;  // no walls face each other
  name_faults(result);
  EXPECT_EQ(result.status, Status::converged);
  result.fidelity = "rod";
  result.glenn->join.largest_gap = result.glenn->join.rms_gap = nan;  // nothing was joined
  result.glenn->incision.opened_area = nan;
  name_faults(result);
  EXPECT_EQ(result.status, Status::converged);
}

TEST(NameFaults, AnInterruptedResultStaysSo) {
  Result result = good_result();
  result.status = Status::interrupted;
  result.energy.rod = nan;
  name_faults(result);
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_FALSE(result.validity.in_range);
}

TEST(NameFaults, AnIterationLimitHasAReason) {
  Result result = good_result();
  result.status = Status::iteration_limit;
  result.certificate.relative_residual = 0.25;
  name_faults(result);
  ASSERT_EQ(result.certificate.notes.size(), 1U);
  EXPECT_NE(result.certificate.notes[0].find("residual is 0.25"), std::string::npos);
}

TEST(NameFaults, ANoteAboutSomethingElseIsNoReason) {
  Result result = good_result();
  result.status = Status::iteration_limit;
  result.certificate.relative_residual = 0.25;
  result.certificate.notes = {"accuracy 0.02 of R: coupled: the dearest, without a promise"};
  name_faults(result);
  ASSERT_EQ(result.certificate.notes.size(), 2U);
  EXPECT_NE(result.certificate.notes[1].find("residual is 0.25"), std::string::npos);
  result.certificate.notes = {"ended after 30 multiplier updates without an equilibrium"};
  name_faults(result);
  EXPECT_EQ(result.certificate.notes.size(), 1U) << "it has its reason";
}

}  // namespace
}  // namespace vasorod
