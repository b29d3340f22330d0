#include "scene/read_polydata.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkOBJReader.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <new>
#include <numeric>

#include "geometry/error.h"

namespace vasorod {

namespace {

// VTK says what is wrong with a file by printing it; this keeps the first line of it for our own sentence.
class Listener : public vtkOutputWindow {
 public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow) void DisplayText(const char* text) override { hear(text); }
  void DisplayErrorText(const char* text) override { hear(text); }
  void DisplayWarningText(const char* text) override { hear(text); }
  void DisplayGenericWarningText(const char* text) override { hear(text); }
  void DisplayDebugText(const char*) override {}
  std::string heard;

 private:
  void hear(const char* text) {
    if (!heard.empty() || text == nullptr) return;
    std::string line = text;
    // "ERROR: In FILE, line N\nvtkReader (0x...): what is wrong\n\n": the words after the address matter.
    if (const auto colon = line.find("): "); colon != std::string::npos) line = line.substr(colon + 3);
    for (char& c : line)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
    heard = line.empty() ? "no reason given" : line.substr(0, 160);
  }
};
vtkStandardNewMacro(Listener)

    // VTK has one output window for the whole process, so files are read one at a time.
    class Listening {
 public:
  Listening() : lock_(mutex()), before_(vtkOutputWindow::GetInstance()) {
    vtkOutputWindow::SetInstance(ears_);
  }
  ~Listening() { vtkOutputWindow::SetInstance(before_); }
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
  vtkSmartPointer<Listener> ears_ = vtkSmartPointer<Listener>::New();
};

template <class Reader>
vtkSmartPointer<vtkPolyData> read_with(vtkSmartPointer<Reader> reader, const std::string& file) {
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

enum class Format { vtp, stl, ply, obj };

Format format_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".vtp") return Format::vtp;
  if (ending == ".stl") return Format::stl;
  if (ending == ".ply") return Format::ply;
  if (ending == ".obj") return Format::obj;
  throw InputError(file.string() + ": found the ending \"" + ending +
                   "\", expected .vtp, .stl, .ply or .obj");
}

