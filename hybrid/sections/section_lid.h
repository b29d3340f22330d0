// The flat fan that closes an open end of a vessel given by harmonics: from the rim to the rim's
// mean. With x = c + sum_k (a_k cos k theta + b_k sin k theta) on the rim, its area vector along
// the vessel and its share of the volume are
//
//   w = 1/2 closed integral of x x dx = pi sum_k k a_k x b_k,   V = +- c . w / 3
//
// (+ at the vessel's end, - at its start). With it the volume does not depend on the origin.
#pragma once

#include <Eigen/Core>

#include <vasorod/types.h>

namespace vasorod {

/// A lid over the end of a vessel with these harmonics.
class SectionLid {
 public:
  /// `last`: the end at u = 1.
  SectionLid(int harmonics, bool last) : harmonics_(harmonics), sign_(last ? 1 : -1) {}

  bool last() const { return sign_ > 0; }

  /// `row`: the coefficients of the rim, modes of x first, then those of y and z. Adds `factor`
  /// times the gradient and returns V, length^3.
  double add_gradient(const Eigen::VectorXd& row, double factor,
                      Eigen::Ref<Eigen::VectorXd> gradient) const;
  /// Adds `factor` times the Hessian.
  void add_hessian(const Eigen::VectorXd& row, double factor, Eigen::MatrixXd& hessian) const;

  /// Force of a unit pressure on the lid, up to the inner face, `depth` inside of the rim,
  /// length^2, and its moment about `center`, length^3.
  void wrench(const Eigen::VectorXd& row, double depth, const Vec3& center, Vec3& force,
              Vec3& moment) const;

 private:
  int modes() const { return 2 * harmonics_ + 1; }
  Vec3 mode(const Eigen::VectorXd& row, int m) const {
    return {row[m], row[modes() + m], row[2 * modes() + m]};
  }

  int harmonics_;
  double sign_;
};

}  // namespace vasorod
