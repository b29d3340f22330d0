// The block elimination compared with a Newton step by a dense matrix, which is built from the
// tested element derivatives.
#include <Eigen/Dense>
#include <array>
#include <gtest/gtest.h>

#include "rod/elimination.h"
#include "rod/energy.h"
#include "rod/rods.h"
#include "rod/strains.h"

namespace vasorod {
namespace {

// Trunk and two branches, deformed and stressed, with a full stiffness; nodes are parents first.
struct Fixture {
  RodTree tree;
  std::vector<Pose> poses;
  std::vector<RodLink> links;
  std::vector<Vec6> strain, stress;
  Fixture() {
    const Vec6 c = vec6(40, 50, 90, 1, 2, 1.5);
    append(tree, Pose{}, 0, 1, {0.2, 0.3, 0.1}, 2, c);
    append(tree, tree.rest[2], 2, 0.8, {0, -0.5, 0}, 2, c);
    append(tree, tree.rest[2], 2, 0.7, {1, 0, 0.4}, 2, c);
    for (std::size_t i = 0; i < tree.rest.size(); ++i) {
      const auto x = static_cast<double>(i);
      poses.push_back(tree.rest[i] * exp_motion(0.1 * vec6(std::sin(x), std::cos(2 * x), 0.3,
                                                           std::sin(3 * x), -0.6, std::cos(x))));
    }
    for (RodElement& e : tree.elements) {
      e.stiffness(0, 3) = e.stiffness(3, 0) = 0.7;
      e.stiffness(2, 5) = e.stiffness(5, 2) = -1.1;
      RodLink link;
      link.parent = e.first;
      link.length = e.length;
      link.natural = e.length * e.natural_strain;
      link.stiffness = e.stiffness / e.length;
      links.push_back(link);
      strain.push_back(e.length * element_strain(e, poses[index(e.first)], poses[index(e.second)]));
      stress.push_back(vec6(0.5, -0.3, 1.0, 0.2, 0.1, -0.4) * (1 + static_cast<double>(e.second)));
    }
  }
};

// Dense step in space-axes node twists: B^T (C/L)(B z + eps) + G(stress) z = loads, with fixed
// degrees of freedom removed.
Eigen::VectorXd dense_step(const Fixture& f, const std::vector<bool>& held,
                           const Eigen::VectorXd& load, const Eigen::MatrixXd& node_terms,
                           int* negative) {
  const int n = static_cast<int>(f.poses.size());
  Eigen::MatrixXd h = node_terms;
  Eigen::VectorXd g = -load;
  for (const RodElement& e : f.tree.elements) {
    const std::size_t k = index(e.second) - 1;
    const Pose &first = f.poses[index(e.first)], &second = f.poses[index(e.second)];
    const Mat12 local = element_energy_hessian(e, first, second, f.stress[k]);
    const Vec12 gradient = element_energy_gradient(e, first, second);
    Mat12 turn = Mat12::Zero();  // space axes -> body axes of each node
    for (int b = 0; b < 4; ++b)
      turn.block<3, 3>(3 * b, 3 * b) = (b < 2 ? first : second).rotation.transpose();
    const Mat12 space = turn.transpose() * local * turn;
    const Vec12 force = turn.transpose() * gradient;
    const int at[2] = {6 * e.first, 6 * e.second};
    for (int a = 0; a < 2; ++a) {
      g.segment<6>(at[a]) += force.segment<6>(6 * a);
      for (int b = 0; b < 2; ++b) h.block<6, 6>(at[a], at[b]) += space.block<6, 6>(6 * a, 6 * b);
    }
  }
  std::vector<int> open;
  for (int i = 0; i < 6 * n; ++i)
    if (!held[index(i)]) open.push_back(i);
  const Eigen::MatrixXd reduced = h(open, open);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(6 * n);
  step(open) = -reduced.partialPivLu().solve(g(open).eval());
  *negative = static_cast<int>(
      (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(reduced).eigenvalues().array() < 0).count());
  return step;
}

TEST(Elimination, IsTheDenseNewtonStepAndItsInertia) {
  for (const double size : {1., 30., -60.}) {  // the last two make the Hessian indefinite
    Fixture f;
    for (Vec6& s : f.stress) s *= size;
    NodeCondition root, tip, pin;
    root.node = 0;
    root.fixed.fill(true);
    root.target = f.poses[0];
    tip.node = 4;
    tip.force = {0.3, -0.2, 0.5};
    pin.node = 6;
    pin.fixed = {true, false, true, false, false, false};
    pin.target = f.poses[6];
    pin.carried << 0.4, 0.1, -0.2, 0, 0, 0;
    RodElimination elimination(f.links, {root, tip, pin});
    elimination.factor(f.poses, f.strain, f.stress);
    std::vector<Vec6> step, stress, stretch;
    elimination.solve(step, stress, stretch);

    const int n = static_cast<int>(f.poses.size());
    std::vector<bool> held(index(6 * n), false);
    for (int i = 0; i < 6; ++i) held[index(i)] = true;
    held[36] = held[38] = true;  // space axes: the pin's frame is the identity
    Eigen::VectorXd load = Eigen::VectorXd::Zero(6 * n);
    load.segment<3>(24) = tip.force;
    Eigen::MatrixXd terms = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    const auto dead = [&](int node, const Vec3& force) {
      terms.block<3, 3>(6 * node + 3, 6 * node) = 0.5 * hat(force);
      terms.block<3, 3>(6 * node, 6 * node + 3) = -0.5 * hat(force);
    };
    dead(4, tip.force);
    dead(6, pin.carried.head<3>());
    int negative = 0;
    const Eigen::VectorXd expected = dense_step(f, held, load, terms, &negative);
    for (int i = 0; i < n; ++i)
      EXPECT_LT((step[index(i)] - expected.segment<6>(6 * i)).norm(), 1e-11 * expected.norm())
          << size << ' ' << i;
    EXPECT_EQ(elimination.negative_directions(), negative) << size;
    if (size != 1) {
      EXPECT_GT(negative, 0);
    }
  }
}

// Reactions as unknowns: two branches held at their ends meet in a junction; one of them is also
// held halfway. More than six reactions then arrive at a node, and some are eliminated there.
// Dense: fixed degrees of freedom are removed.
TEST(Elimination, SeveralSupportsAreTheDenseStepAndItsInertia) {
  for (const double size : {1., 30., -60.})
    for (const bool held_junction : {false, true}) {
      Fixture f;
      for (Vec6& s : f.stress) s *= size;
      std::vector<NodeCondition> conditions(held_junction ? 5 : 4);
      const int nodes[] = {0, 4, 6, 5, 2};
      const std::array<bool, 6> fixed[] = {{true, true, true, true, true, true},
                                           {true, true, true, true, true, true},
                                           {true, true, true, true, true, true},
                                           {true, false, true, false, false, false},
                                           {false, true, false, false, false, false}};
      const int n = static_cast<int>(f.poses.size());
      std::vector<bool> held(index(6 * n), false);
      for (std::size_t c = 0; c < conditions.size(); ++c) {
        conditions[c].node = nodes[c];
        conditions[c].fixed = fixed[c];
        conditions[c].target = f.poses[index(nodes[c])];
        for (int i = 0; i < 6; ++i) held[index(6 * nodes[c] + i)] = fixed[c][index(i)];
      }
      RodElimination elimination(f.links, conditions);
      elimination.factor(f.poses, f.strain, f.stress);
      std::vector<Vec6> step, stress, stretch;
      elimination.solve(step, stress, stretch);
      int negative = 0;
      const Eigen::VectorXd expected = dense_step(f, held, Eigen::VectorXd::Zero(6 * n),
                                                  Eigen::MatrixXd::Zero(6 * n, 6 * n), &negative);
      for (int i = 0; i < n; ++i)
        EXPECT_LT((step[index(i)] - expected.segment<6>(6 * i)).norm(), 1e-10 * expected.norm())
            << size << ' ' << held_junction << ' ' << i;
      EXPECT_EQ(elimination.negative_directions(), negative) << size << ' ' << held_junction;
    }
}

// A prescribed end that has not reached its target: the step moves it there and equals the dense
// step with the same prescribed motion.
TEST(Elimination, StepsOntoItsTargets) {
  Fixture f;
  NodeCondition root, tip;
  root.node = 0;
  root.fixed.fill(true);
  root.target = f.poses[0];
  tip.node = 4;
  tip.fixed.fill(true);
  const Vec6 way = vec6(0.01, -0.02, 0.03, 0.02, 0.01, -0.03);
  tip.target = {exp_rotation(way.tail<3>()) * f.poses[4].rotation,
                f.poses[4].position + way.head<3>()};
  RodElimination elimination(f.links, {root, tip});
  elimination.factor(f.poses, f.strain, f.stress);
  std::vector<Vec6> step, stress, stretch;
  elimination.solve(step, stress, stretch);
  EXPECT_LT((step[4] - way).norm(), 1e-13);
  // the junction's forces balance: the forces of the links on it add up to zero in the linearised
  // state
  const int n = static_cast<int>(f.poses.size());
  std::vector<bool> held(index(6 * n), false);
  for (int i = 0; i < 6; ++i) held[index(i)] = held[index(24 + i)] = true;
  // dense: moves the tip's prescribed step to the right-hand side
  int negative = 0;
  Eigen::MatrixXd none = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  std::vector<bool> only_root(index(6 * n), false);
  for (int i = 0; i < 6; ++i) only_root[index(i)] = true;
  // a very stiff spring to the target gives the same up to its compliance
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(6 * n);
  const double spring = 1e9;
  none.block<6, 6>(24, 24) = spring * Mat6::Identity();
  pull.segment<6>(24) = spring * way;
  const Eigen::VectorXd expected = dense_step(f, only_root, pull, none, &negative);
  for (int i = 0; i < n; ++i)
    EXPECT_LT((step[index(i)] - expected.segment<6>(6 * i)).norm(), 1e-5 * expected.norm()) << i;
}

TEST(Strains, AveragesKeepAConstantInEveryBranch) {
  const Fixture f;
  const std::vector<Vec6> strains = element_strains(f.tree, f.tree.rest);
  for (std::size_t e = 0; e < strains.size(); ++e)
    EXPECT_LT((strains[e] - f.tree.elements[e].rest_strain).norm(), 1e-13);
  for (const RodBranch& branch : f.tree.branches) {
    const std::vector<Vec6> nodes = branch_node_values(f.tree, branch, strains);
    ASSERT_EQ(nodes.size(), branch.nodes.size());
    for (const Vec6& node : nodes)
      EXPECT_LT((node - strains[index(branch.elements[0])]).norm(), 1e-13);
  }
  EXPECT_LT(element_stress(f.tree.elements[3], strains[3]).norm(), 1e-11);
}

}  // namespace
}  // namespace vasorod