vtkSmartPointer<vtkPolyData> read_file(const std::filesystem::path& file, Format format) {
  const std::string name = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(name + ": found no such file, expected a surface");
  if (!std::filesystem::is_regular_file(file, ignored))
    throw InputError(name + ": found a folder or device, expected a surface file");
  if (std::filesystem::file_size(file, ignored) == 0)
    throw InputError(name + ": found an empty file, expected a surface");
  const Listening listening;
  vtkSmartPointer<vtkPolyData> data;
  try {
    if (format == Format::vtp) data = read_with(vtkSmartPointer<vtkXMLPolyDataReader>::New(), name);
    if (format == Format::ply) data = read_with(vtkSmartPointer<vtkPLYReader>::New(), name);
    if (format == Format::obj) data = read_with(vtkSmartPointer<vtkOBJReader>::New(), name);
    if (format == Format::stl) {
      const auto reader = vtkSmartPointer<vtkSTLReader>::New();
      reader->MergingOff();  // welded below, where it is counted
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

Points read_points(const std::filesystem::path& file, vtkPolyData& data) {
  Points points(data.GetNumberOfPoints(), 3);
  for (int i = 0; i < points.rows(); ++i) {
    data.GetPoint(i, points.row(i).data());
    if (!points.row(i).allFinite())
      throw InputError(file.string() + ": found a coordinate of point " + std::to_string(i) +
                       " that is not a number, expected finite coordinates");
  }
  return points;
}

struct Faces {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> cell;  // the file's cell each came from, for its arrays
};

// A polygon becomes triangles: a quad along its shorter diagonal, more corners by ear clipping.
void add_polygon(const std::vector<int>& corners, const Points& points, int cell, Faces& faces) {
  auto add = [&](int a, int b, int c) {
    faces.triangles.push_back({a, b, c});
    faces.cell.push_back(cell);
  };
  const auto n = corners.size();
  auto length = [&](size_t a, size_t b) {
    return (points.row(corners[a]) - points.row(corners[b])).squaredNorm();
  };
  if (n == 3) {
    add(corners[0], corners[1], corners[2]);
  } else if (n == 4 && length(0, 2) <= length(1, 3)) {
    add(corners[0], corners[1], corners[2]);
    add(corners[0], corners[2], corners[3]);
  } else if (n == 4) {
    add(corners[0], corners[1], corners[3]);
    add(corners[1], corners[2], corners[3]);
  } else {
    const auto polygon = vtkSmartPointer<vtkPolygon>::New();
    const auto ears = vtkSmartPointer<vtkIdList>::New();
    polygon->GetPoints()->SetNumberOfPoints(static_cast<vtkIdType>(n));
    polygon->GetPointIds()->SetNumberOfIds(static_cast<vtkIdType>(n));
    for (size_t k = 0; k < n; ++k) {
      polygon->GetPoints()->SetPoint(static_cast<vtkIdType>(k), points.row(corners[k]).data());
      polygon->GetPointIds()->SetId(static_cast<vtkIdType>(k), static_cast<vtkIdType>(k));
    }
    polygon->Triangulate(ears);
    for (vtkIdType k = 0; k + 2 < ears->GetNumberOfIds(); k += 3)
      add(corners[static_cast<size_t>(ears->GetId(k))], corners[static_cast<size_t>(ears->GetId(k + 1))],
          corners[static_cast<size_t>(ears->GetId(k + 2))]);
  }
}

// Cells are walked by their own offsets, checked first: VTK hands out whatever a damaged file says.
void add_cells(const std::filesystem::path& file, vtkCellArray& cells, int first_cell, bool strips,
               const Points& points, Faces& faces) {
  vtkDataArray& offsets = *cells.GetOffsetsArray();
  vtkDataArray& connectivity = *cells.GetConnectivityArray();
  auto damaged = [&](int cell, const std::string& what) {
    throw InputError(file.string() + ": found " + what + " in cell " + std::to_string(first_cell + cell) +
                     ", expected points from 0 to " + std::to_string(points.rows() - 1));
  };
  std::vector<int> corners;
  for (int cell = 0; cell + 1 < offsets.GetNumberOfTuples(); ++cell) {
    const double begin = offsets.GetComponent(cell, 0), end = offsets.GetComponent(cell + 1, 0);
    if (!(begin >= 0 && begin <= end && end <= static_cast<double>(connectivity.GetNumberOfTuples())))
      damaged(cell, "offsets that do not fit");
    corners.clear();
    for (auto k = static_cast<vtkIdType>(begin); k < static_cast<vtkIdType>(end); ++k) {
      const double id = connectivity.GetComponent(k, 0);
      if (!(id >= 0 && id < static_cast<double>(points.rows()))) damaged(cell, "a point that does not exist");
      corners.push_back(static_cast<int>(id));
    }
    if (corners.size() < 3) damaged(cell, "fewer than three points");
    if (!strips) {
      add_polygon(corners, points, first_cell + cell, faces);
      continue;
    }
    for (size_t k = 0; k + 2 < corners.size(); ++k) {  // every second triangle of a strip runs backwards
      faces.triangles.push_back({corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]});
      faces.cell.push_back(first_cell + cell);
    }
  }
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
    if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfTuples() != rows) continue;
    NamedArray out;
    out.name = array->GetName();
    out.type = type_of(*array);
    out.integer = out.type.front() != 'F';
    out.values.resize(rows, array->GetNumberOfComponents());
    for (Eigen::Index i = 0; i < rows; ++i)
      for (int c = 0; c < array->GetNumberOfComponents(); ++c) out.values(i, c) = array->GetComponent(i, c);
    arrays.push_back(std::move(out));
  }
  return arrays;
}

