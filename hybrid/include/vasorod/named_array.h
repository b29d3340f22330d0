// A data array that came with an input surface and leaves with the result unchanged.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace vasorod {

/// rows = points (or triangles), columns = components. Integer arrays stay integer in what is
/// written.
struct NamedArray {
  std::string name;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  bool integer = false;
  std::string type;  ///< as VTK's XML names it (Float32, Int32, UInt8, ...); empty: Float64, or
                     ///< Int32 / Int64 if integer
};

}  // namespace vasorod
