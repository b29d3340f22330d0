#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "geometry/crossing_triangles.h"
#include "geometry/triangle_surface.h"
#include "real_anatomy.h"
#include "scratch_folder.h"
#include "surface_file/read_surface.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

class ReadSurface : public ScratchFolder {
 protected:
  LoadedSurface load(const std::string& name) const {
    return load_surface(vessel_of(folder / name), scene);
  }
  std::string refusal(const VesselSpec& vessel) const {
    try {
      load_surface(vessel, scene);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  Scene scene;
};

void expect_same(const TriangleSurface& a, const TriangleSurface& b, double tolerance) {
  ASSERT_EQ(a.points.rows(), b.points.rows());
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_LE((a.points - b.points).cwiseAbs().maxCoeff(), tolerance);
}

TEST_F(ReadSurface, ReadsEveryEncodingOfVtp) {
  const auto tube = sample_tube();
  for (const Encoding encoding : {Encoding::ascii, Encoding::inline_binary, Encoding::appended_raw,
                                  Encoding::appended_base64, Encoding::zlib}) {
    write_vtp(folder / "tube.vtp", tube, encoding);
    const auto loaded = load("tube.vtp");
    expect_same(loaded.surface, tube, encoding == Encoding::ascii ? 1e-9 : 0);
    EXPECT_EQ(loaded.report.text(), "unchanged");
  }
}

TEST_F(ReadSurface, ReadsPlyAndObj) {
  const auto tube = sample_tube();
  write_ply(folder / "ascii.ply", tube, true);
  write_ply(folder / "binary.ply", tube, false);
  std::filesystem::rename(folder / "binary.ply", folder / "binary.PLY");
  write_obj(folder / "tube.obj", tube);
  for (const char* name : {"ascii.ply", "binary.PLY", "tube.obj"})
    expect_same(load(name).surface, tube, 1e-4);
}

TEST_F(ReadSurface, ReadsPlyWithOtherElementsAndArrays) {
  // As in Turk's description, with a colour per vertex, a quality per face, trailing edges and both
  // of the old type names.
  const auto tube = sample_tube();
  std::string text = "ply\nformat ascii 1.0\ncomment made for a test\nelement vertex " +
                     std::to_string(tube.points.rows()) +
                     "\nproperty float x\nproperty uchar red\nproperty double y\nproperty float32 "
                     "z\nelement face " +
                     std::to_string(tube.triangles.rows()) +
                     "\nproperty int16 quality\nproperty list uchar int vertex_index\nelement edge "
                     "1\nproperty int "
                     "vertex1\nproperty int vertex2\nend_header\n";
  for (int i = 0; i < tube.points.rows(); ++i)
    text += std::to_string(tube.points(i, 0)) + " " + std::to_string(i % 256) + " " +
            std::to_string(tube.points(i, 1)) + " " + std::to_string(tube.points(i, 2)) + "\n";
  for (int t = 0; t < tube.triangles.rows(); ++t)
    text += std::to_string(-t) + " 3 " + std::to_string(tube.triangles(t, 0)) + " " +
            std::to_string(tube.triangles(t, 1)) + " " + std::to_string(tube.triangles(t, 2)) +
            "\n";
  write("tube.ply", text + "0 1\n");
  const auto loaded = load("tube.ply");
  expect_same(loaded.surface, tube, 1e-6);
  ASSERT_EQ(loaded.point_arrays.size(), 1U);
  EXPECT_EQ(loaded.point_arrays[0].name, "red");
  EXPECT_EQ(loaded.point_arrays[0].type, "UInt8");
  EXPECT_EQ(loaded.point_arrays[0].values(300, 0), 300 - 256);
  ASSERT_EQ(loaded.cell_arrays.size(), 1U);
  EXPECT_EQ(loaded.cell_arrays[0].values(7, 0), -7);
}

TEST_F(ReadSurface, WeldsTheCornersOfStl) {
  const auto tube = sample_tube();
  for (const bool ascii : {true, false}) {
    write_stl(folder / "tube.stl", tube, ascii);
    const auto loaded = load("tube.stl");
    EXPECT_EQ(loaded.surface.points.rows(), tube.points.rows());
    EXPECT_EQ(loaded.surface.triangles.rows(), tube.triangles.rows());
    EXPECT_EQ(loaded.report.merged_points, 3 * tube.triangles.rows() - tube.points.rows());
    EXPECT_NEAR(total_area(loaded.surface) / total_area(tube), 1, 1e-5);
  }
}

TEST_F(ReadSurface, ReadsObjWithNormalsOfItsOwnPerCorner) {
  std::string text;
  const auto tube = sample_tube();
  for (int i = 0; i < tube.points.rows(); ++i)
    text += "v " + std::to_string(tube.points(i, 0)) + " " + std::to_string(tube.points(i, 1)) +
            " " + std::to_string(tube.points(i, 2)) + "\n";
  for (int t = 0; t < tube.triangles.rows(); ++t) text += "vn 0 0 1\n";
  for (int t = 0; t < tube.triangles.rows(); ++t) {
    text += "f";
    for (int k = 0; k < 3; ++k)
      text += " " + std::to_string(tube.triangles(t, k) + 1) + "//" + std::to_string(t + 1);
    text += "\n";
  }
  write("tube.obj", text);
  const auto loaded = load("tube.obj");
  EXPECT_EQ(loaded.surface.points.rows(), tube.points.rows());
  EXPECT_EQ(euler_number(loaded.surface.triangles), 0);
}

TEST_F(ReadSurface, ReadsObjWithRelativeNumbersQuadsAndContinuedLines) {
  std::string text = "# a tube of twelve quads in three rings\no tube\n";
  for (int ring = 0; ring < 3; ++ring)
    for (int i = 0; i < 12; ++i)
      text += "v " + std::to_string(10 * std::cos(M_PI * i / 6)) + " " +
              std::to_string(10 * std::sin(M_PI * i / 6)) + " " + std::to_string(5 * ring) +
              " 0.5 0.5 0.5\n";
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 12; ++i) {
      const int a = 12 * ring + i - 36, b = 12 * ring + (i + 1) % 12 - 36;
      text += "f " + std::to_string(a) + " " + std::to_string(b) + " \\\r\n " +
              std::to_string(b + 12) + " " + std::to_string(a + 12) + "\r\n";
    }
  write("tube.obj", text);
  const auto loaded = load("tube.obj");
  EXPECT_EQ(loaded.surface.triangles.rows(), 48);
  EXPECT_NEAR(total_area(loaded.surface), 12 * 20 * std::sin(M_PI / 12) * 10, 1e-4);
}

TEST_F(ReadSurface, CutsPolygonsAndStripsIntoTriangles) {
  // A tube of eight sides: one ring of quads, one of triangle strips with two triangles each, one
  // of hexagons (an extra point on two sides of each quad).
  std::string points, polys, strips;
  int count = 0;
  auto add = [&](double angle, double z) {
    points += std::to_string(10 * std::cos(angle)) + " " + std::to_string(10 * std::sin(angle)) +
              " " + std::to_string(z) + "\n";
    return count++;
  };
  constexpr int n = 8;
  std::vector<std::vector<int>> ring(4);
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < n; ++i)
      ring[static_cast<size_t>(row)].push_back(add(2 * M_PI * i / n, 10.0 * row));
  std::vector<int> side;
  for (int i = 0; i < n; ++i) side.push_back(add(2 * M_PI * i / n, 25.0));
  std::string connectivity, offsets, strip_connectivity, strip_offsets;
  int end = 0, strip_end = 0;
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    for (const int id : {ring[0][i], ring[0][j], ring[1][j], ring[1][i]})
      connectivity += std::to_string(id) + " ";
    offsets += std::to_string(end += 4) + " ";
    for (const int id : {ring[2][i], ring[2][j], side[j], ring[3][j], ring[3][i], side[i]})
      connectivity += std::to_string(id) + " ";
    offsets += std::to_string(end += 6) + " ";
    for (const int id : {ring[1][i], ring[1][j], ring[2][i], ring[2][j]})
      strip_connectivity += std::to_string(id) + " ";
    strip_offsets += std::to_string(strip_end += 4) + " ";
  }
  auto array = [](const std::string& name, const std::string& type, const std::string& data,
                  int components) {
    return R"(<DataArray type=")" + type + R"(" Name=")" + name + R"(" NumberOfComponents=")" +
           std::to_string(components) + R"(" format="ascii">)" + data + "</DataArray>";
  };
  write("mixed.vtp",
        R"(<VTKFile type="PolyData" version="1.0"><PolyData><Piece NumberOfPoints=")" +
            std::to_string(count) + R"(" NumberOfPolys="16" NumberOfStrips="8"><Points>)" +
            array("Points", "Float64", points, 3) + "</Points><Polys>" +
            array("connectivity", "Int32", connectivity, 1) +
            array("offsets", "Int32", offsets, 1) + "</Polys><Strips>" +
            array("connectivity", "Int32", strip_connectivity, 1) +
            array("offsets", "Int32", strip_offsets, 1) + "</Strips></Piece></PolyData></VTKFile>");
  const auto loaded = load("mixed.vtp");
  EXPECT_EQ(loaded.surface.triangles.rows(), n * (2 + 2 + 4));
  EXPECT_EQ(euler_number(loaded.surface.triangles), 0);
  EXPECT_EQ(boundary_loops(loaded.surface.triangles).size(), 2U);
  EXPECT_NEAR(total_area(loaded.surface), n * 2 * 10 * std::sin(M_PI / n) * 30, 1e-3);
}

