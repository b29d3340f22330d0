// A data array that came with an input surface and leaves with the result unchanged.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace vasorod {

/// rows = points (or triangles), columns = components. Integer arrays stay integer in what is written.
struct NamedArray {
  std::string name;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  bool integer = false;
};

}  // namespace vasorod
