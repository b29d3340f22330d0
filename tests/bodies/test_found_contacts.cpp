#include <gtest/gtest.h>

#include "bodies/found_contacts.h"

namespace vasorod {
namespace {

// One vertex over one triangle in the plane z = 0, area 2, stiffness 10.
class OverATriangle : public FoundContacts {
 public:
  explicit OverATriangle(double settled) : FoundContacts(1, 1) { settled_ = settled; }
  void refresh(const Points&, const Points&, double) override {
    begin();
    add({0, {0, 1, 2}, Vec3::Constant(1. / 3), Vec3::UnitZ(), 0, 2, 10, 0}, 0);
    end();
  }
};

Points at(double height) {
  Points points(1, 3);
  points << 0.2, 0.2, height;
  return points;
}

Points triangle() {
  Points points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  return points;
}

TEST(FoundContacts, TheMultiplierBecomesThePressure) {
  OverATriangle contact(0);
  contact.refresh(at(0), triangle(), 1);
  EXPECT_EQ(FoundContacts::gap(contact.contacts()[0], at(-0.5), triangle()), -0.5);
  EXPECT_EQ(contact.update_multipliers(at(-0.5), triangle()), (std::pair{10.0, 10.0}));
  EXPECT_EQ(contact.contacts()[0].multiplier, 5);
  // At the next minimum the multiplier alone holds the gap closed.
  EXPECT_EQ(contact.update_multipliers(at(0), triangle()), (std::pair{0.0, 10.0}));
  contact.refresh(at(0), triangle(), 1);
  EXPECT_EQ(contact.contacts()[0].multiplier, 5);  // kept by the search
  EXPECT_EQ(contact.update_multipliers(at(1), triangle()), (std::pair{10.0, 0.0}));
  EXPECT_EQ(contact.contacts()[0].multiplier, 0);
}

// Within the settled gap the penalty carries what the multiplier lacks, but walls that are apart
// without pressure let go.
TEST(FoundContacts, WithinTheSettledGapTheMultiplierStays) {
  OverATriangle contact(0.1);
  contact.refresh(at(0), triangle(), 1);
  contact.update_multipliers(at(-0.5), triangle());
  EXPECT_EQ(contact.update_multipliers(at(-0.05), triangle()), (std::pair{0.0, 11.0}));
  EXPECT_EQ(contact.contacts()[0].multiplier, 5);
  EXPECT_EQ(contact.update_multipliers(at(0.05), triangle()), (std::pair{0.0, 9.0}));
  EXPECT_EQ(contact.contacts()[0].multiplier, 5);
  EXPECT_EQ(contact.update_multipliers(at(0.6), triangle()), (std::pair{10.0, 0.0}));
  EXPECT_EQ(contact.contacts()[0].multiplier, 0);
}

// What further updates would add to changes that become smaller by the same factor each.
TEST(FoundContacts, GoesOnWithTheLastChange) {
  OverATriangle contact(0);
  contact.refresh(at(0), triangle(), 1);
  EXPECT_EQ(contact.changes().before, 0);
  contact.update_multipliers(at(-0.5), triangle());
  EXPECT_EQ(contact.changes().last, 0);
  contact.refresh(at(0), triangle(), 1);
  contact.update_multipliers(at(-0.25), triangle());
  const FoundContacts::Changes changes = contact.changes();
  EXPECT_EQ(changes.before, 25);
  EXPECT_EQ(changes.last, 6.25);
  EXPECT_EQ(changes.product, 12.5);
  contact.go_on(1);
  EXPECT_EQ(contact.contacts()[0].multiplier, 10);
  EXPECT_EQ(contact.changes().before, 0);
  contact.refresh(at(0), triangle(), 1);
  EXPECT_EQ(contact.contacts()[0].multiplier, 10);  // kept by the search
  contact.update_multipliers(at(0.25), triangle());
  EXPECT_EQ(contact.changes().before, 0) << "what was added is no update";
  contact.go_on(10);
  EXPECT_EQ(contact.contacts()[0].multiplier, 0) << "nothing pulls";
}

// The same, which may be in the triangle as deep as it was found there.
class InATriangle : public FoundContacts {
 public:
  InATriangle() : FoundContacts(1, 1) {}
  void refresh(const Points& slave, const Points&, double) override {
    begin();
    const double height = slave(0, 2);
    add({0,
         {0, 1, 2},
         Vec3::Constant(1. / 3),
         Vec3::UnitZ(),
         allowed_depth(0, height),
         2,
         10,
         0,
         1},
        0);
    end();
  }
  double gap_at(double height) {
    refresh(at(height), triangle(), 1);
    return gap(contacts()[0], at(height), triangle());
  }
};

TEST(FoundContacts, WhatIsPartedMayStayAsDeepAsItsShareOfTheFirstDepth) {
  InATriangle contact;
  EXPECT_EQ(contact.gap_at(-0.8), -0.8);
  contact.start_parting();
  EXPECT_EQ(contact.gap_at(-0.8), 0);
  contact.allow(0.25);
  EXPECT_NEAR(contact.gap_at(-0.8), -0.6, 1e-15);
  EXPECT_NEAR(contact.gap_at(-0.2), 0, 1e-15);  // the first depth counts, not the present one
  contact.allow(0);
  EXPECT_EQ(contact.gap_at(-0.2), -0.2);
}

TEST(FoundContacts, HeldHereItHasNotSlid) {
  InATriangle contact;
  contact.refresh(at(0), triangle(), 1);
  Points slid = at(0);
  slid.row(0) += Eigen::RowVector3d(0.3, 0.4, 0);
  contact.hold_here(at(0), triangle());
  EXPECT_NEAR(FoundContacts::slip(contact.contacts()[0], slid, triangle()), 0.5, 1e-15);
  contact.hold_here(slid, triangle());
  EXPECT_NEAR(FoundContacts::slip(contact.contacts()[0], slid, triangle()), 0, 1e-15);
}

// Along the plane it slides by 3-4-5, across it only comes nearer.
TEST(FoundContacts, SlipIsTheMotionAlongThePlane) {
  OverATriangle contact(0);
  contact.refresh(at(0.1), triangle(), 1);
  ContactPoint sticking = contact.contacts()[0];
  sticking.held = Vec3(0.2 - 1. / 3, 0.2 - 1. / 3, 0.1);
  EXPECT_NEAR(FoundContacts::slip(sticking, at(-2), triangle()), 0, 1e-15);
  Points slid = at(-2);
  slid.row(0) += Eigen::RowVector3d(0.3, 0.4, 0);
  EXPECT_NEAR(FoundContacts::slip(sticking, slid, triangle()), 0.5, 1e-15);
  // Both together: nothing slides.
  EXPECT_NEAR(
      FoundContacts::slip(sticking, slid, triangle().rowwise() + Eigen::RowVector3d(0.3, 0.4, 0)),
      0, 1e-15);
}

}  // namespace
}  // namespace vasorod
