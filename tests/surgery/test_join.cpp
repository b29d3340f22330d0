#include <gtest/gtest.h>
#include <random>

#include "surgery/cut.h"
#include "surgery/incision.h"
#include "surgery/join.h"
#include "surgery/pose.h"
#include "surgery/surface_checks.h"
#include "surgery/tube_binding.h"

namespace vasorod {
namespace {

// A cut SVC placed on an opened RPA, both with irregular triangles.
struct Operation {
  TriangleSurface svc, rpa;
  std::vector<int> mouth, rim;
  int other_tip = 0;
  Points mouth_start;
};

Operation operate(int i, double phi, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::TubeShape upper, lower;
  for (testing::TubeShape* shape : {&upper, &lower}) {
    shape->around = 16 + static_cast<int>(uniform(random) * 32);
    shape->along = static_cast<int>(shape->around * 1.4);
    shape->bend = i % 3 == 0 ? 0 : uniform(random);
    shape->jitter = i % 5 == 0 ? 0 : 0.28 * uniform(random);
    shape->seed = static_cast<unsigned>(2 * i + (shape == &upper ? 0 : 1));
  }
  upper.radius = 4 + uniform(random);
  Operation operation;
  const auto svc = testing::noisy_tube(upper);
  const Pose section = testing::tube_frame(upper, 15 + 10 * uniform(random));
  const auto cut = cut_vessel(svc, section, section.position, {0, 0, 0});
  operation.svc = cut.kept;
  operation.mouth = cut.mouth;

  const auto rpa = testing::noisy_tube(lower);
  const double theta = 2 * M_PI * uniform(random);
  const auto incision =
      open_incision(rpa, testing::tube_rod(lower), testing::tube_binding(lower, rpa.points), {},
                    testing::on_tube(lower, theta, 20, lower.radius), cut.perimeter / 2, 5);
  operation.rpa = incision.surface;
  operation.rim = incision.rim;
  operation.other_tip = incision.other_tip;

  const Pose rpa_frame = testing::tube_frame(lower, 20);
  const Vec3 outward = outward_normal(rpa, incision.pick, upper.radius);
  const Pose target =
      mouth_pose(incision.pick, outward, rpa_frame.director(3), phi) * section.inverse();
  operation.mouth_start.resize(static_cast<Eigen::Index>(cut.mouth.size()), 3);
  for (size_t k = 0; k < cut.mouth.size(); ++k)
    operation.mouth_start.row(static_cast<Eigen::Index>(k)) =
        target * Vec3(cut.kept.points.row(cut.mouth[k]));
  return operation;
}

TEST(Join, HundredsOfSeamsPairOneToOneAndWeldToOneSurface) {
  std::mt19937 random(3);
  testing::MadeBySurgery worst;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("seam " + std::to_string(i));
    const auto op = operate(i, 0.1 * i, random);
    const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
    ASSERT_TRUE(testing::oriented(seam.svc.triangles));
    ASSERT_TRUE(testing::oriented(seam.rpa.triangles));
    EXPECT_EQ(euler_number(seam.svc.triangles), 0);
    EXPECT_EQ(euler_number(seam.rpa.triangles), -1);

    // The pairs contain each vertex of both loops once, in opposite order.
    std::vector<int> on_mouth, on_rim;
    for (const auto& [a, b] : seam.pairs) {
      on_mouth.push_back(a);
      on_rim.push_back(b);
    }
    std::reverse(on_mouth.begin(), on_mouth.end());
    for (const auto& [surface, loop] :
         {std::pair(&seam.svc, &on_mouth), std::pair(&seam.rpa, &on_rim)}) {
      std::rotate(loop->begin(), std::min_element(loop->begin(), loop->end()), loop->end());
      const auto loops = boundary_loops(surface->triangles);
      EXPECT_EQ(std::count(loops.begin(), loops.end(), *loop), 1);
    }
    EXPECT_EQ(seam.pairs.front()[1], op.rim.front());
    EXPECT_EQ(seam.pairs[static_cast<size_t>(seam.other_tip)][1],
              op.rim[static_cast<size_t>(op.other_tip)]);

    // No vertex moves; the surfaces keep their shape.
    EXPECT_LT(testing::source_error(op.svc, seam.svc, seam.svc_sources), 1e-11);
    EXPECT_LT(testing::source_error(op.rpa, seam.rpa, seam.rpa_sources), 1e-11);
    EXPECT_EQ(seam.svc.points.topRows(op.svc.points.rows()), op.svc.points);
    EXPECT_EQ(seam.rpa.points.topRows(op.rpa.points.rows()), op.rpa.points);
    EXPECT_NEAR(total_area(seam.svc) / total_area(op.svc), 1, 2e-3);
    EXPECT_NEAR(total_area(seam.rpa) / total_area(op.rpa), 1, 2e-3);
    for (const auto& [before, after, sources] :
         {std::tuple(&op.svc, &seam.svc, &seam.svc_sources),
          std::tuple(&op.rpa, &seam.rpa, &seam.rpa_sources)}) {
      const auto made = testing::made_by_surgery(*before, *after, *sources);
      worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
      worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
    }

    // Arc lengths from the tip agree on both sides to half the tolerance plus the shift by pairing.
    const auto welded = weld(seam.svc, seam.rpa, seam.pairs);
    ASSERT_TRUE(testing::oriented(welded.surface.triangles));
    EXPECT_EQ(euler_number(welded.surface.triangles), -1);  // 0 - 1, glued along a circle
    EXPECT_EQ(boundary_loops(welded.surface.triangles).size(), 3U);
    EXPECT_EQ(welded.origin.size(), static_cast<size_t>(welded.surface.points.rows()));
    EXPECT_EQ(welded.surface.points.rows() + static_cast<Eigen::Index>(seam.pairs.size()),
              seam.svc.points.rows() + seam.rpa.points.rows());
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 5);
}

TEST(Join, PairsLieOppositeEachOtherByArcLength) {
  std::mt19937 random(8);
  for (int i = 0; i < 20; ++i) {
    const auto op = operate(i, 0, random);
    const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
    double on_mouth = 0, on_rim = 0, mouth_length = 0, rim_length = 0;
    const size_t n = seam.pairs.size();
    const auto step = [&](const TriangleSurface& s, size_t k, size_t side) {
      return (s.points.row(seam.pairs[(k + 1) % n][side]) - s.points.row(seam.pairs[k][side]))
          .norm();
    };
    for (size_t k = 0; k < n; ++k) {
      mouth_length += step(seam.svc, k, 0);
      rim_length += step(seam.rpa, k, 1);
    }
    EXPECT_NEAR(mouth_length, rim_length, 1e-6 * rim_length);
    double lowest = 0, highest = 0;  // of the difference in arc length, from the first tip
    for (size_t k = 0; k < n; ++k) {
      lowest = std::min(lowest, on_mouth - on_rim);
      highest = std::max(highest, on_mouth - on_rim);
      on_mouth += step(seam.svc, k, 0);
      on_rim += step(seam.rpa, k, 1);
    }
    EXPECT_LT(highest - lowest,
              2 * 0.5 * std::max(mean_edge_length(op.svc), mean_edge_length(op.rpa)));
  }
}

TEST(Join, TurningTheMouthTurnsTheMatch) {
  // The tips are paired with the mouth's points farthest along the recipient, whichever vertices
  // these are.
  for (const double phi : {0.0, 1.0, 2.5, -2.0}) {
    std::mt19937 random(21);
    const auto op = operate(4, phi, random);
    const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
    const Vec3 first = seam.rpa.points.row(seam.pairs.front()[1]);
    const Vec3 other = seam.rpa.points.row(seam.pairs[static_cast<size_t>(seam.other_tip)][1]);
    const Vec3 along = (other - first).normalized();
    // Start position of the mouth's partner of the first tip, from its source.
    Vec3 start = Vec3::Zero();
    const auto& source = seam.svc_sources[static_cast<size_t>(seam.pairs.front()[0])];
    for (size_t k = 0; k < source.vertex.size(); ++k) {
      const auto at =
          std::find(op.mouth.begin(), op.mouth.end(), source.vertex[k]) - op.mouth.begin();
      ASSERT_LT(at, static_cast<std::ptrdiff_t>(op.mouth.size()));
      start += source.weight[k] * op.mouth_start.row(at).transpose();
    }
    const double least = (op.mouth_start * along).minCoeff(),
                 most = (op.mouth_start * along).maxCoeff();
    EXPECT_LT(start.dot(along), least + 0.05 * (most - least));
  }
}

}  // namespace
}  // namespace vasorod
