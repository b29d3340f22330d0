#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/tube.h>

#include "vessel/shapes.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

using shapes::Tube;

struct AxisError {
  double position = 0, tangent = 0, radius = 0,
         length = 0;  // over the radius, but tangent: radians
};

// Compares with the tube's own axis, node by node at equal arc length.
AxisError axis_error(const Vessel& vessel, const Tube& tube) {
  double total = 0, s = 0;
  for (const RodElement& e : vessel.rod.elements) total += e.length;
  AxisError worst;
  for (size_t k = 0; k < vessel.rod.rest.size(); ++k) {
    if (k > 0) s += vessel.rod.elements[k - 1].length;
    const double at = s * tube.length / total;
    const Vec3 t = tube.tangent(at), d = vessel.rod.rest[k].position - tube.axis(at);
    worst.position = std::max(worst.position, (d - d.dot(t) * t).norm() / tube.radius);
    worst.tangent = std::max(worst.tangent, (vessel.rod.rest[k].director(3) - t).norm());
    worst.radius =
        std::max(worst.radius, std::abs(vessel.rod.radius[k] - tube.radius_at(at)) / tube.radius);
  }
  worst.length = std::abs(total - tube.length) / tube.length;
  return worst;
}

double reconstruction_error(const Vessel& vessel) {
  const Points carried = carried_points(vessel.rod, vessel.rod.rest, vessel.binding);
  return (carried - vessel.surface.points).rowwise().norm().maxCoeff() / vessel.mean_radius;
}

TEST(Fit, StraightTubeIsExact) {
  for (const double length : {20.0, 30.0, 100.0}) {
    Tube tube;
    tube.length = length;
    tube.along = static_cast<int>(0.8 * length);
    const Vessel vessel = fit_vessel("tube", tube.surface());
    const AxisError error = axis_error(vessel, tube);
    EXPECT_LT(error.position, 1e-10);
    EXPECT_LT(error.tangent, 1e-10);
    EXPECT_LT(error.radius, 1e-10);
    EXPECT_LT(error.length, 1e-10);
    EXPECT_EQ(vessel.rod.elements.size(), static_cast<size_t>(length / 2.5));
    EXPECT_LT(reconstruction_error(vessel), 1e-12);
  }
}

TEST(Fit, BentTubesGiveTheirCircle) {
  for (const double bend : {0.5, M_PI / 2, M_PI}) {
    Tube tube;
    tube.length = 200;
    tube.along = 160;
    tube.bend = bend;
    const Vessel vessel = fit_vessel("tube", tube.surface());
    const AxisError error = axis_error(vessel, tube);
    EXPECT_LT(error.position, 1e-3);
    EXPECT_LT(error.radius, 1e-4);
    EXPECT_LT(error.length, 1e-4);
    EXPECT_LT(reconstruction_error(vessel), 1e-12);
  }
}

TEST(Fit, TaperIsLinear) {
  Tube tube;
  tube.end_radius = 5;
  const Vessel vessel = fit_vessel("tube", tube.surface());
  const AxisError error = axis_error(vessel, tube);
  EXPECT_LT(error.position, 1e-10);
  EXPECT_LT(error.radius, 1e-8);
}

TEST(Fit, EndsLieInTheirSections) {
  Tube tube;
  tube.bend = 1;
  const Vessel vessel = fit_vessel("tube", tube.surface());
  ASSERT_EQ(vessel.ends.size(), 2U);
  EXPECT_EQ(vessel.ends[0].loop.front(), 0);
  EXPECT_EQ(vessel.ends[0].node, 0);
  EXPECT_EQ(vessel.ends[1].node, vessel.rod.node_count() - 1);
  EXPECT_NEAR((vessel.ends[0].outward - Vec3(0, 0, -1)).norm(), 0, 1e-12);
  EXPECT_NEAR((vessel.ends[1].outward - tube.tangent(100)).norm(), 0, 1e-12);
  EXPECT_NEAR((vessel.ends[1].center - tube.axis(100)).norm(), 0, 1e-12);
}

TEST(Fit, MovesWithTheSurface) {
  Tube tube;
  tube.bend = 1.2;
  tube.end_radius = 8;
  const TriangleSurface rough = shapes::noisy(tube.surface(), 0.1);
  const Vessel here = fit_vessel("tube", rough);
  const Pose motion = shapes::some_motion();
  const Vessel there = fit_vessel("tube", shapes::moved(rough, motion));
  ASSERT_EQ(here.rod.node_count(), there.rod.node_count());
  for (size_t k = 0; k < here.rod.rest.size(); ++k) {
    const Pose expected = motion * here.rod.rest[k];
    ASSERT_LT((expected.position - there.rod.rest[k].position).norm(), 1e-9 * 10);
    ASSERT_LT((expected.rotation - there.rod.rest[k].rotation).norm(), 1e-9);
  }
}

