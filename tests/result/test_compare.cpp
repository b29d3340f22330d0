#include <Eigen/Geometry>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vasorod/compare.h>
#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "result/example_result.h"
#include "result/write_vtp.h"

namespace vasorod {
namespace {

namespace fs = std::filesystem;

// A result folder without pictures.
void write(const Result& result, const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream(folder / "result.json") << to_json(result);
  for (const VesselResult& vessel : result.vessels) {
    if (vessel.rest.rows() > 0)
      std::ofstream(folder / (vessel.name + ".vtp")) << vessel_vtp(vessel);
    if (vessel.centerline)
      std::ofstream(folder / (vessel.name + "_centerline.vtp"))
          << centerline_vtp(*vessel.centerline);
  }
}

class Compare : public testing::Test {
 protected:
  Comparison compare(const Result& a, const Result& b) const {
    write(a, base_.path / "a");
    write(b, base_.path / "b");
    return compare_results(base_.path / "a", base_.path / "b");
  }
  test::TemporaryFolder base_;
};

// The tube's affine motion u(p) = G p + c, which linear interpolation on any mesh reproduces.
VesselResult affine_tube(int around, int along, const Mat3& gradient, const Vec3& shift) {
  VesselResult vessel = test::deformed_tube(around, along);
  const auto move = [&](const Points& rest) {
    return Points((rest * (Mat3::Identity() + gradient).transpose()).rowwise() + shift.transpose());
  };
  vessel.current = move(vessel.rest);
  vessel.centerline->current = move(vessel.centerline->rest);
  return vessel;
}

TEST_F(Compare, AFolderThatLostAFileIsRefusedAndNotComparedByTheRest) {
  const Result result = test::example_result();
  compare(result, result);
  for (const char* name : {"svc.vtp", "svc_centerline.vtp"}) {
    fs::rename(base_.path / "b" / name, base_.path / name);
    EXPECT_THROW(compare_results(base_.path / "a", base_.path / "b"), InputError) << name;
    fs::rename(base_.path / name, base_.path / "b" / name);
  }
  EXPECT_NO_THROW(compare_results(base_.path / "a", base_.path / "b"));
}

TEST_F(Compare, AResultWithItselfDiffersByNothing) {
  const Result result = test::example_result();
  const Comparison c = compare(result, result);
  ASSERT_EQ(c.vessels.size(), 1u) << "the obstacle is left out";
  EXPECT_EQ(c.vessels[0].name, "svc");
  EXPECT_DOUBLE_EQ(c.vessels[0].radius, 5);
  EXPECT_LT(c.vessels[0].surface->largest, 1e-12);
  EXPECT_LT(c.vessels[0].centerline->largest, 1e-12);
  EXPECT_LT(c.vessels[0].rest_distance, 1e-12);
  ASSERT_EQ(c.reactions.size(), 1u);
  EXPECT_EQ(c.reactions[0].force_difference, 0);
}

TEST_F(Compare, AShiftShowsAsItsLengthOverTheRadius) {
  Result a = test::example_result(), b = a;
  const Vec3 shift(0.3, -0.4, 1.2);  // length 1.3
  b.vessels[0].current.rowwise() += shift.transpose();
  b.vessels[0].centerline->current.rowwise() += shift.transpose();
  const Comparison c = compare(a, b);
  EXPECT_NEAR(c.vessels[0].surface->rms, 1.3 / 5, 1e-12);
  EXPECT_NEAR(c.vessels[0].surface->largest, 1.3 / 5, 1e-12);
  EXPECT_NEAR(c.vessels[0].centerline->rms, 1.3 / 5, 1e-12);
  EXPECT_NEAR(c.vessels[0].centerline->largest, 1.3 / 5, 1e-12);
}

TEST_F(Compare, AnotherMeshOfTheSameMotionDiffersOnlyByTheChords) {
  Mat3 gradient;
  gradient << 0.1, 0.02, 0, -0.03, 0.05, 0.01, 0, 0.04, -0.1;
  Result a = test::example_result(), b = a;
  a.vessels[0] = affine_tube(40, 50, gradient, {1, 2, 3});
  b.vessels[0] = affine_tube(28, 33, gradient, {1, 2, 3});
  const VesselComparison c = compare(a, b).vessels.at(0);
  // A point of A is at most the sagitta of B's chords away. The motion differs by at most the
  // gradient's norm times this distance.
  const double sagitta = 1 - std::cos(M_PI / 28);
  EXPECT_LT(c.rest_distance, 1.1 * sagitta);
  EXPECT_GT(c.rest_distance, 0.5 * sagitta);
  EXPECT_LT(c.surface->largest, 1.1 * sagitta * gradient.norm());
  EXPECT_LT(c.centerline->largest, 1e-12);
}

// Two halves of a plate that meet at rest and move apart: an opened incision. The lips of two
// meshes have other points, and at rest one of them lies a little above the other.
TEST_F(Compare, EachLipOfAnIncisionMeetsItsOwnOnAnotherMesh) {
  const auto plate = [](int parts, double step) {
    VesselResult vessel;
    vessel.name = "svc";
    vessel.rest.resize(4 * (parts + 1), 3);
    vessel.triangles.resize(4 * parts, 3);
    for (int half = 0; half < 2; ++half)
      for (int i = 0; i <= parts; ++i) {
        const int at = 2 * (half * (parts + 1) + i), t = 2 * (half * parts + i);
        const double x = 10.0 * i / parts;
        vessel.rest.row(at) << x, 0, step * half;
        vessel.rest.row(at + 1) << x, half == 0 ? 4 : -4, 0;
        if (i == parts) continue;
        vessel.triangles.row(t) << at, at + 2, at + 1;
        vessel.triangles.row(t + 1) << at + 1, at + 2, at + 3;
      }
    vessel.current = vessel.rest;
    vessel.current.topRows(2 * (parts + 1)).col(1).array() += 1;
    vessel.current.bottomRows(2 * (parts + 1)).col(1).array() -= 1;
    vessel.axial_stretch = vessel.twist_shear = vessel.contact_pressure =
        Eigen::VectorXd::Zero(vessel.rest.rows());
    return vessel;
  };
  Result a = test::example_result(), b = a;
  for (const auto& [mine, other] :
       {std::pair{plate(7, 0), plate(9, 0.01)}, std::pair{plate(9, 0.01), plate(7, 0)}}) {
    a.vessels[0] = mine;
    b.vessels[0] = other;
    EXPECT_LT(compare(a, b).vessels.at(0).surface->largest, 1e-9);
  }
}

TEST_F(Compare, TheMeanIsWeightedByArea) {
  // One row of the tube is moved; its share of the area is known.
  Result a = test::example_result(), b = a;
  const int around = 24, along = 30, row = 7;
  for (int i = 0; i < around; ++i) b.vessels[0].current(row * around + i, 1) += 0.5;
  const VesselComparison c = compare(a, b).vessels.at(0);
  EXPECT_NEAR(c.surface->largest, 0.1, 1e-9);
  EXPECT_NEAR(c.surface->rms, 0.1 * std::sqrt(1.0 / along), 1e-3 * 0.1);
  EXPECT_NEAR(c.surface->largest_at.z(), 60.0 * row / along, 1e-9);
}

TEST_F(Compare, MomentsAreMovedToOnePoint) {
  Result a = test::example_result(), b = a;
  a.ends[0].force = b.ends[0].force = {0, 0, 2};
  a.ends[0].moment = {1, 0, 0};
  b.ends[0].center = a.ends[0].center + Vec3(0, 0.25, 0);
  b.ends[0].moment = a.ends[0].moment - Vec3(0, 0.25, 0).cross(b.ends[0].force);  // the same wrench
  const Comparison c = compare(a, b);
  EXPECT_NEAR(c.reactions[0].moment_difference, 0, 1e-12);
  b.ends[0].force = {0, 0, 2.2};
  EXPECT_NEAR(compare(a, b).reactions[0].force_difference, 0.1, 1e-12);
}

TEST_F(Compare, BareRodsAreComparedByTheirCenterlines) {
  Result a = test::example_result();
  a.vessels.resize(1);
  a.vessels[0].rest.resize(0, 3);
  a.vessels[0].centerline->radius.clear();
  Result b = a;
  b.vessels[0].centerline->current.rowwise() += Eigen::RowVector3d(0, 0.6, 0);
  const VesselComparison c = compare(a, b).vessels.at(0);
  EXPECT_FALSE(c.surface);
  EXPECT_NEAR(c.radius, 0.6, 1e-12) << "a hundredth of its length stands for the radius";
  EXPECT_NEAR(c.centerline->rms, 1, 1e-9);
}

TEST_F(Compare, WithoutACenterlineTheOpenEndsGiveTheRadius) {
  Result a = test::example_result();
  a.vessels[0].centerline.reset();
  const VesselComparison c = compare(a, a).vessels.at(0);
  EXPECT_FALSE(c.centerline);
  EXPECT_NEAR(c.radius, 5 * 24 / M_PI * std::sin(M_PI / 24), 1e-9) << "a polygon of 24 sides";
}

TEST_F(Compare, DifferentScenesAreRefusedInASentence) {
  const Result a = test::example_result();
  const auto refused = [&](const std::function<void(Result&)>& change, const std::string& part) {
    Result b = a;
    change(b);
    try {
      fs::remove_all(base_.path / "b");
      compare(a, b);
      ADD_FAILURE() << "not refused: " << part;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  refused([](Result& b) { b.scene = "other"; },
          "the scene is example in the first and other in the second");
  refused([](Result& b) { b.length_unit = "m"; }, "length unit");
  refused([](Result& b) { b.vessels[1].name = "heart"; }, "only the first has the vessel aorta");
  refused([](Result& b) { b.vessels[1].obstacle = false; }, "aorta");
  refused([](Result& b) { b.environment.inputs["svc.vtp"] = "sha256:11"; },
          "the input svc.vtp has another content");
  refused([](Result& b) { b.ends.clear(); }, "supported ends");
  refused([](Result& b) { b.ends[0].end = "end"; }, "the end start of svc");
  refused([](Result& b) { b.vessels[0].rest.col(0).array() += 4; }, "rest shapes of svc");
}

// `paper` solves no rod of an artery, so it states fewer supports than `coupled`.
TEST_F(Compare, EndsThatOnlyOneFidelitySupportsAreNamed) {
  Result coupled = test::example_result();
  coupled.ends.push_back({"rpa", "start", {0, 0, 4}, {0, 2, 0}, {0, 0, 0}});
  coupled.ends.push_back({"rpa", "end", {0, 0, -1}, {0, 1, 0}, {9, 0, 0}});
  Result paper = test::example_result();
  paper.fidelity = coupled.fidelity + " of another kind";
  paper.ends[0].force += Vec3(0, 0, 1);

  const Comparison first = compare(coupled, paper), second = compare(paper, coupled);
  for (const Comparison* c : {&first, &second}) {
    ASSERT_EQ(c->reactions.size(), 1u);
    EXPECT_EQ(c->reactions[0].vessel, "svc");
    ASSERT_EQ(c->lone_ends.size(), 2u);
    EXPECT_EQ(c->lone_ends[1].vessel, "rpa");
    EXPECT_EQ(c->lone_ends[1].end, "end");
    EXPECT_EQ(c->lone_ends[1].in_a, c == &first);
    const auto value = nlohmann::json::parse(comparison_json(*c));
    EXPECT_EQ(value.at("ends").size(), 1u);
    EXPECT_EQ(value.at("ends_of_one").at(0).at("vessel"), "rpa");
    EXPECT_EQ(value.at("ends_of_one").at(0).at("end"), "start");
    EXPECT_EQ(value.at("ends_of_one").at(0).at("in"), c == &first ? "a" : "b");
    const std::string sentence = c == &first ? "supported in A only: rpa start, rpa end\n"
                                             : "supported in B only: rpa start, rpa end\n";
    EXPECT_NE(comparison_table(*c).find(sentence), std::string::npos) << comparison_table(*c);
  }
  // Over the largest of A's ends, also of those that B does not have.
  EXPECT_NEAR(first.reactions[0].force_difference, 1.0 / 4, 1e-12);

  paper.ends.clear();
  const Comparison none = compare(coupled, paper);
  EXPECT_TRUE(none.reactions.empty());
  EXPECT_NE(comparison_table(none).find("supported in A only: svc start, rpa start, rpa end\n"),
            std::string::npos);

  // Each with an end of its own: two scenes.
  paper.ends = {coupled.ends[1]};
  coupled.ends.erase(coupled.ends.begin() + 1);
  EXPECT_THROW(compare(coupled, paper), InputError);
  // One fidelity states the same ends of one scene.
  paper = coupled;
  paper.ends.pop_back();
  EXPECT_THROW(compare(coupled, paper), InputError);
  EXPECT_THROW(compare(paper, coupled), InputError);
}

TEST_F(Compare, WhatIsMissingIsSaidInASentence) {
  write(test::example_result(), base_.path / "a");
  EXPECT_THROW(compare_results(base_.path / "a", base_.path / "none"), InputError);
  write(test::example_result(), base_.path / "b");
  std::ofstream(base_.path / "b/svc.vtp") << "<VTKFile";
  EXPECT_THROW(compare_results(base_.path / "a", base_.path / "b"), InputError);
  fs::remove(base_.path / "b/svc.vtp");
  fs::remove(base_.path / "b/svc_centerline.vtp");
  EXPECT_THROW(compare_results(base_.path / "a", base_.path / "b"), InputError);
}

TEST_F(Compare, APointThatDoesNotExistOrHasNoPlaceIsRefused) {
  const Result good = test::example_result();
  const auto refused = [&](const std::function<void(VesselResult&)>& change,
                           const std::string& part) {
    Result bad = good;
    change(bad.vessels[0]);
    for (const bool first : {true, false}) try {
        compare(first ? bad : good, first ? good : bad);
        ADD_FAILURE() << "not refused: " << part;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](VesselResult& v) { v.triangles(3, 1) = 1 << 20; }, "a point that does not exist");
  refused([](VesselResult& v) { v.triangles(3, 1) = -1; }, "a point that does not exist");
  refused([](VesselResult& v) { v.triangles(3, 1) = v.triangles(3, 0); }, "a surface that is none");
  refused([](VesselResult& v) { v.centerline->lines[0].back() = 5000; }, "does not exist");
  refused([](VesselResult& v) { v.centerline->lines[0].front() = -7; }, "does not exist");
  refused([&](VesselResult& v) { v.rest(5, 1) = nan; }, "found point 5 at rest at (");
  refused([&](VesselResult& v) { v.rest(5, 2) = 1e200; }, "found point 5 at rest at (");
  refused([&](VesselResult& v) { v.centerline->rest(2, 0) = nan; }, "found point 2 at rest at (");
}

TEST_F(Compare, JsonAndTableSayTheSame) {
  Result a = test::example_result(), b = a;
  b.vessels[0].current.rowwise() += Eigen::RowVector3d(0, 0.5, 0);
  b.seconds["total"] = 4;
  const Comparison c = compare(a, b);
  const auto value = nlohmann::json::parse(comparison_json(c));
  EXPECT_EQ(value.at("scene"), "example");
  EXPECT_EQ(value.at("vessels").at(0).at("vessel"), "svc");
  EXPECT_NEAR(value.at("vessels").at(0).at("surface").at("rms").get<double>(), 0.1, 1e-9);
  EXPECT_EQ(value.at("seconds_ratio"), 4.0);
  EXPECT_EQ(value.at("ends").at(0).at("force_a").at(0), 0.1);
  EXPECT_TRUE(value.at("ends_of_one").empty());
  const std::string table = comparison_table(c);
  EXPECT_NE(table.find("svc"), std::string::npos);
  EXPECT_NE(table.find("1.000e-01"), std::string::npos) << table;
}

}  // namespace
}  // namespace vasorod
