#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>

#include "report/picture.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

// A sphere around a point: rings of triangles between its poles.
TriangleSurface sphere(const Vec3& centre, double radius) {
  constexpr int around = 96, along = 48;
  TriangleSurface ball = test::tube(1, M_PI, around, along);
  for (Eigen::Index i = 0; i < ball.points.rows(); ++i) {
    const Vec3 p = ball.points.row(i).transpose();
    const double polar = std::clamp(p.z(), 1e-6, M_PI - 1e-6);
    ball.points.row(i) =
        (centre + radius * Vec3(std::sin(polar) * p.x(), std::sin(polar) * p.y(), -std::cos(polar)))
            .transpose();
  }
  return ball;
}

// A square of half side h at height z, its front towards +z.
TriangleSurface square(double h, double z) {
  TriangleSurface s;
  s.points.resize(4, 3);
  s.points << -h, -h, z, h, -h, z, h, h, z, -h, h, z;
  s.triangles.resize(2, 3);
  s.triangles << 0, 1, 2, 0, 2, 3;
  return s;
}

Camera from_above(double distance, double half_height) {
  Camera camera;
  camera.distance = distance;
  camera.half_height = half_height;
  return camera;
}

DrawnSurface drawn(const TriangleSurface& surface, const Colour& colour, float opacity = 1) {
  return {&surface.points, &surface.triangles, colour, opacity, nullptr, nullptr};
}

const std::uint8_t* pixel(const Picture& picture, int column, int row) {
  return &picture.rgba[4 * static_cast<std::size_t>(row * picture.width + column)];
}

double covered(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) sum += picture.rgba[i] / 255.0;
  return sum;
}

TEST(Picture, ASphereCoversTheDiskPerspectiveGivesIt) {
  const double radius = 1, distance = 5, half = 2;
  const TriangleSurface ball = sphere(Vec3::Zero(), radius);
  const Picture picture =
      render({drawn(ball, {0.8F, 0.2F, 0.2F})}, from_above(distance, half), 400, 300);
  // The rays tangent to the sphere meet the plane of its centre at r D / sqrt(D^2 - r^2).
  const double seen = radius * distance / std::sqrt(distance * distance - radius * radius);
  const double pixels = M_PI * std::pow(seen * 150 / half, 2);
  EXPECT_NEAR(covered(picture), pixels,
              0.02 * pixels);  // the outline is half a pixel wide outside the disk
  EXPECT_EQ(pixel(picture, 0, 0)[3], 0) << "nothing is drawn behind the bodies";
  EXPECT_EQ(pixel(picture, 200, 150)[3], 255);
}

TEST(Picture, WhatIsNearerHidesWhatIsFarther) {
  const TriangleSurface near = square(0.5, 0.5), far = square(1, -0.5);
  const Colour red{1, 0, 0}, blue{0, 0, 1};
  for (const bool near_first : {true, false}) {
    const auto a = drawn(near, red), b = drawn(far, blue);
    const Picture picture =
        render(near_first ? std::vector{a, b} : std::vector{b, a}, from_above(10, 1.5), 100, 100);
    EXPECT_GT(pixel(picture, 50, 50)[0], 150);
    EXPECT_LT(pixel(picture, 50, 50)[2], 30);
    EXPECT_GT(pixel(picture, 24, 50)[2], 150);
    EXPECT_LT(pixel(picture, 24, 50)[0], 30);
  }
}

TEST(Picture, ASlitThatIsClosedShowsAsALineWhereNothingHidesIt) {
  TriangleSurface left = square(0.5, 0), right = left;
  left.points.col(0).array() -= 0.5;
  right.points.col(0).array() += 0.5;
  const Colour grey{0.8F, 0.8F, 0.8F};
  const auto darkness = [&](const std::vector<DrawnSurface>& surfaces) {
    const Picture picture = render(surfaces, from_above(10, 1.5), 100, 100);
    return pixel(picture, 60, 50)[0] - pixel(picture, 50, 50)[0];
  };
  EXPECT_GT(darkness({drawn(left, grey), drawn(right, grey)}), 60);
  TriangleSurface whole = left;
  whole.points.conservativeResize(6, 3);
  whole.points.bottomRows(2) << 1, -0.5, 0, 1, 0.5, 0;
  whole.triangles.conservativeResize(4, 3);
  whole.triangles.bottomRows(2) << 1, 4, 5, 1, 5, 2;
  EXPECT_LT(darkness({drawn(whole, grey)}), 5) << "an edge of two triangles is no border";
  const TriangleSurface cover = square(0.7, 0.3);
  EXPECT_LT(darkness({drawn(left, grey), drawn(right, grey), drawn(cover, grey)}), 5)
      << "it is hidden";
}

