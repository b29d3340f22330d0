// Limits of the rod solver: prints the table of docs/rod.md. Every case must end certified or with
// a named cause; a non-finite value ends the program with exit code 1.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <random>
#include <string>

#include <vasorod/error.h>

#include "../chain.h"

namespace {

using namespace vasorod;
using namespace vasorod::bench;
constexpr double pi = std::numbers::pi;

struct Group {
  std::string name, range;
  int cases = 0, certified = 0, not_finite = 0, most_iterations = 0;
  std::string slowest;
  std::map<std::string, int> other;
  double seconds = 0;

  void run(const std::string& what, const RodTree& tree, const RodConditions& conditions) {
    ++cases;
    RodOptions options;
    options.time_limit = 60;
    try {
      const std::clock_t began = std::clock();
      const RodSolution s = solve_rod(tree, conditions, options);
      seconds += static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
      bool finite = std::isfinite(s.summary.energy) && std::isfinite(s.summary.residual);
      for (const Pose& p : s.poses)
        finite = finite && p.position.allFinite() && p.rotation.allFinite();
      not_finite += !finite;
      if (s.summary.iterations > most_iterations) {
        most_iterations = s.summary.iterations;
        slowest = what;
      }
      if (s.summary.status == Status::converged || s.summary.status == Status::buckled)
        ++certified;
      else
        ++other[to_string(s.summary.status) + " (" + what + ": " + s.summary.message + ")"];
    } catch (const InputError& e) {
      ++other[std::string("refused: ") + e.what()];
    }
  }

  void print() const {
    std::printf("| %s | %s | %d | %d | %d (%s) | %.3f |", name.c_str(), range.c_str(), cases,
                certified, most_iterations, slowest.c_str(), seconds);
    std::string causes;
    for (const auto& [cause, count] : other)
      causes += (causes.empty() ? "" : "; ") + std::to_string(count) + " " + cause;
    std::printf(" %s |\n", causes.empty() ? "-" : causes.c_str());
    std::fflush(stdout);
  }
};

std::string number(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// The 45 degree bend with a given wire under a load of 7.2 times the smaller of E I and G J over
/// R^2.
void bend(Group& group, const std::string& what, double radius, const Mat6& c, int elements) {
  const RodTree tree = chain(radius * pi / 4, {0, 1 / radius, 0}, elements, c);
  group.run(what, tree,
            cantilever(tree, {0, 7.2 * std::min(c(3, 3), c(5, 5)) / (radius * radius), 0}));
}

/// Both ends clamped; the far end is rotated and moved.
void pose(Group& group, const std::string& what, const RodTree& tree, const Vec3& rotate,
          const Vec3& move) {
  RodConditions conditions;
  const int last = tree.branches[0].nodes.back();
  conditions.supports = {clamp(0), clamp(last)};
  conditions.supports[1].motion = {rotate, move};
  group.run(what, tree, conditions);
}

Vec3 direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Vec3 v;
  do v = {normal(random), normal(random), normal(random)};
  while (v.norm() < 1e-3);
  return v.normalized();
}

}  // namespace

