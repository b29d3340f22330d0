// NumPy arrays of a result's numbers. Those that only look at them are read-only and keep the
// result alive.
#pragma once

#include <Eigen/Core>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

#include <vasorod/named_array.h>
#include <vasorod/result.h>

namespace vasorod::python {

/// rows x columns numbers from `first` on, row by row, or `row_step` numbers from row to row. Looks
/// at them; `owner` is the Python object that they belong to.
template <class Number>
pybind11::array looking_at(const Number* first, Eigen::Index rows, Eigen::Index columns,
                           const pybind11::handle& owner, Eigen::Index row_step = 0) {
  const auto size = static_cast<pybind11::ssize_t>(sizeof(Number));
  const pybind11::ssize_t step = (row_step > 0 ? row_step : columns) * size;
  pybind11::array array(pybind11::dtype::of<Number>(),
                        std::vector<pybind11::ssize_t>{rows, columns},
                        std::vector<pybind11::ssize_t>{step, size}, first, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// n x columns: points, triangles.
template <class Number, int columns>
pybind11::array looking_at(
    const Eigen::Matrix<Number, Eigen::Dynamic, columns, Eigen::RowMajor>& rows,
    const pybind11::handle& owner) {
  return looking_at(rows.data(), rows.rows(), rows.cols(), owner);
}

/// n numbers.
pybind11::array looking_at(const double* first, Eigen::Index count, const pybind11::handle& owner);

/// n x 3, of vectors.
pybind11::array looking_at(const std::vector<Vec3>& vectors, const pybind11::handle& owner);

/// The point arrays of NAME.vtp: name -> array, in the file's order.
pybind11::dict point_arrays(const VesselResult& vessel, const pybind11::handle& owner);

/// The point arrays of NAME_centerline.vtp: name -> array, in the file's order.
pybind11::dict point_arrays(const CenterlineResult& centerline, const pybind11::handle& owner);

/// Adds an input's own arrays with the types with which they are written. One whose name is taken
/// is called NAME_input.
void add_own_arrays(const std::vector<NamedArray>& arrays, const pybind11::handle& owner,
                    pybind11::dict& all);

}  // namespace vasorod::python
