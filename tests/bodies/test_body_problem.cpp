#include <gtest/gtest.h>
#include <set>

#include <vasorod/error.h>

#include "bodies/body_problem.h"

namespace vasorod {
namespace {

BodyProblem problem_of(const std::vector<bool>& obstacles) {
  BodyProblem problem;
  for (const bool obstacle : obstacles) problem.bodies.emplace_back().obstacle = obstacle;
  return problem;
}

TEST(BodyProblem, EveryPairMayTouchButTwoObstacles) {
  const BodyProblem problem = problem_of({false, true, false, true, true});
  const auto pairs = all_contacts(problem.bodies);
  std::set<std::pair<int, int>> seen;
  for (const auto& [a, b] : pairs) {
    EXPECT_LT(a, b);
    EXPECT_FALSE(problem.bodies[static_cast<size_t>(a)].obstacle &&
                 problem.bodies[static_cast<size_t>(b)].obstacle);
    EXPECT_TRUE(seen.insert({a, b}).second);
  }
  EXPECT_EQ(pairs.size(), 10u - 3u);  // five take two, without three take two
  EXPECT_TRUE(all_contacts({}).empty());
  EXPECT_TRUE(all_contacts(problem_of({true, true}).bodies).empty());
}

TEST(BodyProblem, ObstaclesDoNotTouchThemselves) {
  BodyProblem problem = problem_of({false, true, false});
  problem.contacts = self_contacts(problem.bodies);
  EXPECT_EQ(problem.contacts, (std::vector<std::pair<int, int>>{{0, 0}, {2, 2}}));
  EXPECT_FALSE(problem.may_meet());
  problem.contacts.emplace_back(0, 1);
  EXPECT_TRUE(problem.may_meet());
}

TEST(BodyProblem, AContactNamesBodiesThatExist) {
  BodyProblem problem = problem_of({false, false, true});
  problem.contacts = {{0, 1}, {2, 0}};
  EXPECT_NO_THROW(check_contacts(problem));
  for (const auto& wrong : {std::pair{0, 3}, std::pair{-1, 2}, std::pair{3, 1}}) {
    problem.contacts = {{0, 1}, wrong};
    try {
      check_contacts(problem);
      ADD_FAILURE() << wrong.first << ' ' << wrong.second;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), "contact: found bodies " + std::to_string(wrong.first) +
                                               " and " + std::to_string(wrong.second) +
                                               ", expected 0 to 2");
    }
  }
}

}  // namespace
}  // namespace vasorod
