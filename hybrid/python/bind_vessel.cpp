#include <memory>
#include <pybind11/stl.h>
#include <string>

#include "python/arrays.h"
#include "python/classes.h"
#include "surface_file/read_surface.h"

namespace vasorod::python {
namespace {

namespace py = pybind11;

// What the Python object `self` stands for.
template <class Type>
const Type& of(const py::object& self) {
  return self.cast<const Type&>();
}

py::dict cell_arrays_of(const std::vector<NamedArray>& arrays, const py::object& self) {
  py::dict all;
  add_own_arrays(arrays, self, all);
  return all;
}

std::string counted(Eigen::Index count, const std::string& what) {
  return std::to_string(count) + " " + what;
}

py::list lines_of(const CenterlineResult& centerline) {
  py::list lines;
  for (const std::vector<int>& line : centerline.lines) {
    const py::array_t<int> nodes(static_cast<py::ssize_t>(line.size()), line.data());
    nodes.attr("flags").attr("writeable") = false;
    lines.append(nodes);
  }
  return lines;
}

void bind_centerline(py::module_& module) {
  py::class_<CenterlineResult, std::shared_ptr<CenterlineResult>>(module, "Centerline",
                                                                  R"(The rod of a vessel.

Its nodes are in order; at forks it has several branches. Arrays are read-only and share the
result's memory.

>>> line = result.vessels["tube"].centerline
>>> line.points.shape == line.rest.shape == (len(line.points), 3)
True
>>> [len(branch) for branch in line.lines] == [len(line.points)]
True
>>> sorted(line.point_arrays)[:3]
['Abscissas', 'Director1', 'Director2']
)")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            return looking_at(of<CenterlineResult>(self).current, self);
          },
          "Current positions of the nodes, (n, 3) float64, in the scene's length unit.")
      .def_property_readonly(
          "rest",
          [](const py::object& self) { return looking_at(of<CenterlineResult>(self).rest, self); },
          "Positions of the nodes at rest, (n, 3) float64, in the scene's length unit.")
      .def_property_readonly("lines", &lines_of,
                             "Node numbers of each branch in order, a list of (k,) int32.")
      .def_property_readonly(
          "point_arrays",
          [](const py::object& self) { return point_arrays(of<CenterlineResult>(self), self); },
          "The point arrays of NAME_centerline.vtp by name, (n,) or (n, 3) float64: Abscissas,\n"
          "MaximumInscribedSphereRadius, Director1, Director2, Director3, RestPosition, u, v, u0,\n"
          "v0, and where there are any SectionForce, SectionMoment, LumenArea and Flattening.\n"
          "docs/result.md has their units.")
      .def("__repr__", [](const CenterlineResult& self) {
        return "<vasorod.Centerline: " + counted(self.current.rows(), "nodes") + ", " +
               counted(static_cast<Eigen::Index>(self.lines.size()), "lines") + ">";
      });
}

}  // namespace

void bind_surface(py::module_& module) {
  py::class_<LoadedSurface, std::shared_ptr<LoadedSurface>>(module, "Surface",
                                                            R"(Points, triangles and their arrays.

A surface file as it was read, or the stump that a cut leaves. Arrays are read-only.
)")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            return looking_at(of<LoadedSurface>(self).surface.points, self);
          },
          "Positions of the points, (n, 3) float64, in the file's or the scene's length unit.")
      .def_property_readonly(
          "triangles",
          [](const py::object& self) {
            return looking_at(of<LoadedSurface>(self).surface.triangles, self);
          },
          "Point numbers of the triangles, (m, 3) int32, counter-clockwise seen from outside.")
      .def_property_readonly(
          "point_arrays",
          [](const py::object& self) {
            return cell_arrays_of(of<LoadedSurface>(self).point_arrays, self);
          },
          "The file's arrays with one row for each point, by name.")
      .def_property_readonly(
          "cell_arrays",
          [](const py::object& self) {
            return cell_arrays_of(of<LoadedSurface>(self).cell_arrays, self);
          },
          "The file's arrays with one row for each triangle, by name: ModelFaceID and others.")
      .def_readonly("space", &LoadedSurface::space,
                    "LPS or RAS where the file says so, else an empty text.")
      .def("__repr__", [](const LoadedSurface& self) {
        return "<vasorod.Surface: " + counted(self.surface.points.rows(), "points") + ", " +
               counted(self.surface.triangles.rows(), "triangles") + ">";
      });
}

