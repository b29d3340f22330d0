#include "rod/link.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace vasorod {

Vec6 elastic_strain(const RodLink& link, const Vec6& stress) {
  if (link.stiffness.isDiagonal(0)) return stress.cwiseQuotient(link.stiffness.diagonal());
  return link.stiffness.ldlt().solve(stress);
}

Vec6 NodeCondition::load(const Pose& pose) const {
  Vec6 sum;
  sum << force, space_moment + pose.rotation * body_moment;
  return sum;
}

int NodeCondition::fixed_count() const {
  return static_cast<int>(std::count(fixed.begin(), fixed.end(), true));
}

}  // namespace vasorod
