#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include <vasorod/result_folder.h>

#include "result/example_result.h"
#include "result/unknown_validity.h"

namespace vasorod {
namespace {

using Json = nlohmann::json;

Vec3 vector(const Json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

TEST(WriteJson, HasEveryKeyOfTheContract) {
  const Json v = Json::parse(to_json(test::example_result()));
  EXPECT_EQ(v.at("schema"), 1);
  EXPECT_EQ(v.at("scene"), "example");
  EXPECT_EQ(v.at("program"), "vasorod 0.1.0");
  EXPECT_EQ(v.at("fidelity"), "skin");
  EXPECT_EQ(v.at("status"), "converged");
  EXPECT_EQ(v.at("certificate").at("relative_residual"), 1.0 / 3.0);
  EXPECT_TRUE(v.at("certificate").at("smallest_curvature_positive").is_null());
  EXPECT_EQ(v.at("certificate").at("notes").size(), 1u);
  EXPECT_EQ(v.at("validity").at("in_range"), false);
  EXPECT_EQ(v.at("validity").at("brazier_ratio"), 0.1);
  EXPECT_EQ(v.at("validity").at("wrinkling_ratio"), 0.15);
  EXPECT_EQ(v.at("validity").at("twist_ratio"), 0.2);
  EXPECT_EQ(v.at("validity").at("largest_strain"), 0.3);
  EXPECT_EQ(v.at("validity").at("warnings").at(0),
            "svc bends to 0.95 of the curvature where a tube kinks.");
  double total = 0;
  for (const char* key : {"rod", "binding", "bending", "stretching", "joining", "contact"})
    total += v.at("energy").at(key).get<double>();
  EXPECT_NEAR(v.at("energy").at("total").get<double>(), total, 1e-13);
  EXPECT_EQ(v.at("energy").at("joining"), 5.5);
  const Json& end = v.at("ends").at(0);
  EXPECT_EQ(end.at("vessel"), "svc");
  EXPECT_EQ(end.at("end"), "start");
  EXPECT_EQ(vector(end.at("force")), Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(vector(end.at("moment")), Vec3(1e-300, 0, 1e17));
  EXPECT_EQ(vector(end.at("center")), Vec3(1, 2, 3));
  const Json& balance = v.at("balance").at(0);
  EXPECT_EQ(vector(balance.at("support")), Vec3(1, 2, 3));
  EXPECT_EQ(vector(balance.at("load")), Vec3(4, 5, 6));
  EXPECT_EQ(vector(balance.at("join")), Vec3(7, 8, 9));
  EXPECT_EQ(vector(balance.at("contact")), Vec3(10, 11, 12));
  EXPECT_EQ(balance.at("residual"), 1e-9);
  EXPECT_EQ(vector(balance.at("binding")), Vec3(0.5, 0.25, 0.125));
  EXPECT_FALSE(balance.contains("rod_unbalanced"));
  const Json& contact = v.at("contact").at(0);
  EXPECT_EQ(contact.at("a"), "svc");
  EXPECT_EQ(contact.at("b"), "aorta");
  EXPECT_EQ(vector(contact.at("force")), Vec3(0.1, 0, 0));
  EXPECT_EQ(contact.at("area"), 2.5);
  EXPECT_EQ(contact.at("largest_pressure"), 1e-3);
  EXPECT_EQ(contact.at("smallest_gap"), -0.02);
  const Json& metrics = v.at("metrics").at(0);
  EXPECT_EQ(metrics.at("vessel"), "svc");
  EXPECT_EQ(metrics.at("flattening"), 0.05);
  EXPECT_EQ(metrics.at("largest_twist_shear"), 0.05);
  EXPECT_EQ(metrics.at("stretch"), Json::array({0.99, 1.21}));
  EXPECT_EQ(metrics.at("largest_curvature"), 0.022);
  EXPECT_EQ(metrics.at("smallest_lumen_ratio"), 0.9);
  EXPECT_EQ(vector(metrics.at("where").at("flattening")), Vec3(1, 2, 3));
  const Json& model = v.at("model");
  EXPECT_EQ(model.at("rod_nodes"), 31);
  EXPECT_EQ(model.at("vertices"), 744);
  EXPECT_EQ(model.at("triangles"), 1440);
  EXPECT_EQ(model.at("terms"), Json::array({"bending", "binding"}));
  EXPECT_EQ(model.at("left_out").at("contact of heart"), "no vessel within reach");
  EXPECT_EQ(v.at("seconds").at("solve"), 0.4);
  EXPECT_EQ(v.at("iterations").at("surface"), 42);
  EXPECT_EQ(v.at("counts"), Json({{"factorisations", 3},
                                  {"solves", 40},
                                  {"gradients", 50},
                                  {"hessians", 5},
                                  {"outer", 6},
                                  {"factor_nonzeros", 7000000000}}));
  EXPECT_EQ(v.at("environment").at("blas"), "openblas");
  EXPECT_EQ(v.at("environment").at("threads"), 1);
  EXPECT_EQ(v.at("environment").at("inputs").at("svc.vtp"), "sha256:00ff");
}

TEST(WriteJson, WithoutContactThereIsNoPressure) {
  Result result = test::example_result();
  EXPECT_EQ(Json::parse(to_json(result)).at("metrics").at(0).at("largest_pressure"), 1e-3);
  result.metrics[0].largest_pressure.reset();
  result.metrics[0].contact_area.reset();
  const Json metrics = Json::parse(to_json(result)).at("metrics").at(0);
  EXPECT_FALSE(metrics.contains("largest_pressure"));
  EXPECT_FALSE(metrics.contains("contact_area"));
}

TEST(WriteJson, GlennHasCutIncisionAndJoin) {
  Result result = test::example_result();
  const Json glenn = Json::parse(to_json(result)).at("glenn");
  EXPECT_EQ(glenn.at("cut").at("fraction"), 0.4);
  EXPECT_EQ(glenn.at("cut").at("perimeter"), 31.4);
  EXPECT_EQ(vector(glenn.at("cut").at("plane").at("normal")), Vec3(0, 0, 1));
  EXPECT_EQ(glenn.at("incision").at("length"), 15.7);
  EXPECT_EQ(vector(glenn.at("incision").at("ends").at(1)), Vec3(0, 1, 0));
  EXPECT_EQ(glenn.at("incision").at("opened_area"), 3.5);
  EXPECT_EQ(glenn.at("join").at("pairs"), 48);
  EXPECT_EQ(glenn.at("join").at("rotation_deg"), -12.5);
  EXPECT_EQ(glenn.at("join").at("largest_gap"), 0.01);
  EXPECT_EQ(glenn.at("join").at("rms_gap"), 0.005);
  result.glenn.reset();
  EXPECT_FALSE(Json::parse(to_json(result)).contains("glenn"));
}

TEST(WriteJson, DoublesReadBackToTheSameBits) {
  Result result = test::example_result();
  std::uint64_t state = 1;
  for (int k = 0; k < 2000; ++k) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const auto value = std::bit_cast<double>(state);
    if (std::isfinite(value)) result.seconds["x" + std::to_string(k)] = value;
  }
  const Json seconds = Json::parse(to_json(result)).at("seconds");
  for (const auto& [name, value] : result.seconds)
    EXPECT_EQ(seconds.at(name).get<double>(), value) << name;
}

TEST(WriteJson, WhatIsNotFiniteIsNull) {
  Result result = test::example_result();
  result.energy.rod = std::numeric_limits<double>::quiet_NaN();
  result.ends[0].force.x() = std::numeric_limits<double>::infinity();
  const Json value = Json::parse(to_json(result));
  EXPECT_TRUE(value.at("energy").at("rod").is_null());
  EXPECT_TRUE(value.at("energy").at("total").is_null());
  EXPECT_TRUE(value.at("ends").at(0).at("force").at(0).is_null());
  EXPECT_EQ(value.at("ends").at(0).at("force").at(1), 0.2);
}

TEST(WriteJson, CurvatureThatWasAskedForIsATruthValue) {
  Result result = test::example_result();
  result.certificate.smallest_curvature_positive = false;
  EXPECT_EQ(Json::parse(to_json(result)).at("certificate").at("smallest_curvature_positive"),
            false);
}

TEST(WriteJson, AnyTextSurvives) {
  Result result = test::example_result();
  const std::string awkward = "quote \" backslash \\ line\nfeed, Grüße \x01";
  result.validity.warnings = {awkward, "second"};
  result.certificate.notes = {"two", "notes"};
  result.environment.inputs["broken \xff name"] = "sha256:1";
  const Json value = Json::parse(to_json(result));
  EXPECT_EQ(value.at("validity").at("warnings").at(0), awkward);
  EXPECT_EQ(value.at("certificate").at("notes"), Json::array({"two", "notes"}));
  EXPECT_EQ(value.at("environment").at("inputs").size(), 2u);
}

TEST(WriteJson, TheRangeOfAStateThatIsNoSolutionIsNullAndTheFirstWarningSaysWhy) {
  for (const Status status : {Status::interrupted, Status::iteration_limit, Status::unstable}) {
    Result result = test::example_result();
    result.status = status;
    result.validity.in_range = true;
    const Json validity = Json::parse(to_json(result)).at("validity");
    EXPECT_TRUE(validity.at("in_range").is_null()) << to_string(status);
    ASSERT_EQ(validity.at("warnings").size(), 2U);
    EXPECT_EQ(validity.at("warnings").at(0), why_unknown(status));
  }
}

TEST(WriteJson, ACriterionHasItsThresholdsVerdictAndSource) {
  Result result = test::example_result();
  result.criteria = {{"lumen", "svc", 0.5, "", 0.6, 0.4, Verdict::warning, "a convention"},
                     {"stretch", "svc", 1.2, "", {}, {}, Verdict::not_judged, "none"}};
  const Json criteria = Json::parse(to_json(result)).at("criteria");
  EXPECT_EQ(criteria.at(0), (Json{{"name", "lumen"},
                                  {"vessel", "svc"},
                                  {"value", 0.5},
                                  {"unit", ""},
                                  {"threshold", 0.6},
                                  {"strong_threshold", 0.4},
                                  {"verdict", "warning"},
                                  {"source", "a convention"}}));
  EXPECT_TRUE(criteria.at(1).at("threshold").is_null());
  EXPECT_EQ(criteria.at(1).at("verdict"), "not_judged");
}

TEST(WriteJson, AFitHasItsEndsAndNoRange) {
  Result result = test::example_result();
  EXPECT_FALSE(Json::parse(to_json(result)).contains("fit"));
  result.fit = FitReport{{60, 4, 5, 6},
                         {{60, 4, 5, 6}},
                         {{"start", "3", {1, 2, 3}, {0, 0, -1}, 4}, {"end", "", {}, {}, 6}}};
  const Json value = Json::parse(to_json(result));
  EXPECT_TRUE(value.at("validity").at("in_range").is_null());
  const Json& fit = value.at("fit");
  EXPECT_EQ(fit.at("length"), 60);
  EXPECT_EQ(fit.at("mean_radius"), 5);
  EXPECT_EQ(fit.at("branches").size(), 1U);
  EXPECT_EQ(fit.at("ends").at(0), (Json{{"end", "start"},
                                        {"name", "3"},
                                        {"center", {1, 2, 3}},
                                        {"normal", {0, 0, -1}},
                                        {"radius", 4}}));
  EXPECT_TRUE(fit.at("ends").at(1).at("name").is_null());
}

TEST(WriteJson, AnEmptyResultIsComplete) {
  const Json value = Json::parse(to_json(Result{}));
  for (const char* key : {"ends", "balance", "contact", "metrics", "criteria"}) {
    EXPECT_TRUE(value.at(key).is_array()) << key;
    EXPECT_TRUE(value.at(key).empty()) << key;
  }
  EXPECT_TRUE(value.at("model").at("left_out").is_object());
  EXPECT_TRUE(value.at("seconds").is_object());
}

TEST(WriteJson, DiscretisationOfTheReference) {
  Result result = test::example_result();
  EXPECT_FALSE(Json::parse(to_json(result)).contains("discretisation"));
  result.discretisation = Discretisation{120000, 3, 1e-4, std::nullopt};
  const Json value = Json::parse(to_json(result)).at("discretisation");
  EXPECT_EQ(value.at("dofs"), 120000);
  EXPECT_EQ(value.at("degree"), 3);
  EXPECT_EQ(value.at("error_estimate"), 1e-4);
  EXPECT_TRUE(value.at("observed_order").is_null());
}

}  // namespace
}  // namespace vasorod