void bind_vessel(py::module_& module) {
  bind_centerline(module);
  py::class_<VesselResult, std::shared_ptr<VesselResult>>(module, "Vessel",
                                                          R"(One vessel of a result.

Arrays are read-only and share the result's memory, which lives as long as they do; copy() one to
change it. Lengths are in the scene's length unit. A bare rod has no points and no triangles, only
its centerline.

>>> tube = result.vessels["tube"]
>>> tube.points.shape == tube.rest.shape and tube.triangles.shape[1] == 3
True
>>> float(tube.points[:, 2].max() - tube.rest[:, 2].max())
3.0
>>> sorted(tube.point_arrays)
['AxialStretch', 'ContactPressure', 'Displacement', 'RestPosition', 'TwistShear']

PyVista takes them as they are: pyvista.PolyData.from_regular_faces(tube.points, tube.triangles).
)")
      .def_readonly("name", &VesselResult::name, "The vessel's name in the scene.")
      .def_readonly("obstacle", &VesselResult::obstacle, "True: it does not deform.")
      .def_readonly("space", &VesselResult::space,
                    "LPS or RAS where the surface file says so, else an empty text.")
      .def_property_readonly(
          "points",
          [](const py::object& self) { return looking_at(of<VesselResult>(self).current, self); },
          "Current positions of the points, (n, 3) float64, in the scene's length unit.")
      .def_property_readonly(
          "rest",
          [](const py::object& self) { return looking_at(of<VesselResult>(self).rest, self); },
          "Positions of the points at rest, (n, 3) float64: where surgery left them.")
      .def_property_readonly(
          "triangles",
          [](const py::object& self) { return looking_at(of<VesselResult>(self).triangles, self); },
          "Point numbers of the triangles, (m, 3) int32, counter-clockwise seen from outside.")
      .def_property_readonly(
          "point_arrays",
          [](const py::object& self) { return point_arrays(of<VesselResult>(self), self); },
          "The point arrays of NAME.vtp by name: RestPosition and Displacement, (n, 3) float64;\n"
          "AxialStretch and TwistShear, (n,), no unit; ContactPressure, (n,), stress; and those "
          "of\n"
          "the input with their types.")
      .def_property_readonly(
          "cell_arrays",
          [](const py::object& self) {
            return cell_arrays_of(of<VesselResult>(self).cell_arrays, self);
          },
          "The input's arrays with one row for each triangle, by name: ModelFaceID and others.")
      .def_property_readonly(
          "centerline",
          [](const std::shared_ptr<VesselResult>& self) -> std::shared_ptr<CenterlineResult> {
            if (!self->centerline) return nullptr;
            return {self, &*self->centerline};
          },
          "The vessel's rod, a Centerline; None for an obstacle.")
      .def_property_readonly(
          "stump",
          [](const VesselResult& self) -> std::shared_ptr<LoadedSurface> {
            if (!self.stump) return nullptr;
            auto stump = std::make_shared<LoadedSurface>();
            stump->surface = *self.stump;
            stump->space = self.space;
            return stump;
          },
          "What a cut left behind, closed, a Surface; None without a cut.")
      .def("__repr__", [](const VesselResult& self) {
        return "<vasorod.Vessel " + self.name + ": " + counted(self.rest.rows(), "points") + ", " +
               counted(self.triangles.rows(), "triangles") +
               (self.obstacle ? ", an obstacle>" : ">");
      });
}

}  // namespace vasorod::python
