#include <gtest/gtest.h>
#include <random>

#include <vasorod/error.h>

#include "geometry/noisy_tube.h"
#include "surgery/cut.h"
#include "surgery/surface_checks.h"

namespace vasorod {
namespace {

TEST(Cut, HundredsOfObliqueCutsLeaveCleanParts) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::MadeBySurgery worst;
  for (int i = 0; i < 80; ++i) {
    const int around = 8 + static_cast<int>(uniform(random) * 40);
    auto shape = testing::irregular_shape(i, around, 1.5, random);
    shape.along = std::max(10, shape.along);
    const auto tube = testing::noisy_tube(shape);
    Pose section = testing::tube_frame(shape, 12 + 16 * uniform(random));
    const double tilt = 0.5 * uniform(random), turn = 2 * M_PI * uniform(random);
    section.rotation = section.rotation * Eigen::AngleAxisd(turn, Vec3::UnitZ()) *
                       Eigen::AngleAxisd(tilt, Vec3::UnitX());
    const bool keep_far = i % 2 == 0;
    const Vec3 keep_near = testing::on_tube(shape, 0, keep_far ? shape.length : 0, 0);
    const auto outcome = cut_vessel(tube, section, section * Vec3(5, 0, 0), keep_near);
    SCOPED_TRACE("cut " + std::to_string(i));

    // Topology: an open tube, and a tube with one end closed.
    ASSERT_TRUE(testing::oriented(outcome.kept.triangles));
    ASSERT_TRUE(testing::oriented(outcome.stump.triangles));
    EXPECT_EQ(euler_number(outcome.kept.triangles), 0);
    EXPECT_EQ(euler_number(outcome.stump.triangles), 1);
    const auto loops = boundary_loops(outcome.kept.triangles);
    ASSERT_EQ(loops.size(), 2U);
    EXPECT_EQ(boundary_loops(outcome.stump.triangles).size(), 1U);
    EXPECT_EQ(std::count(loops.begin(), loops.end(), outcome.mouth), 1);

    // The mouth lies on the plane, the kept part on its own side; positions agree with the sources.
    const Vec3 normal = section.rotation.col(2);
    for (const int v : outcome.mouth)
      EXPECT_NEAR((outcome.kept.points.row(v).transpose() - section.position).dot(normal), 0,
                  1e-12 * 40);
    EXPECT_NEAR(std::abs(outcome.normal.dot(normal)), 1, 1e-12);
    EXPECT_LT(((outcome.kept.points.rowwise() - section.position.transpose()) * outcome.normal)
                  .maxCoeff(),
              1e-11);
    EXPECT_LT(testing::source_error(tube, outcome.kept, outcome.kept_sources), 1e-11);
    EXPECT_LT(testing::source_error(tube, outcome.stump, outcome.stump_sources), 1e-11);

    // Only snapping changes the area: the cap is flat, the rest is the tube.
    double cap = 0;
    const Eigen::VectorXd areas = triangle_areas(outcome.stump);
    for (int t = 0; t < areas.size(); ++t) {
      bool flat = true;
      for (int k = 0; k < 3; ++k)
        flat =
            flat && std::abs((outcome.stump.points.row(outcome.stump.triangles(t, k)).transpose() -
                              section.position)
                                 .dot(normal)) < 1e-10;
      if (flat) cap += areas[t];
    }
    EXPECT_NEAR(cap, area_vector(outcome.kept.points, outcome.mouth).norm(), 1e-9);
    EXPECT_NEAR((total_area(outcome.kept) + total_area(outcome.stump) - cap) / total_area(tube), 1,
                shape.around < 16 ? 0.01 : 2e-3);

    for (const auto& [part, sources] : {std::pair(&outcome.kept, &outcome.kept_sources),
                                        std::pair(&outcome.stump, &outcome.stump_sources)}) {
      const auto made = testing::made_by_surgery(tube, *part, *sources);
      worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
      worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
    }
    int last = -1;  // vertices stay in the input's order
    for (const auto& source : outcome.kept_sources) {
      if (!source.is_original()) continue;
      EXPECT_GT(source.vertex[0], last);
      last = source.vertex[0];
    }
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 5);
}

TEST(Cut, ThePlaneCutsOnlyWhereTheSectionIsWhenItMeetsTheVesselTwice) {
  const testing::TubeShape shape = testing::u_bend();
  const auto tube = testing::noisy_tube(shape);
  Pose section = testing::tube_frame(shape, 12);
  section.rotation = Mat3::Identity();  // a plane z = const, which also meets the other leg
  const auto outcome =
      cut_vessel(tube, section, section.position, testing::on_tube(shape, 0, 60, 0));
  EXPECT_EQ(boundary_loops(outcome.kept.triangles).size(), 2U);
  EXPECT_GT(total_area(outcome.kept), 0.7 * total_area(tube));
  for (size_t v = 0; v < outcome.kept_sources.size();
       ++v)  // the other leg is the input's, untouched
    if (outcome.kept.points(static_cast<Eigen::Index>(v), 0) < -25) {
      EXPECT_TRUE(outcome.kept_sources[v].is_original());
    }
}

TEST(Cut, PerimeterAndCenterOfAStraightTube) {
  testing::TubeShape shape;
  shape.around = 60;
  shape.along = 60;
  const auto tube = testing::noisy_tube(shape);
  Pose section;
  section.position = {0.3, -0.2, 17.3};
  const auto outcome = cut_vessel(tube, section, {5, 0, 17.3}, {0, 0, 0});
  EXPECT_NEAR(outcome.perimeter, 2 * M_PI * 5, 2 * M_PI * 5 * 0.003);
  EXPECT_NEAR((outcome.center - Vec3(0, 0, 17.3)).norm(), 0, 0.01);
  EXPECT_NEAR((outcome.normal - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(outcome.perimeter, perimeter(outcome.kept.points, outcome.mouth), 1e-12);
}

TEST(Cut, MovingTheSceneRigidlyMovesTheOutcome) {
  testing::TubeShape shape;
  shape.bend = 0.8;
  shape.jitter = 0.2;
  auto tube = testing::noisy_tube(shape);
  const Pose section = testing::tube_frame(shape, 21);
  const auto one = cut_vessel(tube, section, section.position, {0, 0, 0});
  Pose motion;
  motion.rotation = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  motion.position = {30, -200, 55};
  for (int i = 0; i < tube.points.rows(); ++i)
    tube.points.row(i) = motion * Vec3(tube.points.row(i));
  const auto two = cut_vessel(tube, motion * section, (motion * section).position, motion.position);
  ASSERT_EQ(one.kept.triangles, two.kept.triangles);
  for (int i = 0; i < one.kept.points.rows(); ++i)
    EXPECT_NEAR((motion * Vec3(one.kept.points.row(i)) - Vec3(two.kept.points.row(i))).norm(), 0,
                1e-10);
}

TEST(Cut, BadCutsAreRefusedWithASentence) {
  const auto sentence = [](const TriangleSurface& tube, const Vec3& position,
                           const Vec3& normal) -> std::string {
    Pose section;
    section.rotation = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal).toRotationMatrix();
    section.position = position;
    try {
      cut_vessel(tube, section, position, {0, 0, 0});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const auto says = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const auto tube = testing::noisy_tube({});
  says(sentence(tube, {0, 0, 70}, Vec3::UnitZ()), "misses the vessel");
  says(sentence(tube, {0, 0, 2}, Vec3(1, 0, 1).normalized()), "runs into an open end");
  says(sentence(tube, {0, 0, 0.4}, Vec3::UnitZ()), "within one triangle of an open end");
  testing::TubeShape fine;
  fine.around = 60;
  fine.along = 100;
  says(sentence(testing::noisy_tube(fine), {0, 0, 1}, Vec3::UnitZ()), "leave nothing");
}

}  // namespace
}  // namespace vasorod
