#include "result/read_vtp.h"

#include <array>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <vasorod/error.h>

namespace vasorod {

namespace {

// VTK logs what is wrong with a file; the error has a sentence of our own.
class Silence {
 public:
  Silence() { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); }
  ~Silence() { vtkLogger::SetStderrVerbosity(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  vtkLogger::Verbosity before_ = vtkLogger::GetCurrentVerbosityCutoff();
};

vtkSmartPointer<vtkPolyData> read(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string() + ": there is no such file, expected one of a result folder");
  const Silence silence;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || !reader->GetOutput() ||
      reader->GetOutput()->GetNumberOfPoints() == 0)
    throw InputError(file.string() + ": cannot be read as VTP, expected a file of a result folder");
  return reader->GetOutput();
}

Points rows_of(vtkDataArray* array) {
  Points points(array->GetNumberOfTuples(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (int k = 0; k < 3; ++k) points(i, k) = array->GetComponent(i, k);
  return points;
}

Points rest_of(const std::filesystem::path& file, vtkPolyData* data) {
  vtkDataArray* rest = data->GetPointData()->GetArray("RestPosition");
  if (!rest || rest->GetNumberOfComponents() != 3)
    throw InputError(
        file.string() +
        ": has no array RestPosition of three components, expected a file of a result folder");
  return rows_of(rest);
}

}  // namespace

ReadVessel read_vessel_vtp(const std::filesystem::path& file) {
  const auto data = read(file);
  ReadVessel vessel{rest_of(file, data), rows_of(data->GetPoints()->GetData()), {}};
  std::vector<std::array<int, 3>> triangles;
  vtkNew<vtkIdList> corners;
  vtkCellArray* polygons = data->GetPolys();
  polygons->InitTraversal();
  while (polygons->GetNextCell(corners))
    for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k)
      triangles.push_back({static_cast<int>(corners->GetId(0)),
                           static_cast<int>(corners->GetId(k - 1)),
                           static_cast<int>(corners->GetId(k))});
  if (triangles.empty())
    throw InputError(file.string() + ": has no polygons, expected a vessel's surface");
  vessel.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (Eigen::Index t = 0; t < vessel.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      vessel.triangles(t, k) = triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
  return vessel;
}

ReadCenterline read_centerline_vtp(const std::filesystem::path& file) {
  const auto data = read(file);
  ReadCenterline line{rest_of(file, data), rows_of(data->GetPoints()->GetData()), {}, {}};
  if (vtkDataArray* radius = data->GetPointData()->GetArray("MaximumInscribedSphereRadius"))
    for (vtkIdType i = 0; i < radius->GetNumberOfTuples(); ++i)
      line.radius.push_back(radius->GetTuple1(i));
  vtkNew<vtkIdList> nodes;
  vtkCellArray* lines = data->GetLines();
  lines->InitTraversal();
  while (lines->GetNextCell(nodes)) {
    std::vector<int>& run = line.lines.emplace_back();
    for (vtkIdType k = 0; k < nodes->GetNumberOfIds(); ++k)
      run.push_back(static_cast<int>(nodes->GetId(k)));
  }
  return line;
}

}  // namespace vasorod
