// B-splines along a vessel, u from 0 at its start to 1 at its end, on knots that are denser beside
// the ends: where a wall is glued or free, its bending decays over a length of about sqrt(R t).
#pragma once

#include <Eigen/Core>

namespace vasorod {

/// B-splines of one degree on one sequence of knots.
class AxialBasis {
 public:
  /// `spans`: intervals between knots, at least 1; `degree`: at least 2. The knots are the values
  /// of (1 + tanh(1.2 v) / tanh(1.2)) / 2 at equal distances of v in [-1, 1].
  AxialBasis(int spans, int degree);

  int degree() const { return degree_; }
  int spans() const { return static_cast<int>(knots_.size()) - 2 * degree_ - 1; }
  int count() const { return spans() + degree_; }  ///< of functions
  /// The interval of a span.
  double begin(int span) const { return knots_[degree_ + span]; }
  double end(int span) const { return knots_[degree_ + span + 1]; }

  /// The functions first .. first + degree() at u: row k of `values` holds their derivatives of
  /// order k = 0, 1, 2.
  struct Values {
    int first = 0;
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> values;
  };
  Values at(double u) const;
  /// The same with u in a known span; at its ends, the limits from within.
  Values at(double u, int span) const;

  /// The Greville abscissae: where an interpolating spline takes its values. Size count().
  Eigen::VectorXd interpolation_points() const;

 private:
  int degree_;
  Eigen::RowVectorXd knots_;
};

}  // namespace vasorod
