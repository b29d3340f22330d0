#include "rod/link.h"

#include <algorithm>

namespace vasorod {

Vec6 NodeCondition::load(const Pose& pose) const {
  Vec6 sum;
  sum << force, space_moment + pose.rotation * body_moment;
  return sum;
}

int NodeCondition::fixed_count() const {
  return static_cast<int>(std::count(fixed.begin(), fixed.end(), true));
}

}  // namespace vasorod
