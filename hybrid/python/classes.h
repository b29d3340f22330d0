// The Python classes of what the library returns. Each looks at its part of the C++ object and
// keeps the whole of it alive.
#pragma once

#include <pybind11/pybind11.h>

namespace vasorod::python {

void bind_scene(pybind11::module_& module);    ///< Scene
void bind_surface(pybind11::module_& module);  ///< Surface
void bind_vessel(pybind11::module_& module);   ///< Vessel, Centerline
void bind_result(pybind11::module_& module);   ///< Result, Comparison
void bind_explore(pybind11::module_& module);  ///< the function explore

}  // namespace vasorod::python
