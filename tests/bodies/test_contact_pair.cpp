#include <gtest/gtest.h>

#include "bodies/contact_pair.h"
#include "geometry/triangle_surface.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Two parallel tubes of radius 1 along z; the second one's axis at x = distance.
TriangleSurface beside(double distance) {
  TriangleSurface t = tube(1, 6, 48, 40);
  t.points.col(0).array() += distance;
  return t;
}

double smallest_gap(const ContactPair& pair, const Points& slave, const Points& master) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& c : pair.contacts())
    smallest = std::min(smallest, pair.gap(c, slave, master));
  return smallest;
}

TEST(ContactPair, GapIsTheDistanceOfTheOuterWalls) {
  const TriangleSurface slave = beside(0), master = beside(2.5);
  ContactPair pair({slave, 0.1, {}}, {master, 0.2, {}}, 1);
  pair.refresh(slave.points, master.points, 1);
  EXPECT_NEAR(smallest_gap(pair, slave.points, master.points), 0.2,
              5e-3);  // facets lie inside the circle
  EXPECT_GE(smallest_gap(pair, slave.points, master.points), 0.2 - 1e-9);
}

// Half of the slave's thickness and a quarter of the master's count.
TEST(ContactPair, OnlyAShareOfTheThicknessCountsWhereTheCallerSaysSo) {
  const TriangleSurface slave = beside(0), master = beside(2.5);
  const auto all = [](const TriangleSurface& surface, double share) {
    return std::vector<double>(static_cast<size_t>(surface.points.rows()), share);
  };
  ContactPair whole({slave, 0.1, {}}, {master, 0.2, {}}, 1),
      part({slave, 0.1, all(slave, 0.5)}, {master, 0.2, all(master, 0.25)}, 1);
  whole.refresh(slave.points, master.points, 1);
  part.refresh(slave.points, master.points, 1);
  EXPECT_NEAR(smallest_gap(part, slave.points, master.points) -
                  smallest_gap(whole, slave.points, master.points),
              0.05 + 0.15, 1e-9);
}

// Edges of about 0.14: half an edge deep it is pushed out, five edges deep it came in through the
// mouth. Without a seam it is pushed out from there too. Where walls meet up to the seam, what is
// deeper than one and a half edges is none that they met.
TEST(ContactPair, WhatCameInThroughTheMouthIsNotPushedOut) {
  const TriangleSurface slave = beside(0), shallow = beside(1.93), deep = beside(1.2);
  const double edge = mean_edge_length(slave);
  const auto deepest = [&](const TriangleSurface& master, bool joined, bool meets = false) {
    // At rest they are apart.
    ContactPair pair({slave, 0, {}, joined, meets}, {beside(3), 0, {}, joined, meets}, 1);
    pair.refresh(slave.points, master.points, 1);
    return -smallest_gap(pair, slave.points, master.points);
  };
  EXPECT_NEAR(deepest(shallow, true), 0.07, 0.01);
  EXPECT_GT(deepest(deep, false), 4.5 * edge);
  EXPECT_LT(deepest(deep, true), 3.01 * edge);
  EXPECT_NEAR(deepest(shallow, true, true), 0.07, 0.01);
  EXPECT_LT(deepest(deep, true, true), 1.51 * edge);
}

// 0.5 and 1.3 edges deep: once sewn walls lie apart, what seems deep in them is mistaken; walls
// that no seam joins do not know it.
TEST(ContactPair, WhatSeemsDeepInWallsThatLieApartIsNotPushedOut) {
  const TriangleSurface slave = beside(0), shallow = beside(1.93), deep = beside(1.8);
  const double edge = mean_edge_length(slave);
  const auto deepest = [&](const TriangleSurface& master, bool joined) {
    ContactPair pair({slave, 0, {}, joined, true}, {beside(3), 0, {}, joined, true}, 1);
    pair.walls_are_parted();
    pair.refresh(slave.points, master.points, 1);
    return -smallest_gap(pair, slave.points, master.points);
  };
  EXPECT_NEAR(deepest(shallow, true), 0.07, 0.01);
  EXPECT_LE(deepest(deep, true), 0.6 * edge);
  EXPECT_GT(deepest(deep, true), 0);
  EXPECT_GT(deepest(deep, false), edge);
}

// With corners left out, a triangle is left out, unless walls meet up to the seam.
TEST(ContactPair, TrianglesBesideASeamCountWhereWallsMeetUpToIt) {
  const TriangleSurface slave = beside(0), master = beside(1.95);
  const std::vector<double> none(static_cast<size_t>(master.points.rows()), 0);
  ContactPair apart({slave, 0, {}, true}, {master, 0, none, true}, 1),
      meeting({slave, 0, {}, true, true}, {master, 0, none, true, true}, 1);
  apart.refresh(slave.points, master.points, 0.1);
  meeting.refresh(slave.points, master.points, 0.1);
  EXPECT_TRUE(apart.contacts().empty());
  EXPECT_FALSE(meeting.contacts().empty());
}

