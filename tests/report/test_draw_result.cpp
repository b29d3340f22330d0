#include <algorithm>
#include <array>
#include <functional>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <vasorod/error.h>

#include "report/draw_result.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

using Pixel = std::array<int, 4>;

// Read back with VTK, a second decoder.
std::vector<Pixel> pixels_of(const std::string& png, std::array<int, 2> size = {760, 540}) {
  vtkNew<vtkPNGReader> reader;
  reader->SetMemoryBuffer(png.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(png.size()));
  reader->Update();
  const vtkImageData* image = reader->GetOutput();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], size[0]);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], size[1]);
  const auto* bytes = static_cast<const unsigned char*>(
      const_cast<vtkImageData*>(image)->GetScalarPointer());  // NOLINT: VTK has no const one
  std::vector<Pixel> pixels;
  for (int k = 0; k < size[0] * size[1]; ++k)
    pixels.push_back({bytes[4 * k], bytes[4 * k + 1], bytes[4 * k + 2], bytes[4 * k + 3]});
  return pixels;
}

long count(const std::vector<Pixel>& pixels, const std::function<bool(const Pixel&)>& what) {
  return std::count_if(pixels.begin(), pixels.end(), what);
}

bool is_red(const Pixel& p) {
  return p[3] == 255 && p[0] > 120 && p[1] < 0.5 * p[0] && p[2] < 0.5 * p[0];
}

bool is_drawn(const Pixel& p) {
  return p[3] > 0;
}

TEST(DrawResult, AMarkIsSeenFromItsOwnSide) {
  const Result result = test::example_result();
  DrawOptions options;
  options.only = {"svc"};
  options.rest = true;  // a tube of radius 5 about the z axis
  options.marks = {{0, -5, 30}};
  options.up = Vec3::UnitZ();
  options.from = -Vec3::UnitY();
  EXPECT_GT(count(pixels_of(draw_result(result, options)), is_red), 50);
  options.from = Vec3::UnitY();
  EXPECT_EQ(count(pixels_of(draw_result(result, options)), is_red), 0) << "behind the vessel";
}

TEST(DrawResult, OneRangeOfColoursShowsTwoResultsAlike) {
  Result pressed = test::example_result();
  pressed.vessels[0].contact_pressure *= 10;  // 75 mmHg
  Result softer = pressed;
  softer.vessels[0].contact_pressure *= 0.2;  // above what every range reaches to
  DrawOptions options;
  options.colour = "contact_pressure";
  options.from = Vec3::UnitX();
  options.up = Vec3::UnitZ();
  options.only = {"svc"};
  // Beside the legend, which has all colours.
  const auto dark = [&](const Result& result) {
    const auto pixels = pixels_of(draw_result(result, options));
    long sum = 0;
    for (int k = 0; k < 760 * 540; ++k)
      sum += k % 760 < 600 && pixels[static_cast<std::size_t>(k)][3] == 255 &&
             pixels[static_cast<std::size_t>(k)][1] < 70 &&
             pixels[static_cast<std::size_t>(k)][0] > 60;
    return sum;
  };
  const long own = dark(softer);
  EXPECT_NEAR(static_cast<double>(own), static_cast<double>(dark(pressed)), 2)
      << "each in its own range";
  options.range = {{0, 1e-2}};
  EXPECT_GT(dark(pressed), 100);
  EXPECT_LT(dark(softer), dark(pressed) / 10);
}

TEST(DrawResult, CentreAndHeightSayWhatIsVisible) {
  const Result result = test::example_result();
  DrawOptions options;
  options.only = {"svc"};
  options.rest = true;
  options.from = -Vec3::UnitY();
  options.up = Vec3::UnitZ();
  options.centre = Vec3(0, 0, 30);
  options.height = 20;  // of a tube 60 high and 10 wide
  options.size = {100, 100};
  const double half =
      static_cast<double>(count(pixels_of(draw_result(result, options), {100, 100}), is_drawn));
  EXPECT_NEAR(half, 5000, 250) << "10 of 20 wide over the whole height, and its outline";
}

