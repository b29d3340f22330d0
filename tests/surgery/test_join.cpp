#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <set>

#include "data/index.h"
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

// `around`: vertices around the SVC and the RPA, 0: between 16 and 48.
Operation operate(int i, double phi, std::mt19937& random, std::array<int, 2> around = {0, 0}) {
  std::uniform_real_distribution<double> uniform(0, 1);
  testing::TubeShape upper, lower;
  for (testing::TubeShape* shape : {&upper, &lower}) {
    const int wanted = around[shape == &upper ? 0 : 1];
    *shape = testing::irregular_shape(
        i, wanted > 0 ? wanted : 16 + static_cast<int>(uniform(random) * 32), 1, random);
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

// The vertices off the loop are where they were, those of the loop lie on its old polygon.
void expect_slid(const TriangleSurface& before, const std::vector<int>& loop,
                 const TriangleSurface& after) {
  const std::set<int> on_loop(loop.begin(), loop.end());
  for (int v = 0; v < before.points.rows(); ++v) {
    if (!on_loop.contains(v)) {
      ASSERT_EQ(after.points.row(v), before.points.row(v)) << v;
      continue;
    }
    const Vec3 p = after.points.row(v);
    double nearest = 1e300;
    for (size_t k = 0; k < loop.size(); ++k) {
      const Vec3 a = before.points.row(loop[k]);
      const Vec3 edge = before.points.row(loop[(k + 1) % loop.size()]).transpose() - a;
      const double t = std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (a + t * edge - p).norm());
    }
    ASSERT_LT(nearest, 1e-11) << v;
  }
}

// What the seam made of both surfaces, where it is worse than `worst`.
void see(const Operation& op, const JoinOutcome& seam, testing::MadeBySurgery& worst) {
  for (const auto& [before, after, sources] :
       {std::tuple(&op.svc, &seam.first, &seam.first_sources),
        std::tuple(&op.rpa, &seam.second, &seam.second_sources)}) {
    const auto made = testing::made_by_surgery(*before, *after, *sources);
    worst.shortest_edge = std::min(worst.shortest_edge, made.shortest_edge);
    worst.smallest_angle = std::min(worst.smallest_angle, made.smallest_angle);
  }
}

TEST(Join, HundredsOfSeamsPairOneToOneAndWeldToOneSurface) {
  std::mt19937 random(3);
  testing::MadeBySurgery worst;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE("seam " + std::to_string(i));
    const auto op = operate(i, 0.1 * i, random);
    const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
    ASSERT_TRUE(testing::oriented(seam.first.triangles));
    ASSERT_TRUE(testing::oriented(seam.second.triangles));
    EXPECT_EQ(euler_number(seam.first.triangles), 0);
    EXPECT_EQ(euler_number(seam.second.triangles), -1);

    // The pairs contain each vertex of both loops once, in opposite order.
    std::vector<int> on_mouth, on_rim;
    for (const auto& [a, b] : seam.pairs) {
      on_mouth.push_back(a);
      on_rim.push_back(b);
    }
    std::reverse(on_mouth.begin(), on_mouth.end());
    for (const auto& [surface, loop] :
         {std::pair(&seam.first, &on_mouth), std::pair(&seam.second, &on_rim)}) {
      std::rotate(loop->begin(), std::min_element(loop->begin(), loop->end()), loop->end());
      const auto loops = boundary_loops(surface->triangles);
      EXPECT_EQ(std::count(loops.begin(), loops.end(), *loop), 1);
    }
    EXPECT_EQ(seam.pairs.front()[1], op.rim.front());
    EXPECT_EQ(seam.pairs[static_cast<size_t>(seam.other_tip)][1],
              op.rim[static_cast<size_t>(op.other_tip)]);

    // Vertices off the loops stay, those on them slide along them.
    EXPECT_LT(testing::source_error(op.svc, seam.first, seam.first_sources), 1e-11);
    EXPECT_LT(testing::source_error(op.rpa, seam.second, seam.second_sources), 1e-11);
    expect_slid(op.svc, op.mouth, seam.first);
    expect_slid(op.rpa, op.rim, seam.second);
    EXPECT_EQ(seam.second.points.row(op.rim[0]), op.rpa.points.row(op.rim[0]));
    const int other = op.rim[index(op.other_tip)];
    EXPECT_EQ(seam.second.points.row(other), op.rpa.points.row(other));
    EXPECT_NEAR(total_area(seam.first) / total_area(op.svc), 1, 2e-3);
    EXPECT_NEAR(total_area(seam.second) / total_area(op.rpa), 1, 2e-3);
    see(op, seam, worst);

    const auto welded = weld(seam.first, seam.second, seam.pairs);
    ASSERT_TRUE(testing::oriented(welded.surface.triangles));
    EXPECT_EQ(euler_number(welded.surface.triangles), -1);  // 0 - 1, glued along a circle
    EXPECT_EQ(boundary_loops(welded.surface.triangles).size(), 3U);
    EXPECT_EQ(welded.origin.size(), static_cast<size_t>(welded.surface.points.rows()));
    EXPECT_EQ(welded.surface.points.rows() + static_cast<Eigen::Index>(seam.pairs.size()),
              seam.first.points.rows() + seam.second.points.rows());
  }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 5);
}