// What presses when its foot leaves the wall it met keeps its plane, once it is held; before, it is
// let go.
TEST(ContactPair, FromHoldOnWhatPressesKeepsItsPlane) {
  const TriangleSurface slave = beside(0), master = beside(2.05);
  Points pressed = slave.points;
  pressed.col(0).array() += 0.15;
  for (const bool held : {false, true}) {
    ContactPair pair({slave, 0, {}}, {master, 0, {}}, 10);
    pair.refresh(pressed, master.points, 0.1);
    pair.update_multipliers(pressed, master.points);
    if (held) pair.hold();
    pair.refresh(pressed, master.points, 0.1);
    const auto pressing = [&] {
      int count = 0;
      for (const ContactPoint& c : pair.contacts()) count += c.multiplier > 0 ? 1 : 0;
      return count;
    };
    const int before = pressing();
    ASSERT_GT(before, 0);
    // The master turned inside out by a mirror faces the same way as the slave.
    Points away = master.points;
    away.col(0) = 4.1 - away.col(0).array();
    pair.refresh(pressed, away, 0.1);
    EXPECT_EQ(pressing(), held ? before : 0);
  }
}

// Pressed 0.1 into each other with stiffness 10, then held: a slip of one edge takes a tangential
// force as large as the normal one, and walls that only come near do not stick.
TEST(ContactPair, FromHoldOnWhatPressesSticks) {
  const TriangleSurface slave = beside(0), master = beside(2.05);
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 10);
  Points pressed = slave.points;
  pressed.col(0).array() += 0.15;
  pair.refresh(pressed, master.points, 1);
  for (const ContactPoint& c : pair.contacts()) EXPECT_EQ(c.stick, 0);
  pair.hold();
  pair.refresh(pressed, master.points, 1);
  int sticking = 0, near = 0;
  for (const ContactPoint& c : pair.contacts()) {
    const double gap = FoundContacts::gap(c, pressed, master.points);
    EXPECT_NEAR(c.stick * mean_edge_length(slave), std::max(0.0, -10 * gap), 1e-12);
    (gap < 0 ? sticking : near) += 1;
    EXPECT_LT(FoundContacts::slip(c, pressed, master.points), 1e-12);
  }
  EXPECT_GT(sticking, 5);
  EXPECT_GT(near, 5);
  // Moved along the axis, which turns no normal.
  Points slid = pressed;
  slid.col(2).array() += 0.02;
  for (const ContactPoint& c : pair.contacts())
    EXPECT_NEAR(FoundContacts::slip(c, slid, master.points), 0.02, 1e-3);
}

TEST(ContactPair, WhatIsOutOfReachIsNotListed) {
  const TriangleSurface slave = beside(0), master = beside(5);
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 1);
  pair.refresh(slave.points, master.points, 1);
  EXPECT_TRUE(pair.contacts().empty());
}

// What was out of reach is looked at again when the walls may have come together, whichever moved.
TEST(ContactPair, AfterMovesItFindsWhatANewPairFinds) {
  const TriangleSurface slave = beside(0), master = beside(3.5);
  ContactPair pair({slave, 0.1, {}}, {master, 0.2, {}}, 1);
  for (int k = 0; k < 12; ++k) {
    Points a = slave.points, b = master.points;
    a.col(2).array() += 0.3 * k;
    a.col(0) += Eigen::VectorXd((0.03 * k * a.col(2).array().square() / 6).matrix());
    b.col(0).array() -= k < 8 ? 0.2 * k : 2.4 - 0.1 * k;
    b.col(1) += Eigen::VectorXd((0.1 * k * b.col(2).array().sin()).matrix());
    pair.refresh(a, b, 0.3);
    ContactPair fresh({slave, 0.1, {}}, {master, 0.2, {}}, 1);
    fresh.refresh(a, b, 0.3);
    ASSERT_EQ(pair.contacts().size(), fresh.contacts().size()) << k;
    for (size_t c = 0; c < fresh.contacts().size(); ++c) {
      EXPECT_EQ(pair.contacts()[c].slave, fresh.contacts()[c].slave);
      EXPECT_EQ(pair.contacts()[c].slack, fresh.contacts()[c].slack);
    }
    EXPECT_EQ(pair.swallowed(), fresh.swallowed());
    if (k >= 6 && k < 10) {
      EXPECT_GT(fresh.contacts().size(), 20u) << k;
    }
  }
}

