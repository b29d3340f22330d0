#include "rod/start_shape.h"

#include <algorithm>

#include "data/index.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

/// Harmonic interpolation along arc length: values are given at some nodes, no flux elsewhere; zero
/// if no value is given.
std::vector<Vec3> spread(const std::vector<RodLink>& links, const std::vector<const Vec3*>& given) {
  const std::size_t n = links.size() + 1;
  std::vector<double> weight(n, 0);
  std::vector<Vec3> flux(n, Vec3::Zero()), value(n, Vec3::Zero());
  for (std::size_t k = links.size(); k-- > 0;) {
    const double conductance = 1 / links[k].length;
    const std::size_t parent = index(links[k].parent);
    if (given[k + 1]) {
      weight[parent] += conductance;
      flux[parent] += conductance * *given[k + 1];
    } else if (weight[k + 1] > 0) {
      const double series = conductance * weight[k + 1] / (conductance + weight[k + 1]);
      weight[parent] += series;
      flux[parent] += series / weight[k + 1] * flux[k + 1];
    }
  }
  if (given[0])
    value[0] = *given[0];
  else if (weight[0] > 0)
    value[0] = flux[0] / weight[0];
  for (std::size_t k = 0; k < links.size(); ++k) {
    const double conductance = 1 / links[k].length;
    value[k + 1] = given[k + 1] ? *given[k + 1]
                                : Vec3((conductance * value[index(links[k].parent)] + flux[k + 1]) /
                                       (conductance + weight[k + 1]));
  }
  return value;
}

}  // namespace

std::vector<Pose> start_shape(const std::vector<RodLink>& links,
                              const std::vector<NodeCondition>& conditions,
                              const std::vector<Vec3>& turn, const std::vector<Pose>& poses,
                              double* largest_turn) {
  const std::size_t n = links.size() + 1;
  std::vector<const Vec3*> given(n, nullptr);
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const auto& fixed = conditions[c].fixed;
    if (fixed[3] || fixed[4] || fixed[5]) given[index(conditions[c].node)] = &turn[c];
  }
  const std::vector<Vec3> rotation = spread(links, given);
  if (largest_turn) {
    *largest_turn = 0;
    for (std::size_t k = 0; k < links.size(); ++k)
      *largest_turn =
          std::max(*largest_turn, (rotation[k + 1] - rotation[index(links[k].parent)]).norm());
  }
  std::vector<Pose> result(n);
  for (std::size_t k = 0; k < n; ++k)
    result[k].rotation = exp_rotation(rotation[k]) * poses[k].rotation;
  result[0].position = poses[0].position;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const std::size_t parent = index(links[k].parent);
    const Mat3 middle = exp_rotation(0.5 * (rotation[parent] + rotation[k + 1]));
    result[k + 1].position =
        result[parent].position + middle * (poses[k + 1].position - poses[parent].position);
  }
  std::vector<Vec3> miss(conditions.size());
  given.assign(n, nullptr);
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const auto& fixed = conditions[c].fixed;
    if (!(fixed[0] && fixed[1] && fixed[2])) continue;
    miss[c] = conditions[c].target.position - result[index(conditions[c].node)].position;
    given[index(conditions[c].node)] = &miss[c];
  }
  const std::vector<Vec3> correction = spread(links, given);
  for (std::size_t k = 0; k < n; ++k) result[k].position += correction[k];
  for (const NodeCondition& c : conditions)
    if (c.fixed_count() == 6) result[index(c.node)] = c.target;
  return result;
}

}  // namespace vasorod
