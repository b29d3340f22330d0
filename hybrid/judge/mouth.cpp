#include "judge/mouth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/plane_section.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// The largest distance between two points of a plane polygon.
std::array<Eigen::Index, 2> farthest(const Points& points) {
  std::array<Eigen::Index, 2> best{0, 0};
  double largest = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    for (Eigen::Index j = i + 1; j < points.rows(); ++j) {
      const double distance = (points.row(i) - points.row(j)).squaredNorm();
      if (distance <= largest) continue;
      largest = distance;
      best = {i, j};
    }
  return best;
}

SectionLoop loop_of(Points points) {
  SectionLoop loop;
  loop.points = std::move(points);
  return loop;
}

}  // namespace

MouthReport measure_mouth(const PreparedVessel& vein, const Points& vein_now,
                          const Points& recipient_now, const std::vector<std::array<int, 2>>& pairs,
                          const Vec3& axis) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Points seam(n, 3), rest(n, 3);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto [a, b] = pairs[static_cast<size_t>(k)];
    seam.row(k) = (vein_now.row(a) + recipient_now.row(b)) / 2;
    rest.row(k) = vein.vessel.surface.points.row(a);
  }
  MouthReport mouth;
  mouth.center = section_centroid(loop_of(seam));
  const double to_mid = vein.mid_offset(), to_lumen = vein.lumen_offset();
  const SectionLoop now = loop_of(seam), before = loop_of(rest);
  mouth.area = inset_area(now, -to_mid);
  mouth.lumen = inset_area(now, to_lumen);
  const SectionLoop across = loop_of(rest - (rest * axis) * axis.transpose());
  mouth.area_ratio = mouth.lumen / inset_area(across, to_lumen);
  mouth.perimeter = section_perimeter(now) + 2 * M_PI * to_mid;
  mouth.perimeter_ratio = mouth.perimeter / (section_perimeter(before) + 2 * M_PI * to_mid);

  std::vector<int> all(pairs.size());
  std::iota(all.begin(), all.end(), 0);
  const Vec3 normal = area_vector(seam, all).normalized();  // zero where the mouth encloses nothing
  const Points flat = seam - (seam * normal) * normal.transpose();
  const auto [i, j] = farthest(flat);
  const Vec3 along = (flat.row(j) - flat.row(i)).normalized();
  const Eigen::VectorXd aside = flat * normal.cross(along);
  mouth.span = (flat.row(j) - flat.row(i)).norm() + 2 * to_mid;
  mouth.width = aside.maxCoeff() - aside.minCoeff() + 2 * to_mid;
  return mouth;
}

void judge_mouth(const std::string& vein, const MouthReport& mouth, VesselMetrics& metrics,
                 Validity& validity) {
  if (mouth.area_ratio < metrics.smallest_lumen_ratio) {
    metrics.smallest_lumen_ratio = mouth.area_ratio;
    metrics.where["smallest_lumen_ratio"] = mouth.center;
  }
  if (!(mouth.area_ratio < 0.6)) return;
  const bool severe = mouth.area_ratio < 0.4;
  validity.warnings.push_back(
      "mouth of " + vein + " at " + place_text(mouth.center, 3) + ": its lumen is " +
      number_beside(mouth.area_ratio, severe ? 0.4 : 0.6, 2) + " of the cut vein's, " +
      (severe ? "a severe narrowing (below 0.4)" : "a narrowing (below 0.6)") +
      "; both limits are conventions, no measured threshold is known");
}

std::vector<char> opened_elements(const PreparedVessel& recipient,
                                  const std::vector<std::array<int, 2>>& pairs) {
  const RodTree& rod = recipient.vessel.rod;
  std::vector<char> opened(rod.elements.size(), 0);
  for (const auto& pair : pairs)
    opened[index(recipient.vessel.binding[index(pair[1])].element)] = 1;
  // The rim may skip elements shorter than its edges.
  for (const RodBranch& branch : rod.branches) {
    const auto is_open = [&](int element) { return opened[index(element)] != 0; };
    const auto first = std::find_if(branch.elements.begin(), branch.elements.end(), is_open);
    if (first == branch.elements.end()) continue;
    const auto last =
        std::find_if(branch.elements.rbegin(), branch.elements.rend(), is_open).base();
    for (auto element = first; element != last; ++element) opened[index(*element)] = 1;
  }
  return opened;
}

}  // namespace vasorod