TEST_F(ReadSurface, KeepsTheInputsArraysRowByRow) {
  TriangleSurface tube = sample_tube();
  // A loose point first, so that every row index increases by one.
  Points shifted(tube.points.rows() + 1, 3);
  shifted << 99, 99, 99, tube.points;
  tube.points = shifted;
  tube.triangles.array() += 1;
  shifted(1, 0) = std::numeric_limits<double>::quiet_NaN();  // allowed in arrays, not in points
  NamedArray radius{"Radius", shifted, false, ""}, id{"GlobalNodeID", {}, true, ""},
      face{"Regions", {}, true, ""};
  id.values.resize(shifted.rows(), 1);
  for (int i = 0; i < shifted.rows(); ++i) id.values(i, 0) = 1000 + i;
  face.values.resize(tube.triangles.rows(), 1);
  for (int t = 0; t < tube.triangles.rows(); ++t) face.values(t, 0) = -t;
  write_vtp(folder / "tube.vtp", tube, Encoding::zlib, {radius, id}, {face});
  const auto loaded = load("tube.vtp");
  EXPECT_EQ(loaded.report.dropped_points, 1);
  ASSERT_EQ(loaded.point_arrays.size(), 2U);
  EXPECT_EQ(loaded.point_arrays[0].name, "Radius");
  EXPECT_EQ(loaded.point_arrays[0].type, "Float64");
  EXPECT_TRUE(std::isnan(loaded.point_arrays[0].values(0, 0)));
  EXPECT_EQ(Points(loaded.point_arrays[0].values).bottomRows(99),
            loaded.surface.points.bottomRows(99));
  EXPECT_TRUE(loaded.point_arrays[1].integer);
  EXPECT_EQ(loaded.point_arrays[1].type, "Int32");
  EXPECT_EQ(loaded.point_arrays[1].values(0, 0), 1001);
  EXPECT_EQ(loaded.cell_arrays[0].values, face.values);
}

