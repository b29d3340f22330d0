// Solved joins: the seam closes, forces balance, parts add up to the whole, the seam's force is the
// energy's derivative, shell and solid agree.
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "reference_fem/join_solution.h"
#include "reference_fem/joined_tubes.h"

namespace vasorod::fem {
namespace {

JoinProblem problem_of(const std::string& text = joined_tubes_text) {
  return read_join(scene_of_text(text), std::nullopt);
}

JoinCells coarse(const JoinProblem& problem, int degree = 2, int layers = 0) {
  JoinCells cells = first_cells(problem, 2, 0, 1);
  cells.degree = degree;
  cells.layers = layers;
  return cells;
}

JoinSampling few_points(const JoinProblem& problem, const JoinCells& cells) {
  JoinSampling sampling = sampling_for(problem, cells);
  sampling.around = 12;
  sampling.seam = 96;
  return sampling;
}

JoinSolution solved(const JoinProblem& problem, const JoinCells& cells,
                    const StepperOptions& options = {}) {
  return solve_join(problem, cells, few_points(problem, cells), options);
}

Vec3 support(const JoinForces& forces) {
  return std::accumulate(
      forces.ends.begin(), forces.ends.end(), Vec3(Vec3::Zero()),
      [](const Vec3& sum, const JoinForces::End& end) { return Vec3(sum + end.force); });
}

/// Moment about the origin.
Vec3 moment(const JoinForces& forces) {
  Vec3 sum = Vec3::Zero();
  for (const JoinForces::End& end : forces.ends) sum += end.moment + end.center.cross(end.force);
  return sum;
}

TEST(JoinSolution, TheSeamClosesAndEveryForceBalances) {
  // no plane of symmetry: an uneven artery, the vein beside its axis
  std::string text = with(joined_tubes_text, "[-10, 0, 10.2]", "[-9, 0.3, 10.2]");
  text = with(text, "incision: [0, 0, 8]", "incision: [0, 0.3, 8]");
  text = with(text, "rotation_deg: 0", "rotation_deg: 10");
  const JoinProblem problem = problem_of(text);
  ASSERT_EQ(problem.copies(), 1);
  const JoinSolution s = solved(problem, coarse(problem));
  ASSERT_EQ(s.summary.status, PathStatus::complete);
  EXPECT_EQ(s.summary.positive_definite, true);
  EXPECT_LT((s.rim - s.lips).rowwise().norm().maxCoeff(), 1e-12);
  const double size = s.on_artery.ends[0].force.norm();
  EXPECT_GT(size, 1e-3);
  EXPECT_LT((support(s.on_vein) + s.on_vein.seam).norm(), 1e-7 * size);
  EXPECT_LT((support(s.on_artery) + s.on_artery.seam).norm(), 1e-7 * size);
  EXPECT_LT((moment(s.on_vein) + moment(s.on_artery)).norm(), 1e-6 * size);
  // the held ends stay where they are
  EXPECT_LT((s.vein.current - s.vein.rest).topRows(12).norm(), 1e-12);
  EXPECT_LT((s.artery.current - s.artery.rest).bottomRows(12).norm(), 1e-12);
}

TEST(JoinSolution, APartMirroredIsTheWhole) {
  JoinProblem problem = problem_of();
  ASSERT_EQ(problem.copies(), 4);
  const JoinCells cells = coarse(problem);
  const JoinSolution quarter = solved(problem, cells);
  for (const std::array<bool, 2> mirror :
       {std::array<bool, 2>{true, false}, {false, true}, {false, false}}) {
    problem.mirror = mirror;
    const JoinSolution whole = solved(problem, cells);
    ASSERT_EQ(whole.summary.status, PathStatus::complete);
    EXPECT_EQ(whole.summary.positive_definite, true);
    EXPECT_NEAR(quarter.summary.energy / whole.summary.energy, 1, 1e-7);
    EXPECT_LT((quarter.rim - whole.rim).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((quarter.vein.current - whole.vein.current).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT((quarter.artery.current - whole.artery.current).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(
        (quarter.artery.other_lip_current - whole.artery.other_lip_current).cwiseAbs().maxCoeff(),
        1e-6);
    ASSERT_EQ(quarter.on_artery.ends.size(), whole.on_artery.ends.size());
    for (std::size_t e = 0; e < 2; ++e) {
      const JoinForces::End &a = quarter.on_artery.ends[e], &b = whole.on_artery.ends[e];
      EXPECT_EQ(a.name, b.name);
      EXPECT_LT((a.force - b.force).norm(), 1e-6 * b.force.norm());
      EXPECT_LT((a.moment - b.moment).norm(), 1e-6 * b.moment.norm());
      EXPECT_LT((a.center - b.center).norm(), 1e-12);
    }
    EXPECT_LT((quarter.on_vein.seam - whole.on_vein.seam).norm(),
              1e-6 * whole.on_artery.ends[0].force.norm());
  }
}

// Closing the gaps does the work of the ties: dE/dt is the sum of the forces on the rim's nodes
// times what their gaps lose.
TEST(JoinSolution, TheSeamsForceIsTheEnergysDerivative) {
  const JoinProblem problem = problem_of();
  const JoinCells cells = coarse(problem);
  const JoinMesh mesh = make_join_mesh(problem, cells);
  std::vector<std::array<double, 3>> steps;  // load, energy, power
  StepperOptions options;
  options.stops = {0.49, 0.5, 0.51};
  options.on_step = [&](double load, const State&, const System::Assembly& assembly) {
    double power = 0;
    for (const SeamPair& pair : mesh.seam)
      power -= assembly.nodal.segment<3>(7 * pair.vein).dot(pair.gap);
    steps.push_back({load, assembly.energy, power});
  };
  solved(problem, cells, options);
  std::size_t k = 0;
  while (k < steps.size() && std::abs(steps[k][0] - 0.5) > 1e-9) ++k;
  ASSERT_LT(k + 1, steps.size());
  ASSERT_NEAR(steps[k + 1][0] - steps[k - 1][0], 0.02, 1e-9);
  const double slope = (steps[k + 1][1] - steps[k - 1][1]) / 0.02;
  EXPECT_GT(slope, 1e-4);
  EXPECT_NEAR(steps[k][2] / slope, 1, 1e-3);
}

// An elliptic hole instead of the slit: wider mouth, balanced, the quarter as the whole; a very
// thin one is a slit.
TEST(JoinSolution, AnEllipticHole) {
  JoinProblem problem = problem_of();
  const JoinSolution slit = solved(problem, coarse(problem, 3));
  ASSERT_TRUE(open_ellipse(problem, 2.594, 1.297));
  const JoinCells cells = coarse(problem, 3);
  const JoinSolution quarter = solved(problem, cells);
  ASSERT_EQ(quarter.summary.status, PathStatus::complete);
  EXPECT_LT((quarter.rim - quarter.lips).rowwise().norm().maxCoeff(), 1e-12);
  EXPECT_GT(quarter.rim.col(1).maxCoeff(), 2 * slit.rim.col(1).maxCoeff());
  EXPECT_LT(quarter.summary.energy, slit.summary.energy);
  EXPECT_LT((support(quarter.on_artery) + quarter.on_artery.seam).norm(),
            1e-7 * quarter.on_artery.ends[0].force.norm());
  problem.mirror = {false, true};
  const JoinSolution half = solved(problem, cells);
  EXPECT_NEAR(quarter.summary.energy / half.summary.energy, 1, 1e-7);
  EXPECT_LT((quarter.artery.current - half.artery.current).cwiseAbs().maxCoeff(), 1e-6);

  problem = problem_of();
  ASSERT_TRUE(open_ellipse(problem, problem.incision.length, 0.004));
  const JoinSolution thin = solved(problem, coarse(problem, 3));
  ASSERT_EQ(thin.summary.status, PathStatus::complete);
  EXPECT_NEAR(thin.summary.energy / slit.summary.energy, 1, 0.02);
  EXPECT_LT((thin.rim - slit.rim).rowwise().norm().maxCoeff(), 0.02);
}

// Other elements, other kinematics: a seam between the middles of thick edges is softer in the
// solid.
TEST(JoinSolution, SolidAndShellAgree) {
  const JoinProblem problem = problem_of();
  const JoinSolution shell = solved(problem, coarse(problem, 3)),
                     solid = solved(problem, coarse(problem, 3, 2));
  ASSERT_EQ(solid.summary.status, PathStatus::complete);
  EXPECT_NEAR(solid.summary.energy / shell.summary.energy, 1, 0.12);
  EXPECT_LT((solid.rim - solid.lips).rowwise().norm().maxCoeff(), 1e-12);
  EXPECT_LT(std::sqrt((solid.artery.current - shell.artery.current).squaredNorm() /
                      static_cast<double>(shell.artery.rest.rows())),
            0.02);
  EXPECT_LT((support(solid.on_vein) + solid.on_vein.seam).norm(),
            1e-7 * solid.on_artery.ends[0].force.norm());
}

TEST(JoinSolution, OtherEndConditionsActAsTheyDoOnTubes) {
  // The artery's end moves along its axis: the seam is drawn along and the ends answer with forces.
  const JoinProblem problem =
      problem_of(with(joined_tubes_text, "{vessel: artery, end: end, hold: true}",
                      "{vessel: artery, end: end, move: [0.4, 0, 0]}"));
  ASSERT_EQ(problem.mirror, (std::array<bool, 2>{false, false}));
  const JoinSolution s = solved(problem, coarse(problem));
  ASSERT_EQ(s.summary.status, PathStatus::complete);
  const JoinForces::End& end = s.on_artery.ends[1];
  EXPECT_LT((end.center - Vec3(5.2, 0, -1.1)).norm(), 1e-12);
  EXPECT_GT(end.force[0], 0.01);
  EXPECT_GT((s.rim.colwise().mean() - s.rim_rest.colwise().mean())[0], 0.02);
  EXPECT_LT((support(s.on_artery) + s.on_artery.seam).norm(), 1e-7 * end.force.norm());
}

TEST(JoinSolution, EndToEndTheSeamClosesAndEveryForceBalances) {
  const JoinProblem problem = problem_of(end_to_end_text);
  const JoinSolution s = solved(problem, coarse(problem));
  ASSERT_EQ(s.summary.status, PathStatus::complete);
  EXPECT_EQ(s.summary.positive_definite, true);
  EXPECT_LT((s.rim - s.lips).rowwise().norm().maxCoeff(), 1e-12);
  const double size = support(s.on_vein).norm();
  EXPECT_GT(size, 1e-3);
  EXPECT_LT((support(s.on_vein) + s.on_vein.seam).norm(), 1e-7 * size);
  EXPECT_LT((support(s.on_vein) + support(s.on_artery)).norm(), 1e-7 * size);
  EXPECT_LT((moment(s.on_vein) + moment(s.on_artery)).norm(), 1e-7 * size);
}

/// A uniform tube of two, turned by 10 degrees: G 2 pi R^3 t phi / L, the seam's hinge has nothing
/// to lose. Dimensionless: R = 1, E = 1.
TEST(JoinSolution, EndToEndARotationIsTheTorsionOfATwistedTube) {
  std::string text = with(end_to_end_text, "radius: 1.8, position: [0.2, 0, 8.5]",
                          "radius: 2, position: [0, 0, 8]");
  text = with(text, "young: 0.45", "young: 0.5");
  const JoinProblem problem = problem_of(text);
  JoinCells cells = coarse(problem, 3);
  const JoinSolution s = solved(problem, cells);
  ASSERT_EQ(s.summary.status, PathStatus::complete);
  const double t = 0.15, torque = 2 * M_PI * t * (1 + t * t / 4) / 2.8 * (M_PI / 18) / 8;
  EXPECT_NEAR(s.on_vein.ends[0].moment.z() / torque, 1, 0.01);
  EXPECT_NEAR(s.on_artery.ends[0].moment.z() / torque, -1, 0.01);
}

}  // namespace
}  // namespace vasorod::fem