// Lengths of the seam's segments on one side.
std::vector<double> segments(const TriangleSurface& surface, const JoinOutcome& seam, size_t side) {
  std::vector<double> lengths;
  const size_t n = seam.pairs.size();
  for (size_t k = 0; k < n; ++k)
    lengths.push_back((surface.points.row(seam.pairs[(k + 1) % n][side]) -
                       surface.points.row(seam.pairs[k][side]))
                          .norm());
  return lengths;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Paired segments have the same share in their loop's length; how far they are apart, in mean
// segments.
double share_error(const JoinOutcome& seam) {
  const auto a = segments(seam.first, seam, 0), b = segments(seam.second, seam, 1);
  double worst = 0;
  for (size_t k = 0; k < a.size(); ++k)
    worst = std::max(worst, std::abs(a[k] / sum(a) - b[k] / sum(b)) * double(a.size()));
  return worst;
}

TEST(Join, PairedSegmentsHaveEqualSharesOnCoarseAndFineTubes) {
  std::mt19937 random(8);
  testing::MadeBySurgery worst;
  int i = 0;
  double shortest = 1e300, most_pairs = 0;
  for (const int svc : {24, 40, 60, 84, 120})
    for (const int rpa : {24, 40, 60, 84, 120}) {
      SCOPED_TRACE(std::to_string(svc) + " and " + std::to_string(rpa) + " around");
      ++i;
      const auto op = operate(i, 0.7 * i, random, {svc, rpa});
      const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
      EXPECT_LT(share_error(seam), 1e-9);
      // What the slid vertices cut off is second order in the edge.
      const auto a = segments(seam.first, seam, 0), b = segments(seam.second, seam, 1);
      EXPECT_NEAR(sum(a) / sum(b), 1, 3.0 / (svc * svc) + 3.0 / (rpa * rpa));
      const double n = double(std::max(op.mouth.size(), op.rim.size()));
      most_pairs = std::max(most_pairs, double(seam.pairs.size()) / n);
      for (const auto* lengths : {&a, &b})
        shortest = std::min(shortest, *std::min_element(lengths->begin(), lengths->end()) /
                                          sum(*lengths) * double(lengths->size()));
      see(op, seam, worst);
    }
  EXPECT_GT(worst.shortest_edge, 0.05);
  EXPECT_GT(worst.smallest_angle, 4);  // 120 vertices of one loop in a mesh of 24 around
  EXPECT_GT(shortest, 0.2);            // of the mean segment
  EXPECT_LT(most_pairs, 1.3);
}

TEST(Join, TurningTheMouthTurnsTheMatch) {
  // The tips are paired with the mouth's points farthest along the recipient, whichever vertices
  // these are.
  for (const double phi : {0.0, 1.0, 2.5, -2.0}) {
    std::mt19937 random(21);
    const auto op = operate(4, phi, random);
    const auto seam = match_seam(op.svc, op.mouth, op.mouth_start, op.rpa, op.rim, op.other_tip);
    const Vec3 first = seam.second.points.row(seam.pairs.front()[1]);
    const Vec3 other = seam.second.points.row(seam.pairs[static_cast<size_t>(seam.other_tip)][1]);
    const Vec3 along = (other - first).normalized();
    // Start position of the mouth's partner of the first tip, from its source.
    Vec3 start = Vec3::Zero();
    const auto& source = seam.first_sources[static_cast<size_t>(seam.pairs.front()[0])];
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

TEST(Join, TheTipsMeetTheMouthAtTheStatedAngle) {
  // A round mouth over a slit along x: turned by phi, the tips meet the points at -phi and pi - phi
  // of its section, between vertices or not.
  for (const int around : {40, 80}) {
    testing::TubeShape upper, lower;
    upper.around = around;
    upper.along = around;
    lower.around = around + 4;
    lower.along = around + 20;
    const auto svc = testing::noisy_tube(upper);
    const Pose section = testing::tube_frame(upper, 20);
    const auto cut = cut_vessel(svc, section, section.position, {0, 0, 0});
    const auto rpa = testing::noisy_tube(lower);
    const auto incision =
        open_incision(rpa, testing::tube_rod(lower), testing::tube_binding(lower, rpa.points), {},
                      testing::on_tube(lower, 0.3, 20, lower.radius), cut.perimeter / 2, 5);
    const Vec3 outward(std::cos(0.3), std::sin(0.3), 0);
    for (const double phi : {0.0, 0.02, 0.05, 1.0, -2.3}) {
      const Pose target =
          mouth_pose(incision.pick, outward, Vec3::UnitZ(), phi) * section.inverse();
      Points start(static_cast<Eigen::Index>(cut.mouth.size()), 3);
      for (size_t k = 0; k < cut.mouth.size(); ++k)
        start.row(static_cast<Eigen::Index>(k)) = target * Vec3(cut.kept.points.row(cut.mouth[k]));
      const auto seam = match_seam(cut.kept, cut.mouth, start, incision.surface, incision.rim,
                                   incision.other_tip);
      for (const int tip : {0, seam.other_tip}) {
        const auto& [a, b] = seam.pairs[index(tip)];
        const Vec3 on_rim = incision.surface.points.row(b);
        const Vec3 on_mouth = target * Vec3(seam.first.points.row(a));
        const double sense = on_rim.z() > incision.pick.z() ? 1 : -1;
        const Vec3 from_middle = on_mouth - incision.pick;
        const double off = std::atan2(outward.cross(sense * Vec3::UnitZ()).dot(from_middle),
                                      sense * from_middle.z());
        // Arc lengths of polygons differ from angles in second order of the edge.
        EXPECT_LT(std::abs(off) * 180 / M_PI, 8.0 / (around * around)) << phi;
      }
    }
  }
}

}  // namespace
}  // namespace vasorod
