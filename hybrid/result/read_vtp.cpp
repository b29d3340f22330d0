#include "result/read_vtp.h"

#include <array>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/limits.h"
#include "data/sentence.h"
#include "geometry/triangle_surface.h"
#include "surface_file/surface_file.h"

namespace vasorod {

namespace {

SurfaceFile read(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string() + ": there is no such file, expected one of a result folder");
  SurfaceFile data = read_vtp(file);
  if (data.points.rows() == 0)
    throw InputError(file.string() + ": found no points, expected a file of a result folder");
  return data;
}

const NamedArray* array_named(const SurfaceFile& data, const std::string& name) {
  for (const NamedArray& array : data.point_arrays)
    if (array.name == name) return &array;
  return nullptr;
}

// A comparison squares distances and searches closest points, so every rest position must be
// finite.
Points rest_of(const std::filesystem::path& file, const SurfaceFile& data) {
  const NamedArray* rest = array_named(data, "RestPosition");
  if (rest == nullptr || rest->values.cols() != 3)
    throw InputError(
        file.string() +
        ": has no array RestPosition of three components, expected a file of a result folder");
  for (Eigen::Index i = 0; i < rest->values.rows(); ++i)
    if (!(rest->values.row(i).cwiseAbs().maxCoeff() <= largest_length) ||
        !rest->values.row(i).allFinite())
      throw InputError(file.string() + ": found point " + std::to_string(i) + " at rest at " +
                       place_text(rest->values.row(i).transpose()) +
                       ", expected finite coordinates below " + number_text(largest_length));
  return rest->values;
}

void check_ids(const std::filesystem::path& file, const SurfaceFile& data,
               const std::vector<std::vector<int>>& cells) {
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    for (const int id : cells[cell])
      if (id < 0 || id >= data.points.rows())
        throw InputError(file.string() + ": found a point that does not exist in line or polygon " +
                         std::to_string(cell) + ", expected points from 0 to " +
                         std::to_string(data.points.rows() - 1));
}

// The first component of an array; empty where the file has none.
Eigen::VectorXd values_of(const SurfaceFile& data, const std::string& name) {
  const NamedArray* array = array_named(data, name);
  return array != nullptr && array->values.cols() == 1 ? Eigen::VectorXd(array->values.col(0))
                                                       : Eigen::VectorXd();
}

std::vector<double> list_of(const SurfaceFile& data, const std::string& name) {
  const Eigen::VectorXd values = values_of(data, name);
  return {values.begin(), values.end()};
}

// The rows of an array of three components; empty where the file has none.
std::vector<Vec3> rows_of(const SurfaceFile& data, const std::string& name) {
  std::vector<Vec3> rows;
  const NamedArray* array = array_named(data, name);
  if (array == nullptr || array->values.cols() != 3) return rows;
  for (Eigen::Index i = 0; i < array->values.rows(); ++i)
    rows.emplace_back(array->values.row(i).transpose());
  return rows;
}

std::vector<Mat3> directors_of(const SurfaceFile& data) {
  std::vector<Mat3> directors;
  for (int k = 0; k < 3; ++k) {
    const NamedArray* array = array_named(data, "Director" + std::to_string(k + 1));
    if (array == nullptr || array->values.cols() != 3) return {};
    directors.resize(index(array->values.rows()));
    for (Eigen::Index i = 0; i < array->values.rows(); ++i)
      directors[index(i)].col(k) = array->values.row(i).transpose();
  }
  return directors;
}

Triangles triangles_of(const std::filesystem::path& file, const SurfaceFile& data) {
  check_ids(file, data, data.polygons);
  std::vector<std::array<int, 3>> triangles;
  for (const std::vector<int>& corners : data.polygons)
    for (std::size_t k = 2; k < corners.size(); ++k)
      triangles.push_back({corners[0], corners[k - 1], corners[k]});
  if (triangles.empty())
    throw InputError(file.string() + ": has no polygons, expected a vessel's surface");
  Triangles result(static_cast<Eigen::Index>(triangles.size()), 3);
  for (Eigen::Index t = 0; t < result.rows(); ++t)
    for (int k = 0; k < 3; ++k) result(t, k) = triangles[index(t)][index(k)];
  return result;
}

}  // namespace

ReadVessel read_vessel_vtp(const std::filesystem::path& file) {
  const SurfaceFile data = read(file);
  ReadVessel vessel;
  vessel.rest = rest_of(file, data);
  vessel.current = data.points;
  vessel.triangles = triangles_of(file, data);
  vessel.axial_stretch = values_of(data, "AxialStretch");
  vessel.twist_shear = values_of(data, "TwistShear");
  vessel.contact_pressure = values_of(data, "ContactPressure");
  vessel.space = data.space;
  try {
    boundary_loops(vessel.triangles);
  } catch (const InputError& error) {
    throw InputError(file.string() + ": found a surface that is none (" + error.what() +
                     "), expected a vessel's");
  }
  return vessel;
}

ReadCenterline read_centerline_vtp(const std::filesystem::path& file) {
  const SurfaceFile data = read(file);
  ReadCenterline line;
  line.rest = rest_of(file, data);
  line.current = data.points;
  line.lines = data.lines;
  line.radius = list_of(data, "MaximumInscribedSphereRadius");
  line.abscissa = list_of(data, "Abscissas");
  line.directors = directors_of(data);
  line.u = rows_of(data, "u");
  line.v = rows_of(data, "v");
  line.u0 = rows_of(data, "u0");
  line.v0 = rows_of(data, "v0");
  line.lumen_area = list_of(data, "LumenArea");
  line.flattening = list_of(data, "Flattening");
  check_ids(file, data, line.lines);
  return line;
}

TriangleSurface read_stump_vtp(const std::filesystem::path& file) {
  const SurfaceFile data = read(file);
  return {data.points, triangles_of(file, data)};
}

}  // namespace vasorod
