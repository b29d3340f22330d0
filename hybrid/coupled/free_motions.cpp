#include "coupled/free_motions.h"

#include <Eigen/Eigenvalues>
#include <numeric>

#include <vasorod/error.h>

#include "data/index.h"

namespace vasorod {
namespace {

// Per body, the lowest index among the bodies joined to it by seams, directly or through others.
std::vector<int> joined_groups(const BodyProblem& surfaces) {
  std::vector<int> group(surfaces.bodies.size());
  std::iota(group.begin(), group.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const SeamPair& seam : surfaces.seams) {
      int &a = group[index(seam.body_a)], &b = group[index(seam.body_b)];
      if (a == b) continue;
      a = b = std::min(a, b);
      changed = true;
    }
  }
  return group;
}

// Adds the fixed directions as rows (v, u) of twists about the origin.
void add_rows(const std::vector<HeldSection>& sections, const Vec3& origin, double scale,
              Mat6& gram) {
  for (const HeldSection& section : sections) {
    const Mat3 frame = section.frame.value_or(section.rest.rotation);
    for (int k = 0; k < 6; ++k) {
      if (!section.fixed[index(k)]) continue;
      const Vec3 axis = frame.col(k % 3);
      Vec6 row;
      if (k < 3)
        row << axis, ((section.rest.position - origin) / scale).cross(axis);
      else
        row << Vec3::Zero(), axis;
      gram += row * row.transpose();
    }
  }
}

}  // namespace

void check_free_motions(const std::string& name, const Points& rest,
                        const std::vector<HeldSection>& sections) {
  const Vec3 origin = rest.colwise().mean().transpose();
  const double scale = (rest.colwise().maxCoeff() - rest.colwise().minCoeff()).norm();
  Mat6 gram = Mat6::Zero();
  add_rows(sections, origin, scale, gram);
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(gram);
  if (eigen.eigenvalues()[0] > 1e-12 * std::max(1e-300, eigen.eigenvalues()[5])) return;
  Vec6 motion = eigen.eigenvectors().col(0);
  // The point named in the message is in the coordinates of the scene.
  motion.head<3>() -= Vec3(motion.tail<3>()).cross(origin / scale);
  throw InputError("vessel " + name + ": nothing stops its wall's rigid motion, a " +
                   describe_rigid_motion(motion, scale) + "; expected ends that hold it");
}

void check_free_motions(const CoupledProblem& problem, const ScaledBodies& scaled) {
  const auto& bodies = problem.surfaces.bodies;
  const std::vector<int> group = joined_groups(problem.surfaces);
  for (size_t b = 0; b < bodies.size(); ++b) {
    if (!scaled.bodies[b].modelled) continue;
    std::vector<HeldSection> sections;
    for (size_t other = 0; other < bodies.size(); ++other)
      if (group[other] == group[b] && problem.vessels[other]) {
        const auto& more = problem.vessels[other]->sections;
        sections.insert(sections.end(), more.begin(), more.end());
      }
    check_free_motions(bodies[b].name, bodies[b].rest.points, sections);
  }
}

}  // namespace vasorod
