#include <cmath>
#include <gtest/gtest.h>

#include "bodies/hairpin.h"
#include "bodies/self_contact.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

constexpr int around = 32, along = 12;
constexpr double radius = 5, thickness = 0.4;

TriangleSurface tube() {
  return tube_surface(testing::straight_tube(12, radius, around, along));
}

SelfContact contact_of(const TriangleSurface& rest, std::vector<double> share = {}) {
  return {ContactSide{rest, thickness / 2, std::move(share)}, thickness, 1};
}

// Pressed flat to half of `height` on each side of y = 0.
Points flattened(const TriangleSurface& rest, double height) {
  Points now = rest.points;
  now.col(1) *= height / (2 * radius);
  return now;
}

TEST(SelfContact, ARoundTubeTouchesNothing) {
  const TriangleSurface rest = tube();
  SelfContact contact = contact_of(rest);
  contact.refresh(rest.points, rest.points, 1);
  EXPECT_TRUE(contact.contacts().empty());
}

// Opposite walls of a flat lumen: the gap lies between the inner faces, and the normal points into
// the lumen.
TEST(SelfContact, OppositeWallsOfAFlatLumenFaceEachOtherInside) {
  const TriangleSurface rest = tube();
  for (const double height : {1.0, 0.3}) {
    SelfContact contact = contact_of(rest);
    const Points now = flattened(rest, height);
    contact.refresh(now, now, 1);
    ASSERT_FALSE(contact.contacts().empty());
    bool crown = false;
    for (const ContactPoint& c : contact.contacts()) {
      const Vec3 at = now.row(c.slave);
      if (std::abs(at.x()) > 0.1 * radius) continue;
      crown = true;
      EXPECT_NEAR(FoundContacts::gap(c, now, now), height - thickness, 0.03);
      EXPECT_NEAR(c.normal.y() * at.y(), std::abs(at.y()), 1e-3);  // away from the wall it meets
      EXPECT_NEAR(c.weight.sum(), 1, 1e-12);
    }
    EXPECT_TRUE(crown);
  }
}

// Walls of a flat lumen that have passed through each other by three edges: what is joined to
// another vessel comes to itself in small steps, so that these are no contacts of its own.
TEST(SelfContact, WhatIsJoinedIsNotPushedOutOfItselfFromDeepInside) {
  const TriangleSurface rest = tube();
  Points now = flattened(rest, 3);
  now.col(1) *= -1;
  for (const bool joined : {false, true}) {
    SelfContact contact(ContactSide{rest, thickness / 2, {}, joined}, thickness, 1);
    contact.refresh(now, now, 1);
    double deepest = 0;
    for (const ContactPoint& c : contact.contacts())
      deepest = std::min(deepest, FoundContacts::gap(c, now, now));
    if (joined)
      EXPECT_GT(deepest, -1.001 * mean_edge_length(rest));
    else
      EXPECT_LT(deepest, -3);
  }
}

// A tube bent to a hairpin: its two legs meet with their outer faces.
TEST(SelfContact, LegsOfAHairpinFaceEachOtherOutside) {
  const double length = 60, bend = 7;  // radius of the axis' bend
  const TriangleSurface rest = tube_surface(testing::straight_tube(length, radius, around, 60));
  const Points now = testing::hairpin(rest.points, length, bend);
  SelfContact contact = contact_of(rest);
  contact.refresh(now, now, 5);
  ASSERT_FALSE(contact.contacts().empty());
  double smallest = 1e9;
  for (const ContactPoint& c : contact.contacts())
    if (now(c.slave, 2) < -2 && std::abs(now(c.slave, 1)) < 0.1)  // where the legs are closest
      smallest = std::min(smallest, FoundContacts::gap(c, now, now));
  EXPECT_NEAR(smallest, 2 * (bend - radius) - thickness, 0.05);
}

// Walls that were carried through each other, by more than an edge and however they came there, are
// pushed back and not further on.
TEST(SelfContact, WallsThatPassedThroughEachOtherArePushedBack) {
  const TriangleSurface rest = tube();
  for (const double height : {-0.2, -1.5, -2.5}) {
    SelfContact contact = contact_of(rest);
    const Points after = flattened(rest, height);
    contact.refresh(after, after, 3);
    bool crown = false;
    for (const ContactPoint& c : contact.contacts()) {
      if (std::abs(after(c.slave, 0)) > 0.1 * radius) continue;
      crown = true;
      const double side = rest.points(c.slave, 1);
      EXPECT_NEAR(FoundContacts::gap(c, after, after), height - thickness, 0.04);
      EXPECT_NEAR(c.normal.y() * side, std::abs(side), 0.01);
    }
    EXPECT_TRUE(crown);
  }
}

// Where walls press on each other they stick, by the normal force over an edge; elsewhere not.
TEST(SelfContact, WallsThatPressStickUntilTheNextSearch) {
  const TriangleSurface rest = tube();
  SelfContact contact = contact_of(rest);
  const Points now = flattened(rest, 0.3);
  contact.refresh(now, now, 1);
  const double edge = mean_edge_length(rest);
  int pressed = 0, open = 0;
  for (const ContactPoint& c : contact.contacts()) {
    EXPECT_LT(contact_slip(c, now).norm(), 1e-14);
    const double pressure = contact_pressure(c, now);
    EXPECT_NEAR(c.stick, pressure / edge, 1e-12);
    (pressure > 0 ? pressed : open) += 1;
  }
  EXPECT_GT(pressed, 0);
  Points slid = now;
  for (Eigen::Index i = 0; i < slid.rows(); ++i)
    if (rest.points(i, 1) > 0) slid(i, 0) += 0.01;
  for (const ContactPoint& c : contact.contacts()) {
    if (std::abs(now(c.slave, 0)) > 0.1 * radius) continue;
    EXPECT_NEAR(contact_slip(c, slid).norm(), 0.01, 2e-3);
  }
  contact.refresh(slid, slid, 1);
  for (const ContactPoint& c : contact.contacts()) EXPECT_LT(contact_slip(c, slid).norm(), 1e-14);
}