TEST_F(ReadSurface, GeneratesTubesWithTheirThickness) {
  VesselSpec vessel;
  vessel.tube = small_tube();
  vessel.wall.emplace().thickness = 1;
  EXPECT_FALSE(load_surface(vessel, scene).thickness);
  vessel.tube->end_thickness = 2;
  const auto loaded = load_surface(vessel, scene);
  EXPECT_EQ(loaded.surface.points, sample_tube().points);
  EXPECT_NEAR((*loaded.thickness)[24 * 10], 1.5, 1e-14);
}

TEST_F(ReadSurface, RefusesRadiiOutsideTheUnitAndSaysWhichFits) {
  TriangleSurface tube = sample_tube();
  tube.points /= 1000;  // in metres
  write_vtp(folder / "tube.vtp", tube);
  VesselSpec vessel = vessel_of(folder / "tube.vtp");
  const std::string sentence = refusal(vessel);
  EXPECT_NE(sentence.find("radius 0.00"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("if the file is in m)"), std::string::npos) << sentence;
  vessel.check = false;
  EXPECT_EQ(refusal(vessel), "");
  vessel.check = true;
  scene.units.length = "m";
  scene.units.metres = 1;
  EXPECT_EQ(refusal(vessel), "");
}

TEST_F(ReadSurface, RemeshRefusesEdgesThatMakeNoTube) {
  write_vtp(folder / "tube.vtp", sample_tube());
  VesselSpec vessel = vessel_of(folder / "tube.vtp");
  vessel.remesh = 50;
  EXPECT_NE(refusal(vessel).find("remesh: found a target edge of 50"), std::string::npos);
  vessel.remesh = 1e-3;
  EXPECT_NE(refusal(vessel).find("remesh"), std::string::npos);
}

TEST_F(ReadSurface, RealAnatomyComesThrough) {
  for (const auto& [name, ends] :
       {std::pair{"svc.vtp", 2U}, std::pair{"pulmonary_artery.vtp", 3U}}) {
    VesselSpec vessel = vessel_of(testing::real_anatomy() / name);
    const auto coarse = load_surface(vessel, scene);
    EXPECT_GT(coarse.report.collapsed_edges, 0);
    vessel.remesh = 1.5;
    const auto fine = load_surface(vessel, scene);
    const auto before = boundary_loops(coarse.surface.triangles),
               after = boundary_loops(fine.surface.triangles);
    ASSERT_EQ(before.size(), ends);
    ASSERT_EQ(after.size(), ends);
    for (size_t k = 0; k < ends; ++k)
      EXPECT_LT((area_vector(coarse.surface.points, before[k]) -
                 area_vector(fine.surface.points, after[k]))
                    .norm(),
                0.02 * area_vector(coarse.surface.points, before[k]).norm());
    EXPECT_EQ(euler_number(fine.surface.triangles), euler_number(coarse.surface.triangles));
    EXPECT_NEAR(total_area(fine.surface) / total_area(coarse.surface), 1, 0.02);
    EXPECT_TRUE(self_intersections(fine.surface).empty());
  }
}

}  // namespace
}  // namespace vasorod