// Exact duplicates become their first occurrence; the others are left without triangles.
int weld(LoadedSurface& loaded) {
  const Points& points = loaded.surface.points;
  std::map<std::array<double, 3>, int> first;
  std::vector<int> to(static_cast<size_t>(points.rows()));
  int merged = 0;
  for (int i = 0; i < points.rows(); ++i) {
    const auto [at, is_new] = first.emplace(std::array{points(i, 0), points(i, 1), points(i, 2)}, i);
    to[static_cast<size_t>(i)] = at->second;
    merged += is_new ? 0 : 1;
  }
  for (int t = 0; t < loaded.surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      int& corner = loaded.surface.triangles(t, k);
      corner = to[static_cast<size_t>(corner)];
    }
  return merged;
}

int remove_repeated_corners(LoadedSurface& loaded) {
  const Triangles& t = loaded.surface.triangles;
  std::vector<int> keep;
  for (int i = 0; i < t.rows(); ++i)
    if (t(i, 0) != t(i, 1) && t(i, 1) != t(i, 2) && t(i, 2) != t(i, 0)) keep.push_back(i);
  const int removed = static_cast<int>(t.rows()) - static_cast<int>(keep.size());
  if (removed > 0) keep_triangles(loaded, keep);
  return removed;
}

}  // namespace

void keep_rows(std::vector<NamedArray>& arrays, const std::vector<int>& rows) {
  for (NamedArray& array : arrays) array.values = array.values(rows, Eigen::all).eval();
}

void keep_triangles(LoadedSurface& loaded, const std::vector<int>& rows) {
  loaded.surface.triangles = loaded.surface.triangles(rows, Eigen::all).eval();
  keep_rows(loaded.cell_arrays, rows);
}

int drop_unused_points(LoadedSurface& loaded) {
  TriangleSurface& surface = loaded.surface;
  std::vector<int> to(static_cast<size_t>(surface.points.rows()), -1);
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) to[static_cast<size_t>(surface.triangles(t, k))] = 0;
  std::vector<int> keep;
  for (size_t i = 0; i < to.size(); ++i) {
    if (to[i] < 0) continue;
    to[i] = static_cast<int>(keep.size());
    keep.push_back(static_cast<int>(i));
  }
  const int dropped = static_cast<int>(to.size() - keep.size());
  if (dropped == 0) return 0;
  surface.points = surface.points(keep, Eigen::all).eval();
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) surface.triangles(t, k) = to[static_cast<size_t>(surface.triangles(t, k))];
  keep_rows(loaded.point_arrays, keep);
  return dropped;
}

LoadedSurface read_polydata(const std::filesystem::path& file) {
  const Format format = format_of(file);
  const auto data = read_file(file, format);
  LoadedSurface loaded;
  loaded.surface.points = read_points(file, *data);
  Faces faces;
  const int others = static_cast<int>(data->GetNumberOfVerts() + data->GetNumberOfLines());
  add_cells(file, *data->GetPolys(), others, false, loaded.surface.points, faces);
  add_cells(file, *data->GetStrips(), others + static_cast<int>(data->GetNumberOfPolys()), true,
            loaded.surface.points, faces);
  if (faces.triangles.empty())
    throw InputError(file.string() + ": found no triangles, expected a surface of triangles or polygons");
  loaded.surface.triangles.resize(static_cast<Eigen::Index>(faces.triangles.size()), 3);
  for (size_t t = 0; t < faces.triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k)
      loaded.surface.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
          faces.triangles[t][k];
  loaded.point_arrays = read_arrays(*data->GetPointData(), loaded.surface.points.rows());
  loaded.cell_arrays = read_arrays(*data->GetCellData(), data->GetNumberOfCells());
  keep_rows(loaded.cell_arrays, faces.cell);
  loaded.report.skipped_cells = others;
  if (format == Format::stl || format == Format::obj) loaded.report.merged_points = weld(loaded);
  loaded.report.removed_triangles = remove_repeated_corners(loaded);
  if (loaded.surface.triangles.rows() == 0)
    throw InputError(file.string() + ": found only triangles that use a point twice, expected a surface");
  loaded.report.dropped_points = drop_unused_points(loaded) - loaded.report.merged_points;
  return loaded;
}

}  // namespace vasorod
