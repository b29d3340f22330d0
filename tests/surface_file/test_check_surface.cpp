#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <vasorod/error.h>

#include "scratch_folder.h"
#include "surface_file/check_surface.h"
#include "surface_file/read_surface.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

class CheckSurface : public ScratchFolder {
 protected:
  // The sentence that refuses the file; empty if it is accepted. The terminal must stay empty.
  std::string refusal(const std::filesystem::path& file, Role role = Role::deformable) const {
    VesselSpec vessel = vessel_of(file);
    vessel.role = role;
    std::string sentence;
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    try {
      load_surface(vessel, Scene());
    } catch (const InputError& error) {
      sentence = error.what();
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    if (!sentence.empty()) {
      EXPECT_EQ(sentence.rfind(file.string() + ":", 0), 0U) << sentence;
      EXPECT_NE(sentence.find(": found "), std::string::npos) << sentence;
      EXPECT_NE(sentence.find(", expected "), std::string::npos) << sentence;
    }
    return sentence;
  }
  std::string refusal(const TriangleSurface& surface, Role role = Role::deformable) const {
    write_vtp(folder / "surface.vtp", surface);
    return refusal(folder / "surface.vtp", role);
  }
  static void expect_says(const std::string& sentence, const std::string& words) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  }
};

TEST_F(CheckSurface, SoundTube) {
  EXPECT_EQ(refusal(sample_tube()), "");
}

TEST_F(CheckSurface, MissingFile) {
  expect_says(refusal(folder / "none.vtp"), "no such file");
}

TEST_F(CheckSurface, FolderInsteadOfFile) {
  std::filesystem::create_directory(folder / "folder.vtp");
  expect_says(refusal(folder / "folder.vtp"), "a folder");
}

TEST_F(CheckSurface, UnknownEnding) {
  expect_says(refusal(write("tube.step", "x")), ".vtp, .stl, .ply or .obj");
}

TEST_F(CheckSurface, EmptyFiles) {
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj"})
    expect_says(refusal(write(name, "")), "an empty file");
}

TEST_F(CheckSurface, TextThatIsNoSurface) {
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj"})
    EXPECT_NE(refusal(write(name, "this is not a surface\n")), "") << name;
}