// What presses and faces nothing at the next search keeps its plane, once it is held, for as long
// as it presses; before, it is let go.
TEST(SelfContact, FromHoldOnWhatPressesKeepsItsPlane) {
  const TriangleSurface rest = tube();
  const Points flat = flattened(rest, 0.3), &apart = rest.points;
  for (const bool held : {false, true}) {
    SelfContact contact = contact_of(rest);
    contact.refresh(flat, flat, 1);
    contact.update_multipliers(flat, flat);
    if (held) contact.hold();
    int pressing = 0;
    for (const ContactPoint& c : contact.contacts()) pressing += c.multiplier > 0 ? 1 : 0;
    ASSERT_GT(pressing, 5);
    contact.refresh(apart, apart, 1);
    ASSERT_EQ(contact.contacts().size(), held ? static_cast<size_t>(pressing) : 0u);
    for (const ContactPoint& c : contact.contacts()) {
      EXPECT_GT(c.multiplier, 0);
      EXPECT_GT(FoundContacts::gap(c, apart, apart), 1);
      EXPECT_EQ(FoundContacts::slip(c, apart, apart), 0);
    }
    contact.update_multipliers(apart, apart);
    contact.refresh(apart, apart, 1);
    EXPECT_TRUE(contact.contacts().empty());
  }
}

TEST(SelfContact, RimsAndWhatIsExcludedAreLeftOut) {
  const TriangleSurface rest = tube();
  std::vector<double> share(static_cast<size_t>(rest.points.rows()), 1);
  for (int i = 0; i < rest.points.rows(); ++i)
    if (rest.points(i, 2) > 6) share[static_cast<size_t>(i)] = 0;
  SelfContact contact = contact_of(rest, share);
  const Points now = flattened(rest, 0.3);
  contact.refresh(now, now, 1);
  ASSERT_FALSE(contact.contacts().empty());
  for (const ContactPoint& c : contact.contacts()) {
    EXPECT_LE(now(c.slave, 2), 6);
    EXPECT_GT(now(c.slave, 2), 0);
    for (const int v : c.master) EXPECT_GT(now(v, 2), 0);
  }
}

// One rim is a seam, up to which walls meet.
SelfContact contact_up_to_seam(const TriangleSurface& rest) {
  ContactSide side{rest, thickness / 2, {}, true, true, {}};
  for (int i = 0; i < rest.points.rows(); ++i)
    if (rest.points(i, 2) == 0) side.seam.push_back(i);
  EXPECT_EQ(side.seam.size(), static_cast<size_t>(around));
  return {std::move(side), thickness, 1};
}

// Its vertices count too.
TEST(SelfContact, TheRimOfASeamMeetsTheWallToo) {
  const TriangleSurface rest = tube();
  SelfContact contact = contact_up_to_seam(rest);
  const Points now = flattened(rest, 0.3);
  contact.refresh(now, now, 1);
  bool seam = false;
  for (const ContactPoint& c : contact.contacts()) {
    seam |= now(c.slave, 2) == 0;
    EXPECT_LT(now(c.slave, 2), 12);  // the other rim is left out
  }
  EXPECT_TRUE(seam);
}

// Not from deep inside: what closes the mouth of a fold may lie on either side of its own rim.
TEST(SelfContact, TheRimOfASeamIsNotPushedOutFromDeepInside) {
  const TriangleSurface rest = tube();
  for (const double height : {0.05, 0.3}) {
    SelfContact contact = contact_up_to_seam(rest);
    Points now = flattened(rest, height);
    now.col(1) *= -1;
    contact.refresh(now, now, 1);
    double seam = 0, beside = 0;
    for (const ContactPoint& c : contact.contacts()) {
      double& deepest = now(c.slave, 2) == 0 ? seam : beside;
      deepest = std::min(deepest, FoundContacts::gap(c, now, now));
    }
    EXPECT_NEAR(beside, -height - thickness, 0.03);
    if (height < 0.1)
      EXPECT_NEAR(seam, beside, 0.03);
    else
      EXPECT_GT(seam, -0.5 * mean_edge_length(rest));
  }
}

// Multipliers stay where the walls press on each other within the tolerance, and go where they
// part.
TEST(SelfContact, MultipliersFollowThePressure) {
  const TriangleSurface rest = tube();
  SelfContact contact = contact_of(rest);
  const Points pressed = flattened(rest, 0.3), apart = flattened(rest, 6);
  contact.refresh(pressed, pressed, 1);
  const auto [change, sum] = contact.update_multipliers(pressed, pressed);
  EXPECT_GT(sum, 0);
  EXPECT_EQ(change, sum);
  const auto [opened, left] = contact.update_multipliers(apart, apart);
  EXPECT_GT(opened, 0);
  EXPECT_EQ(left, 0);
}

}  // namespace
}  // namespace vasorod
