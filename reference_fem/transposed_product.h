// C = A^T B of cell matrices by OpenBLAS, which selects the processor's widest vector instructions
// at run time. Eigen's kernel uses those of the compiler's target, two doubles by default.
#pragma once

#include <Eigen/Core>

namespace vasorod::fem {

/// `c` must already have the size of the product.
void transposed_product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                        Eigen::Ref<Eigen::MatrixXd> c);

}  // namespace vasorod::fem