TEST(Fit, FramesDoNotTwist) {
  Tube tube;
  tube.bend = M_PI / 2;
  const Vessel vessel = fit_vessel("tube", tube.surface());
  for (const RodElement& e : vessel.rod.elements) {
    EXPECT_LT(std::abs(e.rest_strain[5]), 1e-9);
    EXPECT_NEAR(e.rest_strain[2], 1, 1e-3);
    EXPECT_EQ((e.rest_strain - e.natural_strain).norm(), 0);
  }
}

TEST(Fit, NoiseOfTheWallBarelyMovesTheAxis) {
  Tube tube;
  tube.length = 200;
  tube.along = 160;
  tube.bend = 1;
  for (const double noise : {0.02, 0.05}) {  // over the radius
    const Vessel vessel = fit_vessel("tube", shapes::noisy(tube.surface(), noise * tube.radius));
    EXPECT_LT(axis_error(vessel, tube).position, noise);
    EXPECT_LT(reconstruction_error(vessel), 1e-9);
  }
}

// The sentence that refuses a broken surface.
std::string refusal(const TriangleSurface& surface) {
  try {
    fit_vessel("vein", surface);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Fit, RefusesWhatIsNoTube) {
  const TriangleSurface tube = Tube{}.surface();
  TriangleSurface two = tube;
  two.points.conservativeResize(2 * tube.points.rows(), 3);
  two.points.bottomRows(tube.points.rows()) = tube.points.rowwise() + Eigen::RowVector3d(50, 0, 0);
  two.triangles.conservativeResize(2 * tube.triangles.rows(), 3);
  two.triangles.bottomRows(tube.triangles.rows()) =
      tube.triangles.array() + static_cast<int>(tube.points.rows());
  EXPECT_NE(refusal(two).find("vein: the surface has 2 separate pieces"), std::string::npos);

  TriangleSurface closed;
  closed.points.resize(4, 3);
  closed.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  closed.triangles.resize(4, 3);
  closed.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  EXPECT_NE(refusal(closed).find("closed"), std::string::npos);
  TriangleSurface one_end = closed;
  one_end.triangles.conservativeResize(3, 3);
  EXPECT_NE(refusal(one_end).find("one open end"), std::string::npos);

  TriangleSurface holed = tube;
  holed.triangles.row(3000) = holed.triangles.row(holed.triangles.rows() - 1);
  holed.triangles.conservativeResize(holed.triangles.rows() - 1, 3);
  EXPECT_NE(refusal(holed).find("hole"), std::string::npos);

  TriangleSurface infinite = tube;
  infinite.points(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(infinite).find("not a finite number"), std::string::npos);

  Tube sharp;
  sharp.bend = M_PI;
  sharp.length = 32;  // bends on a circle of radius 10.2, with radius 10
  EXPECT_NE(refusal(sharp.surface()).find("centre of curvature"), std::string::npos)
      << refusal(sharp.surface());

  // A shallow ring around a hole: the fitted axis shrinks to a point.
  TubeSpec ring;
  ring.length = ring.radius = 1;
  ring.around = 48;
  ring.along = 12;
  TriangleSurface shallow = tube_surface(ring);
  for (Eigen::Index i = 0; i < shallow.points.rows(); ++i) {
    const auto row = static_cast<double>(i / ring.around) / ring.along;
    const double angle = 2 * M_PI * static_cast<double>(i % ring.around) / ring.around;
    shallow.points.row(i) = (11 - 6 * row) * Vec3(std::cos(angle), std::sin(angle), 0).transpose();
    shallow.points(i, 2) = 0.5 * std::sin(M_PI * row);
  }
  EXPECT_NE(refusal(shallow).find("no axis"), std::string::npos) << refusal(shallow);

  TubeSpec shortest;  // a thousandth of its radius long
  shortest.length = 0.006;
  shortest.radius = 5;
  shortest.around = 6;
  shortest.along = 4;
  EXPECT_NE(refusal(tube_surface(shortest)).find("no axis"), std::string::npos)
      << refusal(tube_surface(shortest));

  TubeSpec longest;  // was fitted for minutes
  longest.length = 1e9;
  longest.radius = 360;
  longest.around = 6;
  longest.along = 1;
  EXPECT_EQ(refusal(tube_surface(longest)),
            "vessel vein: found an axis of length 1e+09 on a radius of 360, expected at most 50000 "
            "times the radius");

  TubeSpec
      coarse;  // four rows of vertices, three radii apart, around 200: no axis goes through them
  coarse.length = 100;
  coarse.radius = 10;
  coarse.around = 200;
  coarse.along = 3;
  EXPECT_NE(refusal(tube_surface(coarse)).find("rows of triangles"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