TEST(Picture, GlassShowsBothItsColourAndWhatIsBehind) {
  const TriangleSurface pane = square(1, 0.5), wall = square(1, -0.5);
  const auto at = [&](float opacity) {
    const Picture picture = render({drawn(pane, {1, 0, 0}, opacity), drawn(wall, {0, 0, 1})},
                                   from_above(10, 1.5), 60, 60);
    return std::array<int, 3>{pixel(picture, 30, 30)[0], pixel(picture, 30, 30)[2],
                              pixel(picture, 30, 30)[3]};
  };
  const auto solid = at(1), glass = at(0.4F), thin = at(0.1F);
  EXPECT_GT(solid[0], glass[0]);
  EXPECT_GT(glass[0], thin[0]);
  EXPECT_LT(solid[1], glass[1]);
  EXPECT_LT(glass[1], thin[1]);
  EXPECT_EQ(glass[2], 255) << "glass before a wall is opaque";
  const Picture alone = render({drawn(pane, {1, 0, 0}, 0.4F)}, from_above(10, 1.5), 60, 60);
  EXPECT_NEAR(pixel(alone, 30, 30)[3], 0.4 * 255, 1.5) << "face-on, glass hides its opacity";
}

TEST(Picture, AMeshShowsTheEdgesInFrontOfEveryBody) {
  TriangleSurface near = square(1, 0.5), far = square(1, -0.5);
  const auto darker = [&](bool of_near, bool of_far, float opacity) {
    std::vector<DrawnSurface> surfaces{drawn(near, {0.8F, 0.8F, 0.8F}, opacity),
                                       drawn(far, {0.8F, 0.8F, 0.8F})};
    const Picture plain = render(surfaces, from_above(10, 1.5), 90, 90);
    surfaces[0].mesh = of_near;
    surfaces[1].mesh = of_far;
    const Picture meshed = render(surfaces, from_above(10, 1.5), 90, 90);
    // The middle of the squares is on the edge that their two triangles share.
    return pixel(plain, 45, 44)[0] - pixel(meshed, 45, 44)[0];
  };
  EXPECT_GT(darker(true, false, 1), 20);
  EXPECT_EQ(darker(false, true, 1), 0) << "it is behind a solid body";
  EXPECT_EQ(darker(false, true, 0.3F), 0) << "it is behind a pane";
  EXPECT_GT(darker(true, false, 0.3F), 10) << "on a pane";
}

TEST(Picture, TheInsideIsDarker) {
  TriangleSurface front = square(1, 0);
  const Picture outside = render({drawn(front, {0.5F, 0.5F, 0.5F})}, from_above(10, 1.5), 40, 40);
  front.triangles.col(1).swap(front.triangles.col(2));
  const Picture inside = render({drawn(front, {0.5F, 0.5F, 0.5F})}, from_above(10, 1.5), 40, 40);
  EXPECT_GT(pixel(outside, 20, 20)[0], pixel(inside, 20, 20)[0] + 30);
}

TEST(Picture, ValuesAreColouredByTheirScale) {
  const TriangleSurface plate = square(1, 0);
  const ColourScale scale{ColourMap::diverging, -1, 1, "x"};
  for (const double value : {-1.0, 1.0}) {
    const Eigen::VectorXd values = Eigen::VectorXd::Constant(4, value);
    DrawnSurface surface = drawn(plate, {});
    surface.values = &values;
    surface.scale = &scale;
    const Picture picture = render({surface}, from_above(10, 1.5), 40, 40);
    const std::uint8_t* seen = pixel(picture, 20, 20);
    const Colour expected = scale(value);
    // White light keeps the ratio of the channels.
    const std::size_t main = value < 0 ? 2 : 0, other = value < 0 ? 0 : 2;
    EXPECT_NEAR(double(seen[other]) / seen[main], expected[other] / expected[main], 0.12);
  }
}

TEST(Picture, DoesNotDependOnWhereTheSceneIs) {
  const VesselResult vessel = test::deformed_tube(48, 60);
  const std::vector<Seen> scene{{&vessel.current, true}};
  const Camera camera = fit_camera(scene, {1, 0.3, 0.2}, Vec3::UnitZ(), 4.0 / 3);
  const Picture here = render({{&vessel.current, &vessel.triangles}}, camera, 200, 150);
  const Mat3 turn = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Vec3 move(300, -200, 100);
  const Points moved = (vessel.current * turn.transpose()).rowwise() + move.transpose();
  Camera there = camera;
  there.centre = turn * camera.centre + move;
  there.axes = camera.axes * turn.transpose();
  const Picture elsewhere = render({{&moved, &vessel.triangles}}, there, 200, 150);
  int differ = 0;
  for (std::size_t i = 0; i < here.rgba.size(); ++i)
    differ += std::abs(here.rgba[i] - elsewhere.rgba[i]) > 6;
  EXPECT_LT(differ, 40) << "of "
                        << here.rgba.size();  // samples that lie on an edge within rounding
}

TEST(Picture, WhatIsBehindTheEyeOrNotANumberIsLeftOut) {
  TriangleSurface behind = square(1, 20);
  EXPECT_EQ(covered(render({drawn(behind, {1, 1, 1})}, from_above(10, 1.5), 40, 40)), 0);
  behind.points.setConstant(std::nan(""));
  EXPECT_EQ(covered(render({drawn(behind, {1, 1, 1})}, from_above(10, 1.5), 40, 40)), 0);
}

}  // namespace
}  // namespace vasorod
