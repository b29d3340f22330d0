// Forked vessels whose ends are moved and turned: the walls that skin carries, and the centerlines
// that coupled takes from its walls.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/predict.h>

#include "edge_ratios.h"
#include "infant_anatomy.h"

namespace vasorod {
namespace {

struct MovedEnd {
  Vec3 near, move, rotate_deg;
};

Scene bundled(const std::string& name, double thickness, const std::vector<MovedEnd>& ends) {
  Scene scene;
  scene.name = name;
  VesselSpec vessel;
  vessel.name = name;
  vessel.surface = testing::infant_file(name);
  vessel.remesh = 0.8;
  vessel.wall = Wall{thickness, Material::isotropic(0.45, 0.45)};
  scene.vessels = {vessel};
  for (const MovedEnd& moved : ends) {
    EndCondition end;
    end.vessel = name;
    end.end = {EndSelector::Kind::near, moved.near};
    end.move = moved.move;
    end.rotate_deg = moved.rotate_deg;
    scene.ends.push_back(end);
  }
  return scene;
}

const Vec3 none = Vec3::Zero();

Scene one_branch() {
  return bundled("svc", 0.4,
                 {{{-9.2, 2.7, 31}, none, none}, {{-8.9, 1.9, -8}, {1.5, 0, 0.5}, {0, 8, 5}}});
}

// The right branch lifted and twisted.
Scene two_branches() {
  return bundled("pulmonary_artery", 0.45,
                 {{{10, -11, -12}, none, none},
                  {{24, 17, 0}, none, none},
                  {{-26, 12, -9.4}, {0, 0, 7}, {20, 0, 0}}});
}

// Every end but the root moved and turned.
Scene five_ends() {
  return bundled("aorta", 0.8,
                 {{{3, -1.6, -13}, none, none},
                  {{9.2, 22, -18}, {1.6, -0.8, 0}, {0, 0, 6}},
                  {{-1.5, 3.7, 32}, {-1.6, 0, 0}, {0, 6, 6}},
                  {{5.2, 7.6, 32}, {0, -1.2, 0}, {0, 0, 8}},
                  {{13, 12.5, 31}, {0.8, 1.2, 0}, {4, 0, -6}}});
}

std::array<double, 2> edges_of(const VesselResult& vessel) {
  return testing::edge_ratios(vessel.triangles, vessel.rest, vessel.current);
}

class Forks : public ::testing::TestWithParam<int> {
 protected:
  static Scene scene() {
    return GetParam() == 1 ? one_branch() : GetParam() == 2 ? two_branches() : five_ends();
  }
};
INSTANTIATE_TEST_SUITE_P(Branches, Forks, ::testing::Values(1, 2, 5));

// Where every vertex follows its own section, the walls tear along the border of two branches. The
// rods' strains are 0.06 with two branches and 0.10 with five ends, where the wall between two near
// forks takes three times the rod's.
TEST_P(Forks, SkinCarriesTheWallInOnePiece) {
  SolveOptions options;
  options.fidelity = "skin";
  const Result result = predict(scene(), options);
  ASSERT_EQ(result.status, Status::converged);
  const auto [least, largest] = edges_of(result.vessels.at(0));
  EXPECT_GT(least, GetParam() == 5 ? 0.74 : 0.9);
  EXPECT_LT(largest, GetParam() == 5 ? 1.4 : 1.1);
}

// The stretch of the centerline lies within that of the wall's edges, up to half a percent: a mean
// over a section's band lies between its extremes, and the band's own error is of second order in
// its width. A tube whose wall is strained by e has a curvature of e / R at most, and a shear of
// 2 e, since a shear g stretches by about g / 2. Twice as much bending is allowed, because the
// sections between a fork and the first whole one are not seen.
TEST_P(Forks, TheCenterlineOfCoupledFollowsTheWall) {
  SolveOptions options;
  options.fidelity = "coupled";
  const Result result = predict(scene(), options);
  ASSERT_EQ(result.status, Status::converged);
  const VesselResult& vessel = result.vessels.at(0);
  const auto [least, largest] = edges_of(vessel);
  const double strain = std::max(1 - least, largest - 1), margin = 0.005;
  const CenterlineResult& line = *vessel.centerline;
  for (const auto& nodes : line.lines)
    for (size_t k = 1; k < nodes.size(); ++k) {
      const int n = nodes[k], before = nodes[k - 1];
      const auto i = static_cast<size_t>(n);
      const Vec3 place = line.rest.row(n), u = line.u[i] - line.u0[i], v = line.v[i] - line.v0[i];
      const double stretch = (line.current.row(n) - line.current.row(before)).norm() /
                             (line.rest.row(n) - line.rest.row(before)).norm();
      EXPECT_GT(stretch, least - margin) << place.transpose();
      EXPECT_LT(stretch, largest + margin) << place.transpose();
      EXPECT_LT(u.head<2>().norm() * line.radius[i], 2 * strain) << place.transpose();
      EXPECT_LT(std::abs(u[2]) * line.radius[i] + v.head<2>().norm(), 2 * strain)
          << place.transpose();
    }
  EXPECT_TRUE(result.validity.in_range);
}

}  // namespace
}  // namespace vasorod
