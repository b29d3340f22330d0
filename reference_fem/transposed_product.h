// C = A^T B of cell matrices by OpenBLAS, which takes the processor's widest vectors at run time;
// Eigen's own kernel takes those the compiler was told of, two doubles by default.
#pragma once

#include <Eigen/Core>

namespace vasorod::fem {

/// `c` must have the product's size already.
void transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                        Eigen::Ref<Eigen::MatrixXd> c);

}  // namespace vasorod::fem
