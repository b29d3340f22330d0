#include "result/write_vtp.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

#include "data/part_names.h"

namespace vasorod {

namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

vtkSmartPointer<vtkDoubleArray> doubles(const std::string& name,
                                        const Eigen::Ref<const Rows>& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.cols()));
  array->SetNumberOfTuples(values.rows());
  Eigen::Map<Rows>(array->GetPointer(0), values.rows(), values.cols()) = values;
  return array;
}

Rows rows_of(const std::vector<Vec3>& values) {
  Rows rows(static_cast<Eigen::Index>(values.size()), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = values[static_cast<std::size_t>(i)].transpose();
  return rows;
}

Rows column_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// A field that was not modelled is written as its value at rest.
Rows field(const Eigen::VectorXd& values, Eigen::Index rows, double at_rest) {
  if (values.size() == 0) return Rows::Constant(rows, 1, at_rest);
  return values;
}

const std::map<std::string, int>& vtk_types() {
  static const std::map<std::string, int> types{
      {"Int8", VTK_TYPE_INT8},      {"UInt8", VTK_TYPE_UINT8},   {"Int16", VTK_TYPE_INT16},
      {"UInt16", VTK_TYPE_UINT16},  {"Int32", VTK_TYPE_INT32},   {"UInt32", VTK_TYPE_UINT32},
      {"Int64", VTK_TYPE_INT64},    {"UInt64", VTK_TYPE_UINT64}, {"Float32", VTK_TYPE_FLOAT32},
      {"Float64", VTK_TYPE_FLOAT64}};
  return types;
}

// A name escaped for an XML attribute; VTK does not escape names.
std::string escaped(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return out;
}

vtkSmartPointer<vtkDataArray> own_array(const NamedArray& own, Eigen::Index rows,
                                        const std::set<std::string>& taken) {
  if (own.values.rows() != rows)
    throw std::logic_error("array " + own.name + " has " + std::to_string(own.values.rows()) +
                           " rows for " + std::to_string(rows) + " points or cells");
  auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(vtk_types().at(written_type(own))));
  array->SetName(escaped(taken.contains(own.name) ? own.name + "_input" : own.name).c_str());
  array->SetNumberOfComponents(static_cast<int>(own.values.cols()));
  array->SetNumberOfTuples(rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index k = 0; k < own.values.cols(); ++k)
      array->SetComponent(i, static_cast<int>(k), own.values(i, k));
  return array;
}

vtkSmartPointer<vtkPolyData> poly_data(const Points& points) {
  vtkNew<vtkPoints> at;
  at->SetData(doubles("Points", points));
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(at);
  return data;
}

