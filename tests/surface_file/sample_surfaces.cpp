#include "surface_file/sample_surfaces.h"

#include <array>
#include <fstream>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataWriter.h>

#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {

namespace {

template <class Array>
vtkSmartPointer<vtkDataArray> to_vtk(const NamedArray& array) {
  const auto out = vtkSmartPointer<Array>::New();
  out->SetName(array.name.c_str());
  out->SetNumberOfComponents(static_cast<int>(array.values.cols()));
  out->SetNumberOfTuples(array.values.rows());
  for (Eigen::Index i = 0; i < array.values.rows(); ++i)
    for (int c = 0; c < array.values.cols(); ++c) out->SetComponent(i, c, array.values(i, c));
  return out;
}

vtkSmartPointer<vtkDataArray> to_vtk(const NamedArray& array) {
  return array.integer ? to_vtk<vtkIntArray>(array) : to_vtk<vtkDoubleArray>(array);
}

vtkSmartPointer<vtkPolyData> to_vtk(const TriangleSurface& surface) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (int i = 0; i < surface.points.rows(); ++i)
    points->InsertNextPoint(surface.points.row(i).data());
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int t = 0; t < surface.triangles.rows(); ++t)
    cells->InsertNextCell(
        {surface.triangles(t, 0), surface.triangles(t, 1), surface.triangles(t, 2)});
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

}  // namespace

TubeSpec small_tube() {
  return testing::straight_tube(40, 10, 24, 20);
}

TriangleSurface sample_tube() {
  return tube_surface(small_tube());
}

TriangleSurface closed_tube(const std::vector<int>& ends, double height) {
  TriangleSurface surface = sample_tube();
  const auto loops = boundary_loops(surface.triangles);
  for (const int end : ends) {
    const auto& loop = loops[static_cast<size_t>(end)];
    const int center = static_cast<int>(surface.points.rows());
    surface.points.conservativeResize(center + 1, 3);
    surface.points.row(center) << 0, 0, (end == 0 ? -height : 40 + height);
    const Eigen::Index first = surface.triangles.rows();
    surface.triangles.conservativeResize(first + static_cast<Eigen::Index>(loop.size()), 3);
    for (size_t k = 0; k < loop.size(); ++k)
      surface.triangles.row(first + static_cast<Eigen::Index>(k)) << loop[(k + 1) % loop.size()],
          loop[k], center;
  }
  return surface;
}

TriangleSurface joined(const TriangleSurface& a, const TriangleSurface& b) {
  TriangleSurface both = a;
  append(both, b);
  return both;
}

void set_encoding(vtkXMLWriter& writer, Encoding encoding) {
  switch (encoding) {
    case Encoding::ascii:
      writer.SetDataModeToAscii();
      break;
    case Encoding::inline_binary:
      writer.SetDataModeToBinary();
      break;
    case Encoding::appended_raw:
      writer.SetDataModeToAppended();
      writer.EncodeAppendedDataOff();
      break;
    case Encoding::appended_base64:
      writer.SetDataModeToAppended();
      writer.EncodeAppendedDataOn();
      break;
    case Encoding::zlib:
      writer.SetDataModeToBinary();
      writer.SetCompressorTypeToZLib();
      break;
  }
}

void write_vtp(const std::filesystem::path& file, const TriangleSurface& surface, Encoding encoding,
               const std::vector<NamedArray>& point_arrays,
               const std::vector<NamedArray>& cell_arrays) {
  const auto data = to_vtk(surface);
  for (const NamedArray& array : point_arrays) data->GetPointData()->AddArray(to_vtk(array));
  for (const NamedArray& array : cell_arrays) data->GetCellData()->AddArray(to_vtk(array));
  const auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  writer->SetCompressorTypeToNone();
  set_encoding(*writer, encoding);
  writer->Write();
}

void write_stl(const std::filesystem::path& file, const TriangleSurface& surface, bool ascii) {
  const auto writer = vtkSmartPointer<vtkSTLWriter>::New();
  writer->SetFileName(file.c_str());
  writer->SetInputData(to_vtk(surface));
  ascii ? writer->SetFileTypeToASCII() : writer->SetFileTypeToBinary();
  writer->Write();
}

void write_ply(const std::filesystem::path& file, const TriangleSurface& surface, bool ascii) {
  const auto writer = vtkSmartPointer<vtkPLYWriter>::New();
  writer->SetFileName(file.c_str());
  writer->SetInputData(to_vtk(surface));
  ascii ? writer->SetFileTypeToASCII() : writer->SetFileTypeToBinary();
  writer->Write();
}

void write_obj(const std::filesystem::path& file, const TriangleSurface& surface) {
  std::ofstream out(file);
  out.precision(17);
  for (int i = 0; i < surface.points.rows(); ++i) out << "v " << surface.points.row(i) << "\n";
  for (int t = 0; t < surface.triangles.rows(); ++t)
    out << "f " << (surface.triangles.row(t).array() + 1).matrix() << "\n";
}

VesselSpec vessel_of(const std::filesystem::path& file) {
  VesselSpec vessel;
  vessel.name = "vessel";
  vessel.surface = file;
  return vessel;
}

}  // namespace vasorod
