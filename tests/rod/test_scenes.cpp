// The scene files of benchmarks/cases/rod, read, solved and compared with published or computed
// digits.
#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>

#include "predict/rod_scene.h"

namespace vasorod {
namespace {

constexpr double pi = std::numbers::pi;

Scene scene_of(const std::string& name) {
  return read_scene(std::filesystem::path(VASOROD_SOURCE_DIR) / "benchmarks/cases/rod" /
                    (name + ".yaml"));
}
Result solve(const std::string& name) {
  return solve_rod_scene(scene_of(name));
}

const EndReaction& end_of(const Result& result, const std::string& vessel, const std::string& end) {
  for (const EndReaction& e : result.ends)
    if (e.vessel == vessel && e.end == end) return e;
  throw std::runtime_error("no such end");
}
Vec3 last_point(const Result& result, std::size_t vessel = 0) {
  const Points& points = result.vessels[vessel].centerline->current;
  return points.row(points.rows() - 1);
}

TEST(RodScenes, Bend45) {
  const Result r = solve("b7-bend45");
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_EQ(r.certificate.smallest_curvature_positive, true);
  EXPECT_LE(r.iterations.at("rod"), 8);
  const Vec3 exact(15.684800534, 47.150438574, 53.474858792);
  EXPECT_LT((last_point(r) - exact).norm(), 1.04e-2);
  EXPECT_EQ((end_of(r, "bend", "end").center - last_point(r)).norm(), 0);
  EXPECT_LT((end_of(r, "bend", "start").force - Vec3(0, 0, -600)).norm(), 1e-9);
  EXPECT_LT(r.balance[0].residual, 1e-12);
  EXPECT_NEAR(r.energy.rod, 10695.37439, 2);
  EXPECT_LT((r.metrics[0].where.at("largest_curvature") - Vec3::Zero()).norm(),
            1e-12);  // at the clamp
}

TEST(RodScenes, ExtrapolationIsOrderFour) {
  Scene scene = scene_of("b7-bend45-extrapolated");
  const Vec3 exact(15.684800534, 47.150438574, 53.474858792);
  double error[2];
  for (const int n : {8, 16}) {
    scene.vessels[0].rod->pieces[0].elements = n;
    error[n / 16] = (last_point(solve_rod_scene(scene)) - exact).norm();
  }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_GT(std::log2(error[0] / error[1]), 4) << error[0] << ' ' << error[1];
  const Result r = solve("b7-bend45-extrapolated");
  EXPECT_LT((last_point(r) - exact).norm(), 6e-6);
  EXPECT_NEAR(r.energy.rod, 10695.37439, 1e-3);
}

TEST(RodScenes, Elastica) {
  const Result r = solve("b1-elastica");
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_LT((last_point(r) - Vec3(1 - 0.387628360724, 0.713791523612, 0)).norm(), 1e-6);
  EXPECT_LE(r.iterations.at("rod"), 16);  // two solves
}

TEST(RodScenes, Timoshenko) {
  const Result r = solve("b4-timoshenko");
  EXPECT_NEAR(last_point(r).y(), 0.06774842, 3e-5);
  EXPECT_NEAR(last_point(r).x(), 2.99926793, 1e-6);
}

TEST(RodScenes, RollUpAndHelixAreExact) {
  const Result circle = solve("b5-rollup");
  EXPECT_EQ(circle.status, Status::equilibrium_only);
  EXPECT_LT(last_point(circle).norm(), 1e-10);
  EXPECT_NEAR(circle.energy.rod, 2 * pi * pi, 1e-9);
  const Result helix = solve("b6-helix");
  EXPECT_EQ(helix.status, Status::equilibrium_only);
  EXPECT_LT((last_point(helix) - Vec3(0, -10, 50)).norm(), 1e-8);  // 1e-10 of the length
  EXPECT_NEAR(helix.energy.rod, 0.0958801882209, 1e-11);
}

TEST(RodScenes, PrescribedPoses) {
  const Result a = solve("b12-pose-60"), b = solve("b12-pose-120");
  EXPECT_EQ(a.status, Status::converged);
  EXPECT_EQ(b.status, Status::converged);
  const auto middle = [](const Result& r) {
    return Vec3(r.vessels[0].centerline->current.row(32));
  };
  EXPECT_LT((middle(a) - Vec3(0.41678141, -0.09399874, 0.23689195)).norm(), 3e-5);
  EXPECT_LT((middle(b) - Vec3(0.3986925, -0.1770716, 0.21037551)).norm(), 7e-5);
  EXPECT_NEAR(a.energy.rod, 4.975051418, 4e-3);
  EXPECT_NEAR(b.energy.rod, 9.368806732, 6e-3);
  EXPECT_LT(a.balance[0].residual, 1e-6);
}

TEST(RodScenes, TreeConvergesAtOrderTwo) {
  Scene scene = scene_of("b13-tree");
  const Vec3 tip1(102.8549255711, -4.5620702458, 29.0381134982),
      tip2(81.8968230741, -33.0472136843, -10.0489652292);
  double before = 0;
  for (const int n : {16, 32, 64, 128}) {
    for (VesselSpec& v : scene.vessels) v.rod->pieces[0].elements = n;
    const Result r = solve_rod_scene(scene);
    EXPECT_EQ(r.status, Status::converged);
    const double now = (last_point(r, 1) - tip1).norm() + (last_point(r, 2) - tip2).norm();
    if (n > 16) {
      EXPECT_NEAR(std::log2(before / now), 2, 0.05) << n << ": " << before << " -> " << now;
    }
    before = now;
  }
  for (VesselSpec& v : scene.vessels) v.rod->pieces[0].elements = 32;
  scene.extrapolate = true;
  const Result r = solve_rod_scene(scene);
  EXPECT_LT((last_point(r, 0) - Vec3(59.2262221974, -5.5860004037, 6.6719754204)).norm(), 1e-6);
  EXPECT_LT((last_point(r, 1) - tip1).norm() + (last_point(r, 2) - tip2).norm(), 3e-6);
  EXPECT_NEAR(r.energy.rod, 3.055132910623, 1e-6);
  // the digits are the moment of the rod on the root, the support's moment is the opposite
  EXPECT_LT((end_of(r, "trunk", "start").moment + Vec3(5.3657261692, -8.2957307198, -6.0994099985))
                .norm(),
            1e-5);
  for (const Balance& b : r.balance) EXPECT_LT(b.residual, 1e-6) << b.vessel;
  EXPECT_EQ(r.vessels.size(), 3u);
}

TEST(RodScenes, ColumnBucklesAndTwistedRodHolds) {
  const Result column = solve("b11-column");
  EXPECT_TRUE(column.status == Status::converged || column.status == Status::equilibrium_only);
  EXPECT_NEAR(last_point(column).x(), .55939592, 1e-3);
  EXPECT_NEAR(last_point(column).tail<2>().norm(), .71949710, 1e-3);
  const Result twist = solve("b11-twist");
  EXPECT_EQ(twist.status, Status::converged);
  EXPECT_NEAR(twist.energy.rod, 8.9 * 8.9 / (2 * 0.8), 1e-9);
  EXPECT_LT((last_point(twist) - Vec3(1, 0, 0)).norm(), 1e-9);
}

TEST(RodScenes, TenTurnsAreMeant) {
  const Result r = solve("turns");
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_NEAR(r.energy.rod, 200 * pi * pi, 1e-7);
  EXPECT_NEAR(end_of(r, "rod", "end").moment.x(), 20 * pi, 1e-9);
}

// The straight rod with three turns is a saddle, and no contact keeps its turns: two are lost.
TEST(RodScenes, TurnsThatAreLostAreNamed) {
  const Result r = solve("lost-turns");
  EXPECT_EQ(r.status, Status::buckled);
  EXPECT_EQ(r.certificate.smallest_curvature_positive, true);
  EXPECT_NEAR(r.energy.rod, 0.8 * 2 * pi * pi, 1e-9);  // GJ (2 pi)^2 / (2 L)
  ASSERT_EQ(r.certificate.notes.size(), 1u);
  EXPECT_NE(r.certificate.notes[0].find("went from 1080 to 360 degrees"), std::string::npos)
      << r.certificate.notes[0];
}

TEST(RodScenes, SupportsInside) {
  const Result r = solve("inside");
  EXPECT_EQ(r.status, Status::converged);
  EXPECT_LT(r.balance[0].residual, 1e-9);
  const EndReaction& pin = end_of(r, "beam", "at(0.4)");
  EXPECT_NEAR(pin.center.x(), 0.8, 1e-3);
  EXPECT_NEAR(pin.center.y(), 0, 1e-12);
  EXPECT_LT(pin.moment.norm(), 1e-9);        // a pin carries no moment
  EXPECT_LT(std::abs(pin.force.x()), 1e-9);  // and lets the beam slide
  // linear theory: clamped at 0, pins at 0.8 and 2, force at 1.4 (three-moment equation)
  const double force = 0.1, a = 0.6, b = 0.6, span = 1.2, first = 0.8;
  const double m1 = -force * a * b * (span + b) / span / (2 * (first + span) - first / 2);
  EXPECT_NEAR(end_of(r, "beam", "end").force.y(), -(force * a / span + m1 / span), 5e-3 * force);
}

TEST(RodScenes, SectionForcesAndMomentsAreWritten) {
  const Result rollup = solve("b5-rollup-plane");
  const CenterlineResult& circle = *rollup.vessels[0].centerline;
  ASSERT_EQ(circle.moment.size(), 4U);
  for (std::size_t i = 0; i < circle.moment.size(); ++i) {
    EXPECT_LT((circle.moment[i] - Vec3(2 * pi, 0, 0)).norm(), 1e-10) << i;
    EXPECT_LT(circle.force[i].norm(), 1e-10) << i;
  }
  const Result bend =
      solve("b7-bend45-extrapolated");  // a dead end force: the same in every section, second order
  const CenterlineResult& line = *bend.vessels[0].centerline;
  for (std::size_t i = 1; i + 1 < line.force.size(); ++i)
    EXPECT_LT((line.directors[i] * line.force[i] - Vec3(0, 0, 600)).norm(), 2e-3 * 600) << i;
  // and the moment at a section is that force times its lever arm
  const std::size_t middle = line.force.size() / 2;
  const Vec3 lever = last_point(bend) - Vec3(line.current.row(static_cast<Eigen::Index>(middle)));
  EXPECT_LT((line.directors[middle] * line.moment[middle] - lever.cross(Vec3(0, 0, 600))).norm(),
            2e-3 * 600 * 78);
}

TEST(RodScenes, CyclesAreRefused) {
  Scene scene = scene_of("b13-tree");
  scene.vessels[0].rod->parent = "left";
  EXPECT_THROW(solve_rod_scene(scene), InputError);
}

TEST(RodScenes, AnUnsupportedRodNamesItsFreeMotion) {
  Scene scene = scene_of("b7-bend45");
  scene.ends.erase(scene.ends.begin());
  try {
    solve_rod_scene(scene);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(
                  "rod 'bend': the loads drive a rigid motion that no support stops"),
              std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace vasorod
