#include "python/arrays.h"

#include <map>
#include <string>

#include "result/write_vtp.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

py::array constant(Eigen::Index rows, double value) {
  py::array_t<double> array(rows);
  array.attr("fill")(value);
  array.attr("flags").attr("writeable") = false;
  return array;
}

// A field that was not modelled is written as its value at rest.
py::array field(const Eigen::VectorXd& values, Eigen::Index rows, double at_rest,
                const py::handle& owner) {
  return values.size() == 0 ? constant(rows, at_rest)
                            : looking_at(values.data(), values.size(), owner);
}

py::array difference(const Points& a, const Points& b) {
  py::array_t<double> array({a.rows(), a.cols()});
  Eigen::Map<Points>(array.mutable_data(), a.rows(), 3) = a - b;
  array.attr("flags").attr("writeable") = false;
  return array;
}

// float64 -> as NumPy calls the types of VTK's XML format
std::string numpy_type(std::string vtk_type) {
  for (char& c : vtk_type)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return vtk_type;
}

py::array own_array(const NamedArray& own, const py::handle& owner) {
  py::array all = own.values.cols() == 1
                      ? looking_at(own.values.data(), own.values.rows(), owner)
                      : looking_at(own.values.data(), own.values.rows(), own.values.cols(), owner);
  const std::string type = numpy_type(written_type(own));
  if (type == "float64") return all;
  py::array typed = all.attr("astype")(type);
  typed.attr("flags").attr("writeable") = false;
  return typed;
}

}  // namespace

py::array looking_at(const double* first, Eigen::Index count, const py::handle& owner) {
  py::array array(py::dtype::of<double>(), std::vector<py::ssize_t>{count},
                  std::vector<py::ssize_t>{static_cast<py::ssize_t>(sizeof(double))}, first, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array looking_at(const std::vector<Vec3>& vectors, const py::handle& owner) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double), "rows without gaps");
  const double* first = vectors.empty() ? nullptr : vectors.front().data();
  return looking_at(first, static_cast<Eigen::Index>(vectors.size()), 3, owner);
}

void add_own_arrays(const std::vector<NamedArray>& arrays, const py::handle& owner, py::dict& all) {
  const py::list taken(all);  // the names of ours
  for (const NamedArray& own : arrays) {
    const py::str name(own.name);
    all[taken.contains(name) ? py::str(own.name + "_input") : name] = own_array(own, owner);
  }
}

py::dict point_arrays(const VesselResult& vessel, const py::handle& owner) {
  const Eigen::Index n = vessel.rest.rows();
  py::dict all;
  all["RestPosition"] = looking_at(vessel.rest, owner);
  all["Displacement"] = difference(vessel.current, vessel.rest);
  all["AxialStretch"] = field(vessel.axial_stretch, n, 1, owner);
  all["TwistShear"] = field(vessel.twist_shear, n, 0, owner);
  all["ContactPressure"] = field(vessel.contact_pressure, n, 0, owner);
  add_own_arrays(vessel.point_arrays, owner, all);
  return all;
}

py::dict point_arrays(const CenterlineResult& line, const py::handle& owner) {
  const auto numbers = [&](const std::vector<double>& values) {
    return looking_at(values.data(), static_cast<Eigen::Index>(values.size()), owner);
  };
  py::dict all;
  all["Abscissas"] = numbers(line.abscissa);
  if (!line.radius.empty()) all["MaximumInscribedSphereRadius"] = numbers(line.radius);
  static_assert(sizeof(Mat3) == 9 * sizeof(double), "directors without gaps, column by column");
  const auto nodes = static_cast<Eigen::Index>(line.directors.size());
  for (int k = 0; k < 3; ++k) {
    const double* first = nodes == 0 ? nullptr : line.directors.front().data() + 3 * k;
    all[py::str("Director" + std::to_string(k + 1))] = looking_at(first, nodes, 3, owner, 9);
  }
  all["RestPosition"] = looking_at(line.rest, owner);
  all["u"] = looking_at(line.u, owner);
  all["v"] = looking_at(line.v, owner);
  all["u0"] = looking_at(line.u0, owner);
  all["v0"] = looking_at(line.v0, owner);
  if (!line.force.empty()) {
    all["SectionForce"] = looking_at(line.force, owner);
    all["SectionMoment"] = looking_at(line.moment, owner);
  }
  if (!line.lumen_area.empty()) {
    all["LumenArea"] = numbers(line.lumen_area);
    all["Flattening"] = numbers(line.flattening);
  }
  return all;
}

}  // namespace vasorod::python
