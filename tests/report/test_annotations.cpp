#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>

#include "report/annotations.h"
#include "report/lettering.h"
#include "report/solids.h"

namespace vasorod {
namespace {

constexpr int width = 520, height = 390;

Picture blank() {
  return {width, height, std::vector<std::uint8_t>(4 * std::size_t{width} * height)};
}

std::uint8_t alpha(const Picture& picture, int column, int row) {
  return picture.rgba[4 * static_cast<std::size_t>(picture.width * row + column) + 3];
}

long drawn_in(const Picture& picture, int left, int right) {
  long sum = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = left; column < right; ++column) sum += alpha(picture, column, row) > 0;
  return sum;
}

// From the front of a patient whose coordinates are LPS: the eye is at negative y, the head up.
Camera from_the_front() {
  const TriangleSurface body = ball(Vec3::Zero(), 40);
  return fit_camera({{&body.points, true}}, -Vec3::UnitY(), Vec3::UnitZ(), double(width) / height);
}

TEST(Annotations, ScaleBarsHaveRoundLengths) {
  EXPECT_DOUBLE_EQ(round_length(19), 10);
  EXPECT_DOUBLE_EQ(round_length(20), 20);
  EXPECT_DOUBLE_EQ(round_length(99), 50);
  EXPECT_DOUBLE_EQ(round_length(0.0031), 0.002);
}

TEST(Annotations, TheScaleBarIsAsLongAsItsLengthInThePicture) {
  const Camera camera = from_the_front();
  Picture picture = blank();
  FreeRoom room(picture);
  draw_scale_bar(picture, room, camera, "mm");
  int longest = 0;
  for (int row = 0; row < height; ++row) {
    int run = 0;
    for (int column = 0; column < width; ++column) {
      run = alpha(picture, column, row) > 100 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  const auto at = [&](double x) {
    return pixel_of(camera, camera.centre + Vec3(x, 0, 0), width, height);
  };
  const double unit = (at(1) - at(0)).norm(), length = longest / unit;
  EXPECT_NEAR(length, round_length(0.2 * width / unit), 4 / unit);
}

double ink_of(const Picture& picture, int left, int right) {
  double sum = 0;
  for (int row = 0; row < picture.height; ++row)
    for (int column = left; column < right; ++column) sum += alpha(picture, column, row) / 255.0;
  return sum;
}

// The lines are symmetric, and an R has more ink than an L.
TEST(Annotations, FromTheFrontThePatientsRightIsAtTheLeft) {
  const double size = height / 26.0;
  const auto letter = [&](const char* text) {
    Picture picture = blank();
    draw_text(picture, 100, 100, text, size, {0, 0, 0});
    return ink_of(picture, 0, width);
  };
  const double more = letter("R") - letter("L");
  ASSERT_GT(more, 10);
  for (const bool front : {true, false}) {
    Camera camera = from_the_front();
    if (!front) {
      camera.axes.row(0) *= -1;
      camera.axes.row(2) *= -1;
    }
    Picture picture = blank();
    FreeRoom room(picture);
    draw_orientation(picture, room, camera, "LPS");
    int first = width, last = 0;
    for (int column = 0; column < width; ++column)
      if (drawn_in(picture, column, column + 1) > 0) {
        first = std::min(first, column);
        last = column;
      }
    const int third = (last - first) / 3;
    const double difference =
        ink_of(picture, first, first + third) - ink_of(picture, last + 1 - third, last + 1);
    EXPECT_NEAR(difference, front ? more : -more, 0.3 * more);
  }
}

TEST(Annotations, BothSpacesShowTheSamePatientAlikeAndNoneShowsNothing) {
  Camera camera = from_the_front();
  camera.axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Camera turned = camera;
  turned.axes.col(0) *= -1;
  turned.axes.col(1) *= -1;
  const auto drawn = [&](const Camera& from, const std::string& space) {
    Picture picture = blank();
    FreeRoom room(picture);
    draw_orientation(picture, room, from, space);
    return picture.rgba;
  };
  EXPECT_EQ(drawn(camera, "LPS"), drawn(turned, "RAS"));
  EXPECT_NE(drawn(camera, "LPS"), drawn(camera, "RAS"));
  EXPECT_EQ(drawn(camera, ""), blank().rgba);
}

// Two squares, 0 at the left and 1 at the right.
struct Squares {
  Picture picture = blank();
  std::vector<int> bodies = std::vector<int>(std::size_t{width} * height, -1);
  Squares() {
    for (int row = 150; row < 250; ++row)
      for (int column = 60; column < 460; ++column) {
        if (column >= 160 && column < 360) continue;
        const auto at = static_cast<std::size_t>(width * row + column);
        bodies[at] = column < 260 ? 0 : 1;
        picture.rgba[4 * at + 3] = 200;
      }
  }
};

TEST(Annotations, NamesStandBesideTheirBodies) {
  const Squares squares;
  for (const int body : {0, 1}) {
    Picture picture = squares.picture;
    FreeRoom room(picture);
    std::vector<std::string> names(2);
    names[static_cast<std::size_t>(body)] = "vein_1";
    draw_labels(picture, room, squares.bodies, names);
    long left = 0, right = 0;
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        if (alpha(picture, column, row) != alpha(squares.picture, column, row))
          ++(column < 260 ? left : right);
    EXPECT_GT(body == 0 ? left : right, 50);
    EXPECT_EQ(body == 0 ? right : left, 0);
  }
}

TEST(Annotations, LabelsLeaveEachOtherAndTheBodiesAlone) {
  const Squares squares;
  Picture picture = squares.picture;
  FreeRoom room(picture);
  draw_labels(picture, room, squares.bodies, {"left", "right"});
  long changed = 0;
  for (int row = 160; row < 240; ++row)
    for (int column = 70; column < 450; ++column)
      if (squares.bodies[static_cast<std::size_t>(width * row + column)] >= 0)
        changed += alpha(picture, column, row) != 200;
  EXPECT_LT(changed, 40) << "the ends of two leaders";
  Picture hidden = squares.picture;
  FreeRoom more(hidden);
  draw_labels(hidden, more, squares.bodies, {"", "", "not visible"});
  EXPECT_EQ(hidden.rgba, squares.picture.rgba);
}

TEST(Annotations, OnlyASmallPatchIsWorthACloseUp) {
  const TriangleSurface body = ball(Vec3::Zero(), 40);
  const Camera camera = from_the_front();
  const ColourScale scale{ColourMap::sequential, 0, 10, ""};
  const Vec3 front = -40 * Vec3::UnitY();
  const auto patch_of = [&](double reach, double value) {
    Eigen::VectorXd values(body.points.rows());
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values[i] = (body.points.row(i).transpose() - front).norm() < reach ? value : 0;
    return small_patch({{&body.points, &values}}, scale, 0, camera);
  };
  const auto small = patch_of(10, 5);
  ASSERT_TRUE(small);
  EXPECT_LT((small->centre - front).norm(), 10);
  EXPECT_LT(close_up(*small, camera).half_height, 0.5 * camera.half_height);
  EXPECT_FALSE(patch_of(100, 5)) << "all of it";
  EXPECT_FALSE(patch_of(10, 0)) << "nothing";
  EXPECT_FALSE(patch_of(10, 0.1)) << "a hundredth of the scale";
}

TEST(Annotations, TheInsetShowsTheCloseUpWhereThePictureIsEmpty) {
  Squares squares;
  const Camera camera = from_the_front();
  FreeRoom room(squares.picture);
  const int side = 100;
  Picture inset{side, side, std::vector<std::uint8_t>(4 * std::size_t{side} * side, 77)};
  const Picture before = squares.picture;
  draw_inset(squares.picture, room, inset, {camera.centre, 3}, camera);
  long shown = 0, spoilt = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      shown += alpha(squares.picture, column, row) == 77;
      spoilt += alpha(before, column, row) > 0 &&
                alpha(squares.picture, column, row) != alpha(before, column, row);
    }
  EXPECT_GT(shown, 90 * 90);
  EXPECT_EQ(spoilt, 0) << "there is room beside the squares";
}

}  // namespace
}  // namespace vasorod