vtkSmartPointer<vtkPolyData> poly_data(const Points& points, const Triangles& triangles) {
  auto data = poly_data(points);
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfTuples(triangles.rows() + 1);
  connectivity->SetNumberOfTuples(triangles.size());
  for (Eigen::Index i = 0; i <= triangles.rows(); ++i) offsets->SetValue(i, 3 * i);
  std::copy(triangles.data(), triangles.data() + triangles.size(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  data->SetPolys(cells);
  return data;
}

std::string bytes(vtkPolyData* data, const FileStamp& stamp) {
  const std::pair<const char*, const std::string&> texts[] = {{"Units", stamp.units},
                                                              {"Program", stamp.program},
                                                              {"SceneHash", stamp.scene_hash},
                                                              {"SPACE", stamp.space}};
  for (const auto& [name, text] : texts) {
    if (text.empty()) continue;
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    data->GetFieldData()->AddArray(array);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(
      1);  // doubles hardly compress: level 5 took 1.4 times as long for 1 % less
  if (!writer->Write()) throw std::runtime_error("VTK could not write a surface");
  return writer->GetOutputString();
}

}  // namespace

std::string written_type(const NamedArray& array) {
  if (vtk_types().contains(array.type)) return array.type;
  if (!array.integer) return "Float64";
  // SimVascular expects ModelFaceID as a 32-bit array, so the narrow type is used if it can hold
  // the values.
  const bool narrow = array.values.size() == 0 ||
                      array.values.cwiseAbs().maxCoeff() <= std::numeric_limits<int>::max();
  return narrow ? "Int32" : "Int64";
}

FileStamp stamp_of(const Result& result, const VesselResult& vessel) {
  return {"length " + result.length_unit + ", stress " + result.stress_unit, result.program,
          result.environment.scene_hash, vessel.space};
}

std::string vessel_vtp(const VesselResult& vessel, const FileStamp& stamp) {
  const Eigen::Index n = vessel.rest.rows();
  if (vessel.current.rows() != n)
    throw std::logic_error("vessel " + vessel.name + " has " + std::to_string(n) +
                           " points at rest and " + std::to_string(vessel.current.rows()) +
                           " in the result");
  auto data = poly_data(vessel.current, vessel.triangles);
  auto* at_points = data->GetPointData();
  at_points->AddArray(doubles("RestPosition", vessel.rest));
  at_points->AddArray(doubles("Displacement", vessel.current - vessel.rest));
  at_points->AddArray(doubles("AxialStretch", field(vessel.axial_stretch, n, 1)));
  at_points->AddArray(doubles("TwistShear", field(vessel.twist_shear, n, 0)));
  at_points->AddArray(doubles("ContactPressure", field(vessel.contact_pressure, n, 0)));
  const std::set<std::string> taken{"RestPosition", "Displacement", "AxialStretch", "TwistShear",
                                    "ContactPressure"};
  for (const NamedArray& own : vessel.point_arrays) at_points->AddArray(own_array(own, n, taken));
  for (const NamedArray& own : vessel.cell_arrays)
    data->GetCellData()->AddArray(own_array(own, vessel.triangles.rows(), {}));
  return bytes(data, stamp);
}

std::string centerline_vtp(const CenterlineResult& centerline, const FileStamp& stamp) {
  auto data = poly_data(centerline.current);
  vtkNew<vtkCellArray> lines;
  for (const std::vector<int>& line : centerline.lines) {
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (const int node : line) lines->InsertCellPoint(node);
  }
  data->SetLines(lines);
  auto* at_nodes = data->GetPointData();
  at_nodes->AddArray(doubles("Abscissas", column_of(centerline.abscissa)));
  if (!centerline.radius.empty())
    at_nodes->AddArray(doubles("MaximumInscribedSphereRadius", column_of(centerline.radius)));
  for (int k = 0; k < 3; ++k) {
    Rows director(static_cast<Eigen::Index>(centerline.directors.size()), 3);
    for (Eigen::Index i = 0; i < director.rows(); ++i)
      director.row(i) = centerline.directors[static_cast<std::size_t>(i)].col(k).transpose();
    at_nodes->AddArray(doubles("Director" + std::to_string(k + 1), director));
  }
  at_nodes->AddArray(doubles("RestPosition", centerline.rest));
  at_nodes->AddArray(doubles("u", rows_of(centerline.u)));
  at_nodes->AddArray(doubles("v", rows_of(centerline.v)));
  at_nodes->AddArray(doubles("u0", rows_of(centerline.u0)));
  at_nodes->AddArray(doubles("v0", rows_of(centerline.v0)));
  if (!centerline.force.empty()) {
    at_nodes->AddArray(doubles("SectionForce", rows_of(centerline.force)));
    at_nodes->AddArray(doubles("SectionMoment", rows_of(centerline.moment)));
  }
  if (!centerline.lumen_area.empty()) {
    at_nodes->AddArray(doubles("LumenArea", column_of(centerline.lumen_area)));
    at_nodes->AddArray(doubles("Flattening", column_of(centerline.flattening)));
  }
  for (int k = 0; k < at_nodes->GetNumberOfArrays(); ++k)
    if (at_nodes->GetArray(k)->GetNumberOfTuples() != centerline.current.rows())
      throw std::logic_error(std::string("centerline: ") + at_nodes->GetArrayName(k) + " has " +
                             std::to_string(at_nodes->GetArray(k)->GetNumberOfTuples()) +
                             " rows for " + std::to_string(centerline.current.rows()) + " nodes");
  return bytes(data, stamp);
}

std::string surface_vtp(const TriangleSurface& surface, const FileStamp& stamp) {
  return bytes(poly_data(surface.points, surface.triangles), stamp);
}

std::string scene_pvd(const Result& result) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n  "
      "<Collection>\n";
  int part = 0;
  const auto add = [&](const std::string& name) {
    text += R"(    <DataSet timestep="0" group="" part=")" + std::to_string(part++) +
            R"(" name=")" + name + R"(" file=")" + name + ".vtp\"/>\n";
  };
  for (const VesselResult& vessel : result.vessels) {
    if (vessel.rest.rows() > 0) add(vessel.name);
    if (vessel.centerline) add(centerline_name(vessel.name));
    if (vessel.stump) add(stump_name(vessel.name));
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace vasorod
