#include "propose/place_operation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <vasorod/error.h>

#include "data/index.h"
#include "rod/binding.h"
#include "surgery/pick_place.h"
#include "vessel/name_ends.h"

namespace vasorod {
namespace {

// A place for both picks; the lower its score, the better.
struct Candidate {
  double score = 0;
  int to = 0;             // the end of the artery at which `along` is 1
  double along = 0;       // on the artery
  double around_deg = 0;  // on the artery
  double cut = 0;         // fraction of the vein from its kept end
  Vec3 point = Vec3::Zero();
};

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

Pose section_at(const RodTree& rod, const AxisPlace& at) {
  return frame_at(rod, rod.rest, at.element, at.s);
}

// How well the vein, cut so that it is as long as the way to `point`, would come to it from outside
// along the wall's normal.
class Score {
 public:
  Score(const Vessel& vein, int kept_end)
      : vein_(vein),
        kept_(vein.ends[index(kept_end)].center),
        route_(vein, {kept_end, farthest_end(vein, kept_end)}) {}

  void operator()(const Vec3& normal, Candidate& candidate) const {
    constexpr double shortest = 0.2, longest = 0.9;  // of the vein, clear of its ends
    const double way = (candidate.point - kept_).norm(), length = route_.length();
    candidate.cut = rounded(std::clamp(way / length, shortest, longest), 1e-3);
    const double s = candidate.cut * length, step = 1e-3 * length;
    const Vec3 center = section_at(vein_.rod, route_.at(s)).position;
    const Vec3 onward = (section_at(vein_.rod, route_.at(s + step)).position -
                         section_at(vein_.rod, route_.at(s - step)).position)
                            .normalized();
    const double turn = std::acos(std::clamp(-onward.dot(normal), -1.0, 1.0));
    // In radians: a turn of 60 degrees costs as much as five radii aside or 17 % of stretch.
    candidate.score = turn + 0.2 * (candidate.point - center).norm() / vein_.mean_radius +
                      6 * std::abs(way / (candidate.cut * length) - 1);
  }

 private:
  const Vessel& vein_;
  Vec3 kept_;
  AxisRoute route_;
};

std::vector<Candidate> candidates_on(const Vessel& artery, const Score& score) {
  const RayHits wall(artery.surface);
  std::vector<Candidate> all;
  for (int to = 1; to < static_cast<int>(artery.ends.size()); ++to) {
    const AxisRoute route(artery.rod, artery.ends[0].node, artery.ends[index(to)].node);
    for (double along = 0.04; along < 0.98; along += 0.02)
      for (int around = -165; around <= 180; around += 15) {
        Candidate candidate;
        candidate.to = to;
        candidate.along = rounded(along, 1e-3);
        candidate.around_deg = around;
        const Pose section = section_at(artery.rod, route.at(candidate.along * route.length()));
        const auto point = wall_point(wall, section, around * M_PI / 180);
        if (!point) continue;
        candidate.point = *point;
        score((*point - section.position).normalized(), candidate);
        all.push_back(candidate);
      }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
  return all;
}

}  // namespace

int head_end(const Vessel& vein, const Vessel& artery, const std::string& space) {
  int head = 0;
  double best = -std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < vein.ends.size(); ++k) {
    double height = vein.ends[k].center.z();  // LPS and RAS agree on what is up
    if (space.empty()) {
      height = 0;
      for (const VesselEnd& end : artery.ends) height += (vein.ends[k].center - end.center).norm();
    }
    if (height <= best) continue;
    best = height;
    head = static_cast<int>(k);
  }
  return head;
}

std::optional<PlacedOperation> place_operation(const Scene& scene, const PreparedVessel& vein,
                                               const PreparedVessel& artery, int kept_end,
                                               int most_tries) {
  std::vector<Candidate> refused;
  int tries = 0;
  for (const Candidate& candidate : candidates_on(artery.vessel, {vein.vessel, kept_end})) {
    // Beside a place that does not fit, the next one does not either.
    if (std::any_of(refused.begin(), refused.end(), [&](const Candidate& other) {
          return (candidate.point - other.point).norm() < 0.5 * vein.vessel.mean_radius;
        }))
      continue;
    PlacedOperation placed;
    GlennSpec& spec = placed.spec;
    spec.svc = vein.spec.name;
    spec.rpa = artery.spec.name;
    spec.keep = selector_of(vein.vessel, kept_end);
    spec.cut.along = candidate.cut;
    spec.incision.along = candidate.along;
    spec.incision.around_deg = candidate.around_deg;
    if (artery.vessel.ends.size() > 2) spec.incision.to = selector_of(artery.vessel, candidate.to);
    try {
      PreparedVessel svc = vein, rpa = artery;
      VesselConditions conditions = end_conditions(scene, vein.spec.name, svc.vessel);
      const Operation operation = operate(scene, spec, svc, rpa, conditions);
      const std::optional<RodSolution>& rod = operation.vessels[0].rod;
      if (rod && rod->summary.status == Status::converged &&
          operation.glenn->join.axis_turn_deg <= 90) {
        placed.report = *operation.glenn;
        return placed;
      }
    } catch (const InputError&) {
    }
    refused.push_back(candidate);
    if (++tries >= most_tries) break;
  }
  return std::nullopt;
}

}  // namespace vasorod
