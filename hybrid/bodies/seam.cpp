#include "bodies/seam.h"

#include <algorithm>
#include <cmath>

#include <vasorod/error.h>

namespace vasorod {
namespace {

const ScaledBody& body(const ScaledBodies& scaled, int b) {
  return scaled.bodies[static_cast<size_t>(b)];
}

}  // namespace

void check_seams(const std::vector<SeamPair>& seams, const ScaledBodies& scaled) {
  for (const SeamPair& seam : seams)
    for (const auto& [b, v] :
         {std::pair{seam.body_a, seam.vertex_a}, std::pair{seam.body_b, seam.vertex_b}})
      if (b < 0 || b >= static_cast<int>(scaled.bodies.size()) || v < 0 ||
          v >= body(scaled, b).rest.points.rows())
        throw InputError("seam: found vertex " + std::to_string(v) + " of body " +
                         std::to_string(b) + ", expected one that exists");
}

double mouth_radius(const std::vector<SeamPair>& seams, const ScaledBodies& scaled) {
  if (seams.empty()) return 0;
  Points mouth(static_cast<Eigen::Index>(seams.size()), 3);
  for (size_t i = 0; i < seams.size(); ++i)
    mouth.row(static_cast<Eigen::Index>(i)) =
        body(scaled, seams[i].body_a).rest.points.row(seams[i].vertex_a);
  return std::sqrt((mouth.rowwise() - mouth.colwise().mean()).rowwise().squaredNorm().mean());
}

double joining_stiffness(const std::vector<SeamPair>& seams, const ScaledBodies& scaled,
                         double factor) {
  double stiffness = 0;
  for (const SeamPair& seam : seams)
    for (const int b : {seam.body_a, seam.body_b}) {
      const Coefficients& k = body(scaled, b).k;
      stiffness = std::max(stiffness, factor * std::max(k.bending, k.stretching));
    }
  return stiffness;
}

std::vector<Join> stacked_joins(const std::vector<SeamPair>& seams, const std::vector<int>& first,
                                const std::vector<Vec3>& multipliers) {
  std::vector<Join> joins;
  for (size_t i = 0; i < seams.size(); ++i)
    joins.push_back({first[static_cast<size_t>(seams[i].body_a)] + seams[i].vertex_a,
                     first[static_cast<size_t>(seams[i].body_b)] + seams[i].vertex_b,
                     multipliers[i]});
  return joins;
}

double largest_gap(const std::vector<Join>& joins, const Eigen::Ref<const Points>& p) {
  double largest = 0;
  for (const Join& join : joins)
    largest = std::max(largest, ((p.row(join.a) - p.row(join.b)).transpose() - join.offset).norm());
  return largest;
}

}  // namespace vasorod