int main() {
  std::printf(
      "| what | range | cases | certified | most iterations | processor seconds | other endings "
      "|\n|---|---|---|---|---|---|---|\n");
  std::vector<Group> groups;
  const auto group = [&](const std::string& name, const std::string& range,
                         const std::function<void(Group&)>& cases) {
    Group g{name, range, 0, 0, 0, 0, "", {}, 0};
    cases(g);
    g.print();
    groups.push_back(g);
  };

  group("slenderness, load", "10 to 1e6", [](Group& g) {
    for (int e = 1; e <= 6; ++e)
      bend(g, number("L/d 1e%.0f", e), 100, round_wire(100 * std::pow(10, -e), 1, .5), 64);
  });
  group("slenderness, end pose", "10 to 1e6; 60, 120, 170 degrees", [](Group& g) {
    for (int e = 1; e <= 6; ++e)
      for (const double deg : {60., 120., 170.}) {
        const RodTree tree = chain(1, Vec3::Zero(), 64, round_wire(std::pow(10, -e), 1, .4));
        pose(g, number("L/d 1e%.0f", e) + number(", %.0f degrees", deg), tree,
             Vec3(1, 1, .3).normalized() * deg * pi / 180, deg / 60 * Vec3(.05, .1, -.2));
      }
  });
  group("moduli, load", "E, G and both by 1e-6 to 1e6", [](Group& g) {
    for (int e = -6; e <= 6; ++e) {
      const double f = std::pow(10, e);
      bend(g, number("E x 1e%.0f", e), 100, round_wire(5, f, .4), 32);
      bend(g, number("G x 1e%.0f", e), 100, round_wire(5, 1, .4 * f), 32);
      bend(g, number("both x 1e%.0f", e), 100, round_wire(5, f, .4 * f), 32);
    }
  });
  group("moduli, end pose", "E, G and both by 1e-6 to 1e6", [](Group& g) {
    for (int e = -6; e <= 6; ++e) {
      const double f = std::pow(10, e);
      for (const auto& [what, ef, gf] :
           {std::tuple{"E x 1e%.0f", f, 1.}, {"G x 1e%.0f", 1., f}, {"both x 1e%.0f", f, f}})
        pose(g, number(what, e), chain(1, Vec3::Zero(), 32, round_wire(.05, ef, .4 * gf)),
             Vec3(1, 1, .3).normalized() * pi / 3, {.05, .1, -.2});
    }
  });
  group("elements, load", "1 to 1e5", [](Group& g) {
    for (const int n : {1, 2, 3, 5, 10, 100, 1000, 10000, 100000})
      bend(g, number("%.0f elements", n), 100, round_wire(1, 1, .4), n);
  });
  group("elements, end pose", "1 to 1e5", [](Group& g) {
    for (const int n : {1, 2, 3, 5, 10, 100, 1000, 10000, 100000})
      pose(g, number("%.0f elements", n), chain(1, Vec3::Zero(), n, round_wire(.01, 1, .4)),
           Vec3(1, 1, .3).normalized() * pi / 3, {.05, .1, -.2});
  });
  group("random end poses",
        "up to 179 degrees about random axes, offsets up to 0.8 L, slenderness 10 to 1e4",
        [](Group& g) {
          std::mt19937_64 random(20090915);
          std::uniform_real_distribution<double> unit(0, 1);
          for (int i = 0; i < 300; ++i) {
            const double angle = unit(random) * 179 * pi / 180, offset = 0.8 * unit(random);
            const double slenderness = std::pow(10, 1 + 3 * unit(random));
            const Vec3 axis = direction(random);
            Vec3 move = offset * direction(random);
            // the far end stays within the rod's length of the clamp; otherwise this would be a
            // tension test
            if ((Vec3(0, 0, 1) + move).norm() > 1) move *= -1;
            pose(g, number("case %.0f", i),
                 chain(1, Vec3::Zero(), 40, round_wire(1 / slenderness, 1, .4)), angle * axis,
                 move);
          }
        });
  group("turns of twist", "1 to 10, pulled by 2 %", [](Group& g) {
    for (int turns = 1; turns <= 10; ++turns)
      pose(g, number("%.0f turns", turns), chain(1, Vec3::Zero(), 100, round_wire(.02, 1, .4)),
           {0, 0, 2 * pi * turns}, {0, 0, .02});
  });
  group("turns of twist, slack", "1 to 10, ends brought together by 10 %", [](Group& g) {
    for (int turns = 1; turns <= 10; ++turns)
      pose(g, number("%.0f turns", turns), chain(1, Vec3::Zero(), 100, round_wire(.02, 1, .4)),
           {0, 0, 2 * pi * turns}, {0, 0, -.1});
  });
  group("rest curvature", "an arc of 30 degrees to a closed ring, loaded and moved", [](Group& g) {
    for (int deg = 30; deg <= 360; deg += 30) {
      const RodTree tree = chain(1, {0, deg * pi / 180, 0}, 64, round_wire(.02, 1, .4));
      g.run(number("%.0f degrees, load", deg), tree,
            cantilever(tree, {0, 3 * tree.elements[0].stiffness(3, 3), 0}));
      pose(g, number("%.0f degrees, pose", deg), tree, {.5, .3, .2}, {.05, .1, -.1});
    }
  });
  group("straightened and curled", "natural curvature 0 to a ring, drawn the other way",
        [](Group& g) {
          for (int deg = 30; deg <= 360; deg += 30) {
            RodTree tree = chain(1, Vec3::Zero(), 64, round_wire(.02, 1, .4));
            for (RodElement& e : tree.elements) e.natural_strain[4] = deg * pi / 180;
            g.run(number("%.0f degrees", deg), tree, cantilever(tree, Vec3::Zero()));
          }
        });
  group("trees", "50 branches at one rod, depth 20, loaded, ends moved, many ends held",
        [](Group& g) {
          RodTree comb;
          int node = 0;
          std::vector<int> tips;
          for (int i = 0; i < 50; ++i) {
            node = append(comb, node, Pose{}, .2, Vec3::Zero(), 2, round_wire(.5, 1, .4));
            Pose aside;
            aside.rotation = exp_rotation(Vec3(std::cos(i), std::sin(i), 0) * 1.2);
            tips.push_back(append(comb, node, aside, .8, {.3, 0, 0}, 4, round_wire(.1, 1, .4)));
          }
          RodConditions conditions;
          conditions.supports = {clamp(0)};
          for (const int tip : tips)
            conditions.loads.push_back({tip, {1e-7, 2e-7, -1e-7}, Vec3::Zero(), false});
          g.run("comb of 50", comb, conditions);
          conditions.loads.clear();
          for (std::size_t i = 0; i < tips.size(); i += 5) {
            conditions.supports.push_back(clamp(tips[i]));
            const auto t = static_cast<double>(i);
            conditions.supports.back().motion = {{.3 * std::cos(t), .2, .3 * std::sin(t)},
                                                 {.02, .05 * std::sin(t), -.05}};
          }
          g.run("comb of 50, 10 tips moved", comb, conditions);
          conditions.supports.resize(1);
          RodTree deep;
          std::vector<int> ends{append(deep, 0, Pose{}, 1, Vec3::Zero(), 4, round_wire(.2, 1, .4))};
          int deepest = ends[0];
          for (int i = 0; i < 20; ++i) {
            Pose left, right;
            left.rotation = exp_rotation({.5, .1 * i, 0});
            right.rotation = exp_rotation({-.6, 0, .2 * i});
            const double width = .2 * std::pow(.9, i);
            ends.push_back(
                append(deep, deepest, right, .5, Vec3::Zero(), 3, round_wire(.7 * width, 1, .4)));
            deepest = append(deep, deepest, left, .7, {0, .2, 0}, 4, round_wire(width, 1, .4));
          }
          conditions.loads.clear();
          for (const int tip : ends)
            conditions.loads.push_back({tip, {0, 1e-8, 0}, Vec3::Zero(), false});
          g.run("depth 20", deep, conditions);
          conditions.supports.push_back(clamp(deepest));
          conditions.supports[1].motion = {{0, .5, .2}, {.3, .2, -.1}};
          conditions.loads.pop_back();
          g.run("depth 20, end moved", deep, conditions);
        });
  group("sections tapering by 100", "diameter 1 to 0.01 and back, load and end pose", [](Group& g) {
    for (const bool reversed : {false, true}) {
      RodTree tree = chain(10, Vec3::Zero(), 64, round_wire(1, 1, .4));
      for (std::size_t i = 0; i < 64; ++i) {
        const double t = (static_cast<double>(i) + .5) / 64;
        tree.elements[i].stiffness = round_wire(std::pow(100, reversed ? t - 1 : -t), 1, .4);
      }
      const std::string way = reversed ? "widening" : "narrowing";
      g.run(way + ", load", tree, cantilever(tree, {0, 1e-10, 0}));
      pose(g, way + ", pose", tree, {.6, .5, .2}, {.5, 1, -2});
    }
  });
  group("size", "lengths of 1e-6, 1 and 1e6; load and end pose", [](Group& g) {
    for (const double size : {1e-6, 1., 1e6}) {
      bend(g, number("%g, load", size), size, round_wire(.05 * size, 1, .4), 32);
      pose(g, number("%g, pose", size),
           chain(size, Vec3::Zero(), 32, round_wire(.05 * size, 1, .4)), {.6, .5, .2},
           size * Vec3(.05, .1, -.2));
    }
  });

  int cases = 0, certified = 0, not_finite = 0, named = 0;
  for (const Group& g : groups) {
    cases += g.cases;
    certified += g.certified;
    not_finite += g.not_finite;
    for (const auto& [cause, count] : g.other) named += count;
  }
  std::printf(
      "\n%d cases: %d certified (%.1f %%), %d ended with another named status, %d not finite.\n",
      cases, certified, 100. * certified / cases, named, not_finite);
  return not_finite > 0;
}
