#include <mutex>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <vasorod/error.h>

#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

// VTK says what is wrong with a file by printing it; this keeps the first line of it for our own
// sentence.
class Listener : public vtkOutputWindow {
 public:
  static Listener* New();
  void DisplayText(const char* text) override { hear(text); }
  void DisplayErrorText(const char* text) override { hear(text); }
  void DisplayWarningText(const char* text) override { hear(text); }
  void DisplayGenericWarningText(const char* text) override { hear(text); }
  void DisplayDebugText(const char*) override {}
  std::string heard;

 private:
  void hear(const char* text) {
    if (!heard.empty() || text == nullptr) return;
    std::string line = text;
    // VTK cannot read back what it wrote about the norms of arrays that hold NaN; the arrays
    // themselves are fine.
    if (line.find("element for vtkDataArray::") != std::string::npos) return;
    // "ERROR: In FILE, line N\nvtkReader (0x...): what is wrong\n\n": the words after the address
    // matter.
    if (const auto colon = line.find("): "); colon != std::string::npos)
      line = line.substr(colon + 3);
    for (char& c : line)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
    heard = line.empty() ? "no reason given" : line.substr(0, 160);
  }
};
vtkStandardNewMacro(Listener)

    // VTK has one output window and one log, which repeats it, for the whole process, so files are
    // read one at a time.
    class Listening {
 public:
  Listening() : lock_(mutex()), before_(vtkOutputWindow::GetInstance()) {
    vtkOutputWindow::SetInstance(ears_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~Listening() {
    vtkLogger::SetStderrVerbosity(verbosity_);
    vtkOutputWindow::SetInstance(before_);
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  const std::string& heard() const { return ears_->heard; }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  std::lock_guard<std::mutex> lock_;
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
  vtkSmartPointer<Listener> ears_ = vtkSmartPointer<Listener>::New();
};

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(vtkSmartPointer<Reader> reader, const std::string& file) {
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> read_data(const std::filesystem::path& file, SurfaceFormat format) {
  const std::string name = file.string();
  const Listening listening;
  vtkSmartPointer<vtkPolyData> data;
  try {
    if (format == SurfaceFormat::vtp)
      data = read_with(vtkSmartPointer<vtkXMLPolyDataReader>::New(), name);
    if (format == SurfaceFormat::stl) {
      const auto reader = vtkSmartPointer<vtkSTLReader>::New();
      reader->MergingOff();  // welded by read_polydata, where it is counted
      data = read_with(reader, name);
    }
  } catch (const std::exception& error) {
    throw InputError(name + ": found a damaged file (" + error.what() + "), expected a surface");
  }
  if (!listening.heard().empty() || data == nullptr)
    throw InputError(name + ": found a damaged or truncated file (" + listening.heard() +
                     "), expected a surface");
  return data;
}

// Cells are walked by their own offsets, checked first: VTK hands out whatever a damaged file says.
std::vector<std::vector<int>> read_cells(const std::filesystem::path& file, vtkCellArray& cells) {
  vtkDataArray& offsets = *cells.GetOffsetsArray();
  vtkDataArray& connectivity = *cells.GetConnectivityArray();
  const auto size = static_cast<double>(connectivity.GetNumberOfTuples());
  std::vector<std::vector<int>> all;
  for (vtkIdType cell = 0; cell + 1 < offsets.GetNumberOfTuples(); ++cell) {
    const double begin = offsets.GetComponent(cell, 0), end = offsets.GetComponent(cell + 1, 0);
    if (!(begin >= 0 && begin <= end && end <= size))
      throw InputError(file.string() + ": found offsets that do not fit in cell " +
                       std::to_string(cell) + ", expected a sound file");
    std::vector<int> corners;
    for (auto k = static_cast<vtkIdType>(begin); k < static_cast<vtkIdType>(end); ++k) {
      const double id = connectivity.GetComponent(k, 0);
      corners.push_back(id >= 0 && id < static_cast<double>(VTK_INT_MAX) ? static_cast<int>(id)
                                                                         : -1);
    }
    all.push_back(std::move(corners));
  }
  return all;
}

// A type as VTK's XML names it: Float32, UInt8, ...
std::string type_of(vtkDataArray& array) {
  const std::string bits = std::to_string(8 * array.GetDataTypeSize());
  if (array.GetDataType() == VTK_FLOAT || array.GetDataType() == VTK_DOUBLE) return "Float" + bits;
  return (array.GetDataTypeMin() < 0 ? "Int" : "UInt") + bits;
}

std::vector<NamedArray> read_arrays(vtkFieldData& data, Eigen::Index rows) {
  std::vector<NamedArray> arrays;
  for (int k = 0; k < data.GetNumberOfArrays(); ++k) {
    vtkDataArray* array = data.GetArray(k);  // nothing for strings
    if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfTuples() != rows)
      continue;
    NamedArray out;
    out.name = array->GetName();
    out.type = type_of(*array);
    out.integer = out.type.front() != 'F';
    out.values.resize(rows, array->GetNumberOfComponents());
    for (Eigen::Index i = 0; i < rows; ++i)
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        out.values(i, c) = array->GetComponent(i, c);
    arrays.push_back(std::move(out));
  }
  return arrays;
}

}  // namespace

SurfaceFile read_vtk(const std::filesystem::path& file, SurfaceFormat format) {
  const auto data = read_data(file, format);
  SurfaceFile out;
  out.points.resize(data->GetNumberOfPoints(), 3);
  for (Eigen::Index i = 0; i < out.points.rows(); ++i) data->GetPoint(i, out.points.row(i).data());
  out.skipped_cells = static_cast<int>(data->GetNumberOfVerts() + data->GetNumberOfLines());
  out.polygons = read_cells(file, *data->GetPolys());
  out.strips = read_cells(file, *data->GetStrips());
  out.point_arrays = read_arrays(*data->GetPointData(), out.points.rows());
  out.cell_arrays = read_arrays(*data->GetCellData(), data->GetNumberOfCells());
  return out;
}

}  // namespace vasorod
