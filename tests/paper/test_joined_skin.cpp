#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "paper/bending_energy.h"
#include "paper/joined_skin.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr int around = 8, along = 5, ring = around * along;  // the last row begins at `ring`

// Two tubes end to end with a gap between, the first one bent a little; their rims joined, their
// far ends fixed.
BodyProblem two_tubes() {
  BodyProblem problem;
  for (int b = 0; b < 2; ++b) {
    SurfaceBody& body = problem.bodies.emplace_back();
    body.name = b == 0 ? "svc" : "rpa";
    body.rest = tube(2, 6, around, along);
    body.rest.points.col(2).array() += 7.0 * b;
    body.k = {1.0 + b, 0.5, 0};
    body.fixed.assign(static_cast<size_t>(body.rest.points.rows()), 0);
    for (int k = 0; k < around; ++k) body.fixed[static_cast<size_t>(b == 0 ? k : ring + k)] = 1;
  }
  const Carried carried = bent(problem.bodies[0].rest.points, 6, 0.2, 0.1, 1.05);
  problem.bodies[0].carried = carried.points;
  problem.bodies[0].rotations = carried.rotations;
  for (int k = 0; k < around; ++k) problem.seams.push_back({0, ring + k, 1, k});
  return problem;
}

// The energies that the seam is closed with.
double energy(const BodyProblem& problem, const std::vector<Points>& at) {
  double sum = 0;
  for (size_t b = 0; b < at.size(); ++b) {
    const SurfaceBody& body = problem.bodies[b];
    const auto n = static_cast<int>(body.rest.points.rows());
    const Umbrella umbrella(edges_of(body.rest.triangles), n);
    const std::vector<Mat3> rotations =
        body.rotations.empty() ? std::vector<Mat3>(static_cast<size_t>(n), Mat3::Identity())
                               : body.rotations;
    const Points& carried = body.carried.rows() > 0 ? body.carried : body.rest.points;
    sum += body.k.binding * (at[b] - carried).squaredNorm() +
           bending_energy(body.k.bending, umbrella, at[b],
                          carried_laplacian(umbrella, body.rest.points, rotations));
  }
  return sum;
}

TEST(JoinedSkin, WithoutASeamSectionsAreCarriedRigidly) {
  BodyProblem problem = two_tubes();
  problem.seams.clear();
  Work work;
  const std::vector<Points> skin = joined_skin(problem, &work);
  EXPECT_EQ(work.counts, Counts{}) << "nothing is solved";
  EXPECT_EQ(skin[0], problem.bodies[0].carried);
  EXPECT_EQ(skin[1], problem.bodies[1].rest.points);
}

TEST(JoinedSkin, TheSeamIsClosedAndFixedEndsStay) {
  const BodyProblem problem = two_tubes();
  Work work;
  const std::vector<Points> skin = joined_skin(problem, &work);
  // One linear problem: one matrix, one factor, all three components at once.
  EXPECT_EQ(work.counts.hessians, 1);
  EXPECT_EQ(work.counts.factorisations, 1);
  EXPECT_EQ(work.counts.solves, 1);
  EXPECT_EQ(work.counts.gradients, 0);
  EXPECT_GT(work.factor_seconds, 0) << "it is measured; how long is not tested";
  for (int k = 0; k < around; ++k) {
    EXPECT_EQ(skin[0].row(ring + k), skin[1].row(k));
    EXPECT_EQ(skin[0].row(k), problem.bodies[0].carried.row(k));
    EXPECT_EQ(skin[1].row(ring + k), problem.bodies[1].rest.points.row(ring + k));
  }
}

// Quadratic: at the minimum no admissible direction changes the energy to first order.
TEST(JoinedSkin, NothingAdmissibleIsCheaper) {
  const BodyProblem problem = two_tubes();
  const std::vector<Points> skin = joined_skin(problem);
  const double least = energy(problem, skin);
  ASSERT_GT(least, 1e-3);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::vector<Points> step;
    for (size_t b = 0; b < 2; ++b) {
      step.push_back(
          random_points(static_cast<int>(skin[b].rows()), 2 * seed + static_cast<unsigned>(b)));
      for (Eigen::Index i = 0; i < step[b].rows(); ++i)
        if (problem.bodies[b].fixed[static_cast<size_t>(i)]) step[b].row(i).setZero();
    }
    for (int k = 0; k < around; ++k) step[1].row(k) = step[0].row(ring + k);
    const auto along_step = [&](double t) {
      return energy(problem, {skin[0] + t * step[0], skin[1] + t * step[1]});
    };
    EXPECT_NEAR((along_step(1e-3) - along_step(-1e-3)) / 2e-3, 0, 1e-8 * least) << seed;
    EXPECT_GT(along_step(0.1), least);
  }
}

TEST(JoinedSkin, SpringsThatCannotCloseASeamAreRefused) {
  BodyProblem problem = two_tubes();
  problem.bodies[1].k.bending = 0;
  try {
    joined_skin(problem);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("vessel rpa: coefficients", 0), 0u) << error.what();
  }
}

}  // namespace
}  // namespace vasorod
