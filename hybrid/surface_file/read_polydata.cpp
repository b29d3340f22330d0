#include "surface_file/read_polydata.h"

#include <array>
#include <fstream>
#include <map>
#include <vtkIdList.h>
#include <vtkPoints.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <vasorod/error.h>

#include "data/limits.h"
#include "data/sentence.h"
#include "surface_file/space.h"
#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

SurfaceFormat format_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".vtp") return SurfaceFormat::vtp;
  if (ending == ".stl") return SurfaceFormat::stl;
  if (ending == ".ply") return SurfaceFormat::ply;
  if (ending == ".obj") return SurfaceFormat::obj;
  throw InputError(file.string() + ": found the ending \"" + ending +
                   "\", expected .vtp, .stl, .ply or .obj");
}

void check_readable(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(name + ": found no such file, expected a surface");
  if (!std::filesystem::is_regular_file(file, ignored))
    throw InputError(name + ": found a folder or device, expected a surface file");
  if (std::filesystem::file_size(file, ignored) == 0)
    throw InputError(name + ": found an empty file, expected a surface");
  if (!std::ifstream(file, std::ios::binary))
    throw FileError(name + ": found a file that may not be read, expected a surface file");
}

void check_points(const std::filesystem::path& file, const Points& points) {
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite())
      throw InputError(file.string() + ": found a coordinate of point " + std::to_string(i) +
                       " that is not a number, expected finite coordinates");
    else if (points.row(i).cwiseAbs().maxCoeff() > largest_length)
      throw InputError(file.string() + ": found point " + std::to_string(i) + " at " +
                       place_text(points.row(i)) + ", expected coordinates below " +
                       number_text(largest_length));
}

struct Faces {
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> cell;  // of the file, from which each triangle came
};

// Cuts a polygon into triangles: a quad along its shorter diagonal, others by ear clipping.
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
      add(corners[static_cast<size_t>(ears->GetId(k))],
          corners[static_cast<size_t>(ears->GetId(k + 1))],
          corners[static_cast<size_t>(ears->GetId(k + 2))]);
  }
}

Faces cut_into_triangles(const std::filesystem::path& file, const SurfaceFile& read) {
  Faces faces;
  int cell = read.skipped_cells;
  auto check = [&](const std::vector<int>& corners) {
    auto refuse = [&](const std::string& found, const std::string& expected) {
      throw InputError(file.string() + ": found " + found + " in cell " + std::to_string(cell) +
                       ", expected " + expected);
    };
    if (corners.size() < 3) refuse(std::to_string(corners.size()) + " points", "at least three");
    for (const int id : corners)
      if (id < 0 || id >= read.points.rows())
        refuse("a point that does not exist",
               "points from 0 to " + std::to_string(read.points.rows() - 1));
  };
  for (const auto& corners : read.polygons) {
    check(corners);
    add_polygon(corners, read.points, cell++, faces);
  }
  for (const auto& corners : read.strips) {
    check(corners);
    for (size_t k = 0; k + 2 < corners.size();
         ++k) {  // every second triangle of a strip has the opposite orientation
      faces.triangles.push_back({corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]});
      faces.cell.push_back(cell);
    }
    ++cell;
  }
  return faces;
}

// Replaces exact duplicates by their first occurrence. The duplicates then have no triangles.
int weld(LoadedSurface& loaded) {
  const Points& points = loaded.surface.points;
  std::map<std::array<double, 3>, int> first;
  std::vector<int> to(static_cast<size_t>(points.rows()));
  int merged = 0;
  for (int i = 0; i < points.rows(); ++i) {
    const auto [at, is_new] =
        first.emplace(std::array{points(i, 0), points(i, 1), points(i, 2)}, i);
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
    for (int k = 0; k < 3; ++k)
      surface.triangles(t, k) = to[static_cast<size_t>(surface.triangles(t, k))];
  keep_rows(loaded.point_arrays, keep);
  return dropped;
}

LoadedSurface read_polydata(const std::filesystem::path& file) {
  const SurfaceFormat format = format_of(file);
  check_readable(file);
  SurfaceFile read = format == SurfaceFormat::vtp   ? read_vtp(file)
                     : format == SurfaceFormat::stl ? read_stl(file)
                     : format == SurfaceFormat::ply ? read_ply(file)
                                                    : read_obj(file);
  check_points(file, read.points);
  const Faces faces = cut_into_triangles(file, read);
  if (faces.triangles.empty())
    throw InputError(file.string() +
                     ": found no triangles, expected a surface of triangles or polygons");
  LoadedSurface loaded;
  loaded.surface.points = std::move(read.points);
  loaded.surface.triangles.resize(static_cast<Eigen::Index>(faces.triangles.size()), 3);
  for (size_t t = 0; t < faces.triangles.size(); ++t)
    loaded.surface.triangles.row(static_cast<Eigen::Index>(t)) << faces.triangles[t][0],
        faces.triangles[t][1], faces.triangles[t][2];
  loaded.space = format == SurfaceFormat::vtp ? read.space : space_in_head(file);
  loaded.point_arrays = std::move(read.point_arrays);
  loaded.cell_arrays = std::move(read.cell_arrays);
  keep_rows(loaded.cell_arrays, faces.cell);
  loaded.report.skipped_cells = read.skipped_cells;
  if (format == SurfaceFormat::stl || format == SurfaceFormat::obj)
    loaded.report.merged_points = weld(loaded);
  loaded.report.removed_triangles = remove_repeated_corners(loaded);
  if (loaded.surface.triangles.rows() == 0)
    throw InputError(file.string() +
                     ": found only triangles that use a point twice, expected a surface");
  loaded.report.dropped_points = drop_unused_points(loaded) - loaded.report.merged_points;
  return loaded;
}

}  // namespace vasorod
