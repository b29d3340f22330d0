#include <memory>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <vasorod/scene.h>

#include "python/classes.h"

namespace vasorod::python {

void bind_scene(pybind11::module_& module) {
  namespace py = pybind11;
  py::class_<Scene, std::shared_ptr<Scene>>(module, "Scene", "A checked scene, as C++ has it.")
      .def_readonly("name", &Scene::name)
      .def_readonly("fidelity", &Scene::fidelity)
      .def_property_readonly("length_unit", [](const Scene& self) { return self.units.length; })
      .def_property_readonly("stress_unit", [](const Scene& self) { return self.units.stress; })
      .def_property_readonly("vessels", [](const Scene& self) {
        py::list names;
        for (const VesselSpec& vessel : self.vessels) names.append(vessel.name);
        return names;
      });
}

}  // namespace vasorod::python