TEST(ContactPair, OverlapAtRestCarriesNoPressureThereAndCountsFromThere) {
  const TriangleSurface slave = beside(0), master = beside(1.7);
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 1);
  pair.refresh(slave.points, master.points, 1);
  ASSERT_FALSE(pair.contacts().empty());
  const auto [change, sum] = pair.update_multipliers(slave.points, master.points);
  EXPECT_EQ(change, 0);
  EXPECT_EQ(sum, 0);
  Points deeper = slave.points;
  deeper.col(0).array() += 0.05;
  pair.refresh(deeper, master.points, 1);
  EXPECT_LT(smallest_gap(pair, deeper, master.points), -0.03);
  EXPECT_GT(smallest_gap(pair, deeper, master.points), -0.06);
  EXPECT_GT(pair.update_multipliers(deeper, master.points).second, 0);
}

// A flat vessel, thinner than the overlap: its far wall is also inside the other vessel and must
// not be pushed out through the near wall.
TEST(ContactPair, TheFarWallOfAVesselIsNotInContact) {
  TriangleSurface slave = beside(0);
  slave.points.col(0) *= 0.2;
  const TriangleSurface master =
      beside(1.15);  // its wall at x = 0.15 cuts the slave, x from -0.2 to 0.2
  Points deep = slave.points;
  deep.col(0).array() += 0.45;
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 1);
  pair.refresh(deep, master.points, 10);
  ASSERT_FALSE(pair.contacts().empty());
  for (const ContactPoint& c : pair.contacts())
    EXPECT_GT(slave.points(c.slave, 0), -0.1) << c.slave;
  EXPECT_GT(pair.swallowed(), 0);
}

TEST(ContactPair, WhatWentPastTheMiddleIsCounted) {
  const TriangleSurface slave = beside(0), master = beside(3);
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 1);
  Points shallow = slave.points, deep = slave.points;
  shallow.col(0).array() += 1.3;
  deep.col(0).array() += 2.6;
  pair.refresh(shallow, master.points, 1);
  EXPECT_EQ(pair.swallowed(), 0);
  pair.refresh(deep, master.points, 1);
  EXPECT_GT(pair.swallowed(), 100);
}

TEST(ContactPair, RimsAndExcludedVerticesAreLeftOut) {
  const TriangleSurface slave = beside(0);
  TriangleSurface master = beside(1.9);
  master.points.col(2).array() += 3;  // covers the upper half of the slave only
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 1);
  pair.refresh(slave.points, master.points, 1);
  ASSERT_FALSE(pair.contacts().empty());
  for (const ContactPoint& c : pair.contacts()) EXPECT_GT(slave.points(c.slave, 2), 2.8);

  std::vector<double> upper(static_cast<size_t>(slave.points.rows()), 1);
  for (int i = 0; i < slave.points.rows(); ++i)
    if (slave.points(i, 2) > 4) upper[static_cast<size_t>(i)] = 0;
  ContactPair without_slaves({slave, 0, upper}, {master, 0, {}}, 1);
  without_slaves.refresh(slave.points, master.points, 1);
  for (const ContactPoint& c : without_slaves.contacts()) EXPECT_LE(slave.points(c.slave, 2), 4);

  ContactPair without_masters({slave, 0, {}}, {master, 0, std::vector<double>(upper.size(), 0)}, 1);
  without_masters.refresh(slave.points, master.points, 1);
  EXPECT_TRUE(without_masters.contacts().empty());
}

TEST(ContactPair, MultipliersFollowThePressureAndSurviveARefresh) {
  const TriangleSurface slave = beside(0), master = beside(2);
  ContactPair pair({slave, 0, {}}, {master, 0, {}}, 5);
  Points pressed = slave.points;
  pressed.col(0).array() += 0.1;
  pair.refresh(pressed, master.points, 1);
  const double first = pair.update_multipliers(pressed, master.points).second;
  EXPECT_GT(first, 0);
  pair.refresh(pressed, master.points, 1);
  const auto [change, second] =
      pair.update_multipliers(pressed, master.points);  // the same gap again
  EXPECT_NEAR(second / first, 2, 1e-9);
  EXPECT_NEAR(change / first, 1, 1e-9);
  pair.refresh(slave.points.rowwise() - Eigen::RowVector3d(9, 0, 0), master.points, 1);
  pair.refresh(slave.points, master.points, 1);
  for (const ContactPoint& c : pair.contacts()) EXPECT_EQ(c.multiplier, 0);  // reset while apart
}

}  // namespace
}  // namespace vasorod
