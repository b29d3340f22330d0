#include "bodies/reach.h"

namespace vasorod {

Box box_of(const Points& points) {
  if (points.rows() == 0) return {};
  return {points.colwise().minCoeff().transpose(), points.colwise().maxCoeff().transpose()};
}

bool within_reach(const Box& a, const Box& b, double margin) {
  return !a.isEmpty() && !b.isEmpty() && a.exteriorDistance(b) <= margin;
}

}  // namespace vasorod
