#include <array>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include "result/example_result.h"
#include "result/write_vtp.h"
#include "surface_file/surface_file.h"

namespace vasorod {
namespace {

vtkSmartPointer<vtkPolyData> read(const std::string& bytes) {
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(bytes);
  reader->Update();
  return reader->GetOutput();
}

template <class Values>
void expect_same(vtkDataArray* array, const Values& expected) {
  ASSERT_NE(array, nullptr);
  ASSERT_EQ(array->GetNumberOfTuples(), expected.rows());
  ASSERT_EQ(array->GetNumberOfComponents(), expected.cols());
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index k = 0; k < expected.cols(); ++k)
      ASSERT_EQ(array->GetComponent(i, static_cast<int>(k)), expected(i, k)) << array->GetName();
}

TEST(WriteVtp, AVesselReadsBackToTheSameDoubles) {
  const VesselResult vessel = test::deformed_tube(24, 30);
  const auto data = read(vessel_vtp(vessel));
  ASSERT_EQ(data->GetNumberOfPoints(), vessel.rest.rows());
  expect_same(data->GetPoints()->GetData(), vessel.current);
  auto* at_points = data->GetPointData();
  expect_same(at_points->GetArray("RestPosition"), vessel.rest);
  expect_same(at_points->GetArray("Displacement"), Points(vessel.current - vessel.rest));
  expect_same(at_points->GetArray("AxialStretch"), vessel.axial_stretch);
  expect_same(at_points->GetArray("TwistShear"), vessel.twist_shear);
  expect_same(at_points->GetArray("ContactPressure"), vessel.contact_pressure);
  ASSERT_EQ(data->GetNumberOfPolys(), vessel.triangles.rows());
  vtkNew<vtkIdList> corners;
  for (Eigen::Index i = 0; i < vessel.triangles.rows(); ++i) {
    data->GetCellPoints(i, corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(corners->GetId(k), vessel.triangles(i, k));
  }
}

TEST(WriteVtp, TheInputsArraysKeepNameTypeAndValues) {
  VesselResult vessel = test::deformed_tube(12, 6);
  NamedArray large{"Large", {}, true, {}}, colour{"Colour", {}, true, "UInt8"};
  large.values.setConstant(vessel.rest.rows(), 1, 9007199254740991.0);
  colour.values.setConstant(vessel.rest.rows(), 3, 200);
  vessel.point_arrays.push_back(large);
  vessel.point_arrays.push_back(colour);
  const auto data = read(vessel_vtp(vessel));
  auto* face = data->GetCellData()->GetArray("ModelFaceID");
  ASSERT_NE(face, nullptr);
  EXPECT_EQ(face->GetDataType(), VTK_INT);
  EXPECT_EQ(face->GetTuple1(5), 2);
  EXPECT_EQ(data->GetPointData()->GetArray("Thickness")->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(data->GetPointData()->GetArray("Thickness")->GetTuple1(3), 0.5);
  EXPECT_EQ(data->GetPointData()->GetArray("Large")->GetDataTypeSize(), 8);
  EXPECT_EQ(data->GetPointData()->GetArray("Large")->GetTuple1(0), 9007199254740991.0);
  EXPECT_EQ(data->GetPointData()->GetArray("Colour")->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(data->GetPointData()->GetArray("Colour")->GetTuple3(0)[2], 200);
}

TEST(WriteVtp, AnInputArrayWithOurNameStaysBesideOurs) {
  VesselResult vessel = test::deformed_tube(12, 6);
  NamedArray old{"Displacement", {}, false, {}};
  old.values.setConstant(vessel.rest.rows(), 3, 7);
  vessel.point_arrays = {old};
  const auto data = read(vessel_vtp(vessel));
  expect_same(data->GetPointData()->GetArray("Displacement"), Points(vessel.current - vessel.rest));
  ASSERT_NE(data->GetPointData()->GetArray("Displacement_input"), nullptr);
  EXPECT_EQ(data->GetPointData()->GetArray("Displacement_input")->GetTuple3(4)[1], 7);
}

TEST(WriteVtp, WhatWasNotModelledIsWrittenAsAtRest) {
  const VesselResult vessel = test::obstacle(12, 6);
  const auto data = read(vessel_vtp(vessel));
  expect_same(data->GetPointData()->GetArray("AxialStretch"),
              Eigen::VectorXd::Ones(vessel.rest.rows()));
  expect_same(data->GetPointData()->GetArray("TwistShear"),
              Eigen::VectorXd::Zero(vessel.rest.rows()));
  expect_same(data->GetPointData()->GetArray("ContactPressure"),
              Eigen::VectorXd::Zero(vessel.rest.rows()));
}

TEST(WriteVtp, AnArrayOfTheWrongLengthIsABug) {
  VesselResult vessel = test::deformed_tube(12, 6);
  vessel.point_arrays[0].values.conservativeResize(3, 1);
  EXPECT_THROW(vessel_vtp(vessel), std::logic_error);
}

TEST(WriteVtp, TheFileIsBinaryAndCompressed) {
  const std::string bytes = vessel_vtp(test::deformed_tube(24, 30));
  EXPECT_NE(bytes.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
  EXPECT_NE(bytes.find("<AppendedData encoding=\"raw\">"), std::string::npos);
  EXPECT_EQ(bytes, vessel_vtp(test::deformed_tube(24, 30))) << "two writes of one vessel differ";
}

TEST(WriteVtp, NamesWithMarksOfXmlReadBack) {
  VesselResult vessel = test::deformed_tube(12, 6);
  const std::string name = "a & b <c> \"d\" 'e'";
  vessel.point_arrays = {{name, vessel.rest, false, {}}};
  const test::TemporaryFolder folder;
  std::ofstream(folder.path / "svc.vtp", std::ios::binary) << vessel_vtp(vessel);
  const SurfaceFile back = read_vtp(folder.path / "svc.vtp");
  ASSERT_EQ(back.point_arrays.size(), 6U);
  EXPECT_EQ(back.point_arrays.back().name, name);
  EXPECT_EQ(Points(back.point_arrays.back().values), vessel.rest);
  const auto data = read(vessel_vtp(vessel));
  expect_same(data->GetPointData()->GetArray(name.c_str()), vessel.rest);
}

// An independent reader, written from the format's description.
TEST(WriteVtp, ReadsTheSameWithoutVtk) {
  const VesselResult vessel = test::deformed_tube(24, 30);
  const test::TemporaryFolder folder;
  const std::string file = (folder.path / "svc.vtp").string(),
                    listing = (folder.path / "listing").string();
  std::ofstream(file, std::ios::binary) << vessel_vtp(vessel);
  ASSERT_EQ(std::system((VASOROD_PYTHON " " VASOROD_SOURCE_DIR "/tests/result/read_vtp.py " + file +
                         " > " + listing)
                            .c_str()),
            0);
  std::ifstream lines(listing);
  std::map<std::string, std::string> types;
  std::map<std::string, std::array<double, 4>> seen;  // components, tuples, first, last
  for (std::string section, name, type; lines >> section >> name >> type;) {
    types[section + name] = type;
    for (double& value : seen[section + name]) lines >> value;
  }
  const auto n = static_cast<double>(vessel.rest.rows()),
             m = static_cast<double>(vessel.triangles.rows());
  const auto last = vessel.rest.rows() - 1;
  using Row = std::array<double, 4>;
  EXPECT_EQ(seen["PointsPoints"], (Row{3, n, vessel.current(0, 0), vessel.current(last, 2)}));
  EXPECT_EQ(seen["PointDataRestPosition"], (Row{3, n, vessel.rest(0, 0), vessel.rest(last, 2)}));
  EXPECT_EQ(seen["PointDataTwistShear"],
            (Row{1, n, vessel.twist_shear[0], vessel.twist_shear[last]}));
  EXPECT_EQ(seen["PointDataAxialStretch"],
            (Row{1, n, vessel.axial_stretch[0], vessel.axial_stretch[last]}));
  EXPECT_EQ(
      seen["Polysconnectivity"],
      (Row{1, 3 * m, 0, static_cast<double>(vessel.triangles(vessel.triangles.rows() - 1, 2))}));
  EXPECT_EQ(types["PointDataRestPosition"], "Float64");
  EXPECT_EQ(types["PointDataThickness"], "Float32");
  EXPECT_EQ(types["CellDataModelFaceID"], "Int32");
}

TEST(WriteVtp, ACenterlineReadsBack) {
  CenterlineResult line = test::centerline(5, 60, 31, 0.02, 0.01, 1.1);
  line.lines = {{0, 1, 2, 3}, {3, 4, 5}};
  const auto data = read(centerline_vtp(line));
  expect_same(data->GetPoints()->GetData(), line.current);
  auto* at_nodes = data->GetPointData();
  expect_same(at_nodes->GetArray("RestPosition"), line.rest);
  for (int i = 0; i < 31; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_EQ(at_nodes->GetArray("Abscissas")->GetTuple1(i), line.abscissa[k]);
    EXPECT_EQ(at_nodes->GetArray("MaximumInscribedSphereRadius")->GetTuple1(i), 5);
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d < 3; ++d)
        EXPECT_EQ(
            at_nodes->GetArray(("Director" + std::to_string(d + 1)).c_str())->GetComponent(i, c),
            line.directors[k](c, d));
      EXPECT_EQ(at_nodes->GetArray("u")->GetComponent(i, c), line.u[k][c]);
      EXPECT_EQ(at_nodes->GetArray("v")->GetComponent(i, c), line.v[k][c]);
      EXPECT_EQ(at_nodes->GetArray("u0")->GetComponent(i, c), line.u0[k][c]);
      EXPECT_EQ(at_nodes->GetArray("v0")->GetComponent(i, c), line.v0[k][c]);
    }
  }
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  vtkNew<vtkIdList> nodes;
  data->GetCellPoints(1, nodes);
  ASSERT_EQ(nodes->GetNumberOfIds(), 3);
  EXPECT_EQ(nodes->GetId(0), 3);
  EXPECT_EQ(nodes->GetId(2), 5);
  line.radius.clear();
  EXPECT_EQ(read(centerline_vtp(line))->GetPointData()->GetArray("MaximumInscribedSphereRadius"),
            nullptr);
}

// Read with VTK, as ParaView and 3D Slicer do, and without it.
TEST(WriteVtp, EveryFileSaysItsUnitsProgramSceneAndSpace) {
  Result result = test::example_result();
  result.environment.scene_hash = std::string(64, 'a');
  VesselResult& vessel = result.vessels[0];
  vessel.space = "LPS";
  const FileStamp stamp = stamp_of(result, vessel);
  const test::TemporaryFolder folder;
  for (const std::string& bytes :
       {vessel_vtp(vessel, stamp), centerline_vtp(*vessel.centerline, stamp),
        surface_vtp(*vessel.stump, stamp)}) {
    const auto data = read(bytes);
    for (const auto& [name, expected] : {std::pair{"Units", "length mm, stress MPa"},
                                         {"Program", "vasorod 0.1.0"},
                                         {"SceneHash", result.environment.scene_hash.c_str()},
                                         {"SPACE", "LPS"}}) {
      auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
      ASSERT_NE(array, nullptr) << name;
      ASSERT_EQ(array->GetNumberOfValues(), 1) << name;
      EXPECT_EQ(array->GetValue(0), expected);
    }
    std::ofstream(folder.path / "file.vtp", std::ios::binary) << bytes;
    EXPECT_EQ(read_vtp(folder.path / "file.vtp").space, "LPS");
  }
  vessel.space.clear();
  const auto without = read(vessel_vtp(vessel, stamp_of(result, vessel)));
  EXPECT_EQ(without->GetFieldData()->GetAbstractArray("SPACE"), nullptr);
}

TEST(WriteVtp, TheListNamesEveryFile) {
  const std::string text = scene_pvd(test::example_result());
  for (const char* file : {"svc.vtp", "svc_centerline.vtp", "svc_stump.vtp", "aorta.vtp"})
    EXPECT_NE(text.find("file=\"" + std::string(file) + "\""), std::string::npos) << file;
  EXPECT_EQ(text.find("aorta_centerline"), std::string::npos);
}

}  // namespace
}  // namespace vasorod
