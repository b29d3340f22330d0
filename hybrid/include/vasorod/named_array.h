// A data array of an input surface that is copied to the result unchanged.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace vasorod {

/// A named array with one row per point or triangle. Integer arrays are written as integers.
struct NamedArray {
  std::string name;  ///< as in the input file
  /// Rows: points or triangles. Columns: components.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  bool integer = false;  ///< the values are integers
  /// Type name of VTK's XML format (Float32, Int32, UInt8, ...). Empty: Float64, or Int32 / Int64
  /// if `integer`.
  std::string type;
};

}  // namespace vasorod