TEST_F(CheckSurface, ObjWithImpossibleLines) {
  expect_says(refusal(write("a.obj", "v 0 0\n")), "a point of 2 coordinates");
  expect_says(refusal(write("a.obj", "v 0 0 x\n")), "not a number");
  expect_says(refusal(write("a.obj", "v 0 0 0\nf 1 0 1\n")), "a point that does not exist");
  expect_says(refusal(write("a.obj", "v 0 0 0\nf -1 -2 -1\n")), "a point that does not exist");
  expect_says(refusal(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")),
              "a point that does not exist");
}

TEST_F(CheckSurface, TruncatedVtp) {
  for (const Encoding encoding : {Encoding::ascii, Encoding::inline_binary, Encoding::appended_raw,
                                  Encoding::appended_base64, Encoding::zlib}) {
    write_vtp(folder / "whole.vtp", sample_tube(), encoding);
    std::ifstream in(folder / "whole.vtp", std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    for (const double part : {0.1, 0.5, 0.9})
      EXPECT_NE(
          refusal(write("cut.vtp", whole.substr(0, static_cast<size_t>(
                                                       part * static_cast<double>(whole.size()))))),
          "")
          << static_cast<int>(encoding) << " " << part;
  }
}

TEST_F(CheckSurface, NoTriangles) {
  TriangleSurface points = sample_tube();
  points.triangles.resize(0, 3);
  expect_says(refusal(points), "no triangles");
}

TEST_F(CheckSurface, PointsThatAreNoNumbers) {
  TriangleSurface surface = sample_tube();
  surface.points(17, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_says(refusal(surface), "point 17");
  surface.points(17, 1) = std::numeric_limits<double>::infinity();
  expect_says(refusal(surface), "point 17");
}

TEST_F(CheckSurface, NonManifoldEdge) {
  TriangleSurface fin = sample_tube();
  const int tip = static_cast<int>(fin.points.rows());
  fin.points.conservativeResize(tip + 1, 3);
  fin.points.row(tip) << 20, 0, 20;
  fin.triangles.conservativeResize(fin.triangles.rows() + 1, 3);
  fin.triangles.row(fin.triangles.rows() - 1) << 240, 241, tip;
  expect_says(refusal(fin), "a non-manifold edge with 3 triangles at (9.8");
}

TEST_F(CheckSurface, NonManifoldPoint) {
  TriangleSurface other = sample_tube();
  other.points.col(0).array() += 20;  // its point at -10 coincides with the first tube's at 10
  TriangleSurface both = joined(sample_tube(), other);
  const int shared = 24 * 10, twin = static_cast<int>(other.points.rows()) + 24 * 10 + 12;
  ASSERT_LT((both.points.row(shared) - both.points.row(twin)).norm(), 1e-12);
  both.triangles = both.triangles.unaryExpr([&](int i) { return i == twin ? shared : i; });
  expect_says(refusal(both), "only touch at (10, ");
}

TEST_F(CheckSurface, NonManifoldPointOnAnEnd) {
  TriangleSurface other = sample_tube();
  other.points.col(0).array() += 20;
  TriangleSurface both = joined(sample_tube(), other);
  const int twin = static_cast<int>(other.points.rows()) + 12;
  both.triangles = both.triangles.unaryExpr([&](int i) { return i == twin ? 0 : i; });
  expect_says(refusal(both), "only touch at (10, 0, 0)");
}

TEST_F(CheckSurface, TwoComponents) {
  TriangleSurface other = sample_tube();
  other.points.col(0).array() += 30;
  expect_says(refusal(joined(sample_tube(), other)), "2 separate parts");
}

TEST_F(CheckSurface, InconsistentOrientation) {
  TriangleSurface surface = sample_tube();
  std::swap(surface.triangles(100, 0), surface.triangles(100, 1));
  expect_says(refusal(surface), "opposite orientation");
}

TEST_F(CheckSurface, InvertedOrientation) {
  TriangleSurface surface = sample_tube();
  surface.triangles.col(0).swap(surface.triangles.col(1));
  expect_says(refusal(surface), "an inverted surface");
}

TEST_F(CheckSurface, InvertedOrientationFarFromTheOrigin) {
  TriangleSurface surface = sample_tube();
  surface.points.rowwise() += Eigen::RowVector3d(300, -500, 900);
  EXPECT_EQ(refusal(surface), "");
  surface.triangles.col(0).swap(surface.triangles.col(1));
  expect_says(refusal(surface), "an inverted surface");
}

TEST_F(CheckSurface, ClosedWithoutEnds) {
  expect_says(refusal(closed_tube({0, 1}, 12)), "a closed surface with no ends");
  EXPECT_EQ(refusal(closed_tube({0, 1}, 12), Role::obstacle), "");
}

TEST_F(CheckSurface, OneEnd) {
  expect_says(refusal(closed_tube({1}, 12)), "one open end, at (10, 0, 0)");
}

TEST_F(CheckSurface, HoleInTheWall) {
  TriangleSurface surface = sample_tube();
  surface.triangles.conservativeResize(surface.triangles.rows(), 3);
  Triangles rest(surface.triangles.rows() - 1, 3);
  rest << surface.triangles.topRows(500),
      surface.triangles.bottomRows(surface.triangles.rows() - 501);
  surface.triangles = rest;
  expect_says(refusal(surface), "an opening of 3 edges");
}

TEST_F(CheckSurface, Handle) {
  // A torus without the triangles around two of its points: two ends.
  constexpr int n = 40, m = 16;
  TriangleSurface torus;
  torus.points.resize(n * m, 3);
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / m;
      torus.points.row(i * m + j) << (30 + 10 * std::cos(b)) * std::cos(a),
          (30 + 10 * std::cos(b)) * std::sin(a), 10 * std::sin(b);
      const int p = i * m + j, q = (i + 1) % n * m + j, r = (i + 1) % n * m + (j + 1) % m,
                s = i * m + (j + 1) % m;
      faces.push_back({p, q, r});
      faces.push_back({p, r, s});
    }
  auto gone = [](int i) { return i == 5 || i == 20 * m + 5; };
  std::erase_if(faces, [&](const auto& f) { return gone(f[0]) || gone(f[1]) || gone(f[2]); });
  torus.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (size_t t = 0; t < faces.size(); ++t)
    torus.triangles.row(static_cast<Eigen::Index>(t)) << faces[t][0], faces[t][1], faces[t][2];
  expect_says(refusal(torus), "1 handle");
}

TEST_F(CheckSurface, SelfIntersection) {
  TriangleSurface surface = sample_tube();
  surface.points.row(24 * 10) << -15, 0, 20;  // moved through the opposite wall
  expect_says(refusal(surface), "crosses itself");
}

// Points at random: nearly every two of its 4800 triangles that are near each other cross.
TEST_F(CheckSurface, TheSearchForCrossingsOfACrumpledSurfaceEnds) {
  TubeSpec spec = small_tube();
  spec.along = 100;
  TriangleSurface crumpled = tube_surface(spec);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  crumpled.points = crumpled.points.unaryExpr([&](double) { return coordinate(random); });
  try {
    check_self_intersections("vessel.vtp", crumpled);
    FAIL() << "no crossing found";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("in 10000 or more pairs of triangles"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(CheckSurface, Unit) {
  TriangleSurface surface = sample_tube();
  surface.points /= 1000;
  expect_says(refusal(surface), "as it would be if the file is in m)");
  surface.points *= 1e6;
  expect_says(refusal(surface), "check: false");
}

TEST_F(CheckSurface, TypicalRadiusOfATubeAndABall) {
  TubeSpec fine = small_tube();
  fine.around = 200;
  fine.along = 60;
  EXPECT_NEAR(typical_radius(tube_surface(fine)), 10, 0.01);
}

}  // namespace
}  // namespace vasorod