TEST(DrawResult, MeshAndRodAreDrawnWhereTheyAreAskedFor) {
  const Result result = test::example_result();
  DrawOptions options;
  options.only = {"svc"};
  options.from = -Vec3::UnitY();
  const auto dark = [](const Pixel& p) { return p[3] > 0 && p[0] + p[1] + p[2] < 240; };
  const long plain = count(pixels_of(draw_result(result, options)), dark);
  options.mesh = true;
  EXPECT_GT(count(pixels_of(draw_result(result, options)), dark), plain + 400);
  options.mesh = false;
  options.rod = true;
  const auto pixels = pixels_of(draw_result(result, options));
  EXPECT_GT(count(pixels, dark), plain + 100) << "the rod is dark";
  EXPECT_GT(count(pixels, [](const Pixel& p) { return p[0] > p[1] + 30 && p[0] > p[2] + 30; }), 20)
      << "d1 is red";
}

TEST(DrawResult, StripesArePaintedOnTheWall) {
  const Result result = test::example_result();
  DrawOptions options;
  options.only = {"svc"};
  options.rest = true;
  options.from = -Vec3::UnitY();
  options.stripes = 6;
  const auto pixels = pixels_of(draw_result(result, options));
  const auto blue = [](const Pixel& p) { return p[3] == 255 && p[2] > p[0] + 60; };
  const double all = static_cast<double>(count(pixels, is_drawn));
  EXPECT_NEAR(static_cast<double>(count(pixels, blue)) / all, 0.45, 0.2) << "about half of it";
}

TEST(DrawResult, LetteringIsAddedAndChangesNoBody) {
  Result result = test::example_result();
  const auto drawn = [&](bool lettering) {
    DrawOptions options;
    options.lettering = lettering;
    return pixels_of(draw_result(result, options));
  };
  const auto plain = drawn(false), lettered = drawn(true);
  EXPECT_GT(count(lettered, is_drawn), count(plain, is_drawn) + 300);
  long changed = 0;
  for (std::size_t k = 0; k < plain.size(); ++k)
    changed += plain[k][3] == 255 && plain[k] != lettered[k];
  EXPECT_LT(changed, 200) << "the ends of the leaders";
  for (VesselResult& vessel : result.vessels) vessel.space = "LPS";
  EXPECT_GT(count(drawn(true), is_drawn), count(lettered, is_drawn) + 50) << "the patient's axes";
}

TEST(DrawResult, WhatCannotBeDrawnIsRefusedInASentence) {
  const Result result = test::example_result();
  const auto said = [&](const std::function<void(DrawOptions&)>& change) -> std::string {
    DrawOptions options;
    change(options);
    try {
      draw_result(result, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(said([](DrawOptions& o) { o.only = {"vein"}; }),
            "found no vessel \"vein\" to draw, expected svc, svc stump or aorta");
  EXPECT_EQ(said([](DrawOptions& o) {
              o.colour = "twist_shear";
              o.range = {{1, 1}};
            }),
            "found the range of colours from 1 to 1, expected a lower end first");
  EXPECT_EQ(said([](DrawOptions& o) {
              o.range = {{0, 1}};
            }),
            "found a range of colours without a field, expected one with the colour twist_shear, "
            "axial_stretch or contact_pressure");
  EXPECT_EQ(
      said([](DrawOptions& o) {
        o.colour = "twist_shear";
        o.stripes = 4;
      }),
      "found stripes and the colour \"twist_shear\", expected the colour vessel with stripes");
  EXPECT_EQ(said([](DrawOptions& o) { o.from = Vec3::Zero(); }),
            "found the direction (0, 0, 0) of the eye, expected one that is not zero");
  EXPECT_EQ(said([](DrawOptions& o) { o.colour = "blue"; }),
            "found the colour \"blue\", expected vessel, twist_shear, axial_stretch or "
            "contact_pressure");
}

}  // namespace
}  // namespace vasorod
