#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <utility>

#include "infant_anatomy.h"
#include "judge/judged_tube.h"
#include "judge/validity.h"

namespace vasorod {
namespace {

using shapes::change_of;
using shapes::judged_tube;
using shapes::strained;

Validity judged(const PreparedVessel& tube, const Vec6& change) {
  Validity validity;
  add_validity(tube, strained(tube.vessel.rod, change), {}, validity);
  return validity;
}

// R = 10, t = 1, nu = 0.3; L = 300 is long (Omega = 9.5), L = 100 is not (3.2).
TEST(Validity, LongTubesAreMeasuredAgainstBrazier) {
  const PreparedVessel tube = judged_tube(300);
  const double limit = 0.471 / (100 * std::sqrt(1 - 0.09));
  const Validity half = judged(tube, change_of(0, Vec3(0.3, 0.4, 0) * limit));
  EXPECT_NEAR(half.brazier_ratio, 0.5, 1e-8);
  EXPECT_TRUE(half.in_range);
  EXPECT_TRUE(half.warnings.empty());
  const Validity near = judged(tube, change_of(0, Vec3(0.8, 0, 0) * limit));
  EXPECT_TRUE(near.in_range);
  ASSERT_FALSE(near.warnings.empty());
  EXPECT_NE(near.warnings[0].find("vessel tube at ("), std::string::npos);
  const Validity past = judged(tube, change_of(0, Vec3(0.95, 0, 0) * limit));
  EXPECT_FALSE(past.in_range);
  EXPECT_NE(past.warnings[0].find("would kink there"), std::string::npos);
}

TEST(Validity, ShortTubesAreMeasuredAgainstLocalWrinkling) {
  const PreparedVessel tube = judged_tube(60);
  const Validity validity = judged(tube, change_of(0, Vec3(0, 0.004, 0)));
  EXPECT_EQ(validity.brazier_ratio, 0);
  EXPECT_NEAR(validity.wrinkling_ratio, 0.004 * 100 / 0.605, 1e-8);
}

// At p_c Brazier's curvature is raised by the root of 2; the moment pi R^3 t E k at which the inner
// side wrinkles by p pi R^3 / 2 (NASA SP-8007).
TEST(Validity, APressureFromInsideHoldsTheSectionOpenAndTheWallStretched) {
  PreparedVessel tube = judged_tube(300);
  const Material& material = tube.spec.wall->material;
  const double collapse = 3 * material.young_transverse / 12 / 0.91 / 1000;
  const Vec6 bent = change_of(0, Vec3(0.003, 0, 0));
  const Validity without = judged(tube, bent);
  const auto under = [&](double pressure) {
    tube.spec.pressure = LumenPressure{0, pressure};
    return judged(tube, bent);
  };
  EXPECT_NEAR(under(collapse).brazier_ratio, without.brazier_ratio / std::sqrt(2.0), 1e-8);
  EXPECT_NEAR(under(5 * collapse).brazier_ratio, without.brazier_ratio / std::sqrt(6.0), 1e-8);
  const double pressure = 0.002 * material.young_axial;
  const double moment = std::numbers::pi * 1000 * material.young_axial * 0.003,
               critical = std::numbers::pi * 100 * material.young_axial * 0.605 / 10;
  EXPECT_NEAR(under(pressure).wrinkling_ratio,
              moment / (critical + pressure * std::numbers::pi * 1000 / 2), 1e-8);
  EXPECT_NEAR(under(-0.5 * collapse).wrinkling_ratio, without.wrinkling_ratio, 1e-12);
  under(pressure);
  JudgedState unpressed;
  unpressed.pressed = false;
  Validity judged_without;
  add_validity(tube, strained(tube.vessel.rod, bent), unpressed, judged_without);
  EXPECT_EQ(judged_without.wrinkling_ratio, without.wrinkling_ratio);
  EXPECT_EQ(judged_without.brazier_ratio, without.brazier_ratio);
  EXPECT_NEAR(under(-0.5 * collapse).brazier_ratio, without.brazier_ratio * std::sqrt(2.0), 1e-8);
}

TEST(Validity, AFoldPastTheRangeOfALinearLawIsNamed) {
  PreparedVessel tube = judged_tube(100);
  const auto warnings = [&](double least, double largest) {
    FaceExtremes faces;
    faces.least = least;
    faces.largest = largest;
    faces.least_place = Vec3(1, 2, 3);
    faces.largest_place = Vec3(4, 5, 6);
    Validity validity;
    warn_of_law(tube.spec, faces, validity);
    EXPECT_TRUE(validity.in_range);
    return validity.warnings;
  };
  EXPECT_TRUE(warnings(0.81, 1.19).empty());
  ASSERT_EQ(warnings(0.38, 1.4).size(), 1U);
  EXPECT_EQ(
      warnings(0.38, 1.4)[0],
      "vessel tube at (1, 2, 3): a face of its wall is shortened by 62 %, past the 20 % up to "
      "which law biot holds: use law neo-hookean");
  EXPECT_NE(warnings(0.9, 1.4)[0].find("(4, 5, 6): a face of its wall is lengthened by 40 %"),
            std::string::npos);
  EXPECT_NE(warnings(-0.6, 1.4)[0].find("folded through itself"), std::string::npos);
  tube.spec.wall->material.law = Law::neo_hookean;
  EXPECT_TRUE(warnings(0.38, 1.4).empty());
}

// The smallest axial strain at which a cylinder with an axial fibre wrinkles: Donnell's linear
// equations, nu_LT = 0, over axial and circumferential waves.
double donnell_strain(double e_l, double e_t, double g, double radius, double t) {
  double least = std::numeric_limits<double>::infinity();
  const double scale = 1 / std::sqrt(radius * t), d = t * t * t / 12;
  for (double a = 0.02; a < 8; a += 0.02)
    for (double b = 0; b < 6; b += 0.02) {
      const double a2 = a * a * scale * scale, b2 = b * b * scale * scale;
      const double bending = d * (e_l * a2 * a2 + 4 * g * a2 * b2 + e_t * b2 * b2);
      const double membrane =
          t * a2 * a2 / (radius * radius) / (a2 * a2 / e_t + a2 * b2 / g + b2 * b2 / e_l);
      least = std::min(least, (bending + membrane) / (a2 * t * e_l));
    }
  return least;
}

// The constant is that of the isotropic wall, 0.605 with nu = 0.3; Donnell's is 3^(-1/2).
TEST(Validity, AFibreMovesTheWrinklingStrainAsDonnellHasIt) {
  for (const auto& [e_t, g] :
       {std::pair{0.5, 0.25}, {0.5, 0.02}, {0.5, 10.0}, {0.1, 0.005}, {4.0, 0.1}}) {
    PreparedVessel tube = judged_tube(60);
    tube.spec.wall->material = {Law::biot, 0.5, e_t, g, 0.3, 0};
    const double strain = donnell_strain(0.5, e_t, g, 10, 1) * 0.605 * std::sqrt(3.0);
    EXPECT_NEAR(judged(tube, change_of(0, Vec3(0, strain / 10, 0))).wrinkling_ratio, 1, 2e-3)
        << e_t << " " << g;
  }
}

// A transversely stiff section flattens later, by the square root, and wrinkles in twist later, by
// a power of 5/8.
TEST(Validity, AFibreMovesBrazierAndTwist) {
  PreparedVessel tube = judged_tube(300);
  const Vec6 change = change_of(0, Vec3(0.001, 0, 0.001));
  tube.spec.wall->material = {Law::biot, 0.5, 0.5, 0.5 / 2.6, 0.3, 0};
  const Validity before = judged(tube, change);
  tube.spec.wall->material.young_transverse = 16 * 0.5;
  const Validity after = judged(tube, change);
  EXPECT_NEAR(after.brazier_ratio * 4, before.brazier_ratio, 1e-12);
  EXPECT_NEAR(after.twist_ratio * std::pow(16, 0.625), before.twist_ratio, 1e-12);
}

TEST(Validity, TwistIsMeasuredAgainstTorsionalWrinkling) {
  const PreparedVessel tube = judged_tube();
  const double angle =
      20 * M_PI / 180;  // at t/R = 0.1, L/R = 10 a tube wrinkles at 20 degrees (nu = 0.3)
  const Validity validity = judged(tube, change_of(0, Vec3(0, 0, angle / 100)));
  EXPECT_NEAR(validity.twist_ratio, 1, 0.03);
  EXPECT_FALSE(validity.in_range);
}

TEST(Validity, StrainIsThatOfTheOuterFibre) {
  const PreparedVessel tube = judged_tube();
  EXPECT_NEAR(judged(tube, change_of(0.03, Vec3(0, 0.002, 0))).largest_strain, 0.03 + 0.002 * 10.5,
              1e-8);
  EXPECT_NEAR(judged(tube, change_of(0, Vec3(0, 0, 0.001))).largest_strain, 0.001 * 10.5, 1e-8);
}

TEST(Validity, UnitsDoNotMatter) {
  const double metre = 1e-3;
  const Vec3 u(0.002, 0.001, 0.003);
  const Validity mm = judged(judged_tube(300), change_of(0.01, u));
  const Validity m = judged(judged_tube(300, metre, 1e6), change_of(0.01, u / metre));
  EXPECT_NEAR(m.brazier_ratio, mm.brazier_ratio, 1e-9);
  EXPECT_NEAR(m.wrinkling_ratio, mm.wrinkling_ratio, 1e-9);
  EXPECT_NEAR(m.twist_ratio, mm.twist_ratio, 1e-9);
  EXPECT_NEAR(m.largest_strain, mm.largest_strain, 1e-9);
  EXPECT_EQ(m.warnings.size(), mm.warnings.size());
}

TEST(Validity, AModulusThatNoVesselHasIsAskedAbout) {
  const Units kilopascals{"mm", "kPa", 1e-3, 1e3}, pascals{"m", "Pa", 1, 1}, megapascals;
  VesselSpec vessel;
  vessel.name = "svc";
  const auto warnings = [&](double young, const Units& units) {
    vessel.wall = Wall{1, Material::isotropic(young, 0.3)};
    Validity validity;
    warn_of_units(vessel, units, validity);
    EXPECT_TRUE(validity.in_range);
    return validity.warnings;
  };
  EXPECT_EQ(warnings(0.5, kilopascals),
            std::vector<std::string>{"vessel svc: Young's modulus of 0.5 kPa is outside 0.01 to "
                                     "100 MPa, where vessels lie: are the units right?"});
  EXPECT_EQ(warnings(500, megapascals).size(), 1U);
  EXPECT_EQ(warnings(0.5, pascals).size(), 1U);
  for (const auto& [young, units] : {std::pair{0.01, megapascals},
                                     {100.0, megapascals},
                                     {10.0, kilopascals},
                                     {1e5, kilopascals},
                                     {1e4, pascals},
                                     {1e8, pascals}})
    EXPECT_TRUE(warnings(young, units).empty()) << young << units.stress;
  vessel.tube = TubeSpec{};  // generated: a modulus of 1 in any unit is usual
  EXPECT_TRUE(warnings(1, pascals).empty());
}

TEST(Validity, ARadiusThatSpeaksOfAnotherUnitIsAskedAbout) {
  const Units mm, cm{"cm", "MPa", 1e-2, 1e6}, m{"m", "MPa", 1, 1e6};
  const auto warning = [](double radius, const Units& units) {
    Validity validity;
    warn_of_radius("svc", radius, units, validity);
    EXPECT_TRUE(validity.in_range);
    return validity.warnings.empty() ? "" : validity.warnings.at(0);
  };
  EXPECT_EQ(warning(0.99, mm),
            "vessel svc: a mean radius of 0.99 mm is small for a great vessel: is it in cm?");
  EXPECT_EQ(warning(3.3, cm),
            "vessel svc: a mean radius of 3.3 cm is large for a great vessel: is it in mm?");
  EXPECT_NE(warning(1.4e-3, m).find("is the unit right?"), std::string::npos);
  EXPECT_NE(warning(30, mm).find("is the unit right?"), std::string::npos);
  EXPECT_NE(warning(0.033, m).find("is it in cm?"), std::string::npos);
  for (const double millimetres : {1.5, 2.9, 9.9, 15.6, 20.0}) {
    EXPECT_EQ(warning(millimetres, mm), "");
    EXPECT_EQ(warning(0.1 * millimetres, cm), "");
    EXPECT_EQ(warning(0.001 * millimetres, m), "");
  }
}

TEST(Validity, AMouthThatHasToTurnRoundAsksWhichPartIsKept) {
  GlennReport glenn;
  glenn.svc = "svc";
  glenn.rpa = "rpa";
  for (const auto& [degrees, warnings] :
       {std::pair{0.0, 0U}, {89.9, 0U}, {90.1, 1U}, {180.0, 1U}}) {
    glenn.join.axis_turn_deg = degrees;
    Validity validity;
    warn_of_keep(glenn, validity);
    ASSERT_EQ(validity.warnings.size(), warnings) << degrees;
    for (const std::string& warning : validity.warnings)
      EXPECT_NE(warning.find("keep"), std::string::npos);
    EndToEndReport report;
    report.rims[0].vessel = "upper";
    report.rims[1].vessel = "graft";
    report.join.axis_turn_deg = degrees;
    Validity facing;
    warn_of_keep(report, facing);
    ASSERT_EQ(facing.warnings.size(), warnings) << degrees;
    for (const std::string& warning : facing.warnings)
      EXPECT_EQ(warning.find("vessels upper and graft: their rims have to turn by "), 0U);
  }
}

TEST(Validity, NothingCountsBesideARigidEnd) {
  const PreparedVessel tube = judged_tube(300);
  const RodTree& rod = tube.vessel.rod;
  RodPoses poses = rod.rest;  // a kink in the first element only
  Vec6 kink = rod.elements[0].rest_strain;
  kink[3] += 0.1;
  const Pose turn = rod.rest[0] * exp_motion(rod.elements[0].length * kink) * rod.rest[1].inverse();
  for (size_t k = 1; k < poses.size(); ++k) poses[k] = turn * poses[k];
  Validity free, held;
  add_validity(tube, poses, {}, free);
  add_validity(tube, poses, {.rigid_nodes = {0}}, held);
  EXPECT_FALSE(free.in_range);
  EXPECT_TRUE(held.in_range);
  EXPECT_NEAR(held.wrinkling_ratio, 0, 1e-9);
}

PreparedVessel forked() {
  PreparedVessel vessel;
  vessel.spec.name = "pulmonary_artery";
  vessel.spec.wall = Wall{0.45, Material::isotropic(0.45, 0.45)};
  vessel.vessel.surface = testing::infant(vessel.spec.name);
  fit(vessel);
  return vessel;
}

// The rod of a fork turned sharply in one element: a kink of a tube, but not where the element
// belongs to no tube.
TEST(Validity, RatiosOfTubesDoNotCountWithinTheReachOfAFork) {
  const PreparedVessel vessel = forked();
  const RodTree& rod = vessel.vessel.rod;
  const RodBranch& branch = rod.branches[1];
  const auto judged_with_kink = [&](size_t k) {
    const RodElement& element = rod.elements[static_cast<size_t>(branch.elements[k])];
    Vec6 kink = element.rest_strain;
    kink[3] += 0.1;
    kink[5] += 0.1;
    const auto second = static_cast<size_t>(element.second);
    const Pose turn = rod.rest[static_cast<size_t>(element.first)] *
                      exp_motion(element.length * kink) * rod.rest[second].inverse();
    RodPoses poses = rod.rest;
    for (size_t n = k + 1; n < branch.nodes.size(); ++n) {
      const auto node = static_cast<size_t>(branch.nodes[n]);
      poses[node] = turn * poses[node];
    }
    Validity validity;
    add_validity(vessel, poses, {.walls = vessel.vessel.surface.points}, validity);
    return validity;
  };
  const Validity at_fork = judged_with_kink(1), tube = judged_with_kink(branch.elements.size() / 2);
  EXPECT_LT(at_fork.wrinkling_ratio, 1e-6);
  EXPECT_LT(at_fork.twist_ratio, 1e-6);
  EXPECT_LT(at_fork.largest_strain, 1e-6) << "the wall is at rest";
  EXPECT_TRUE(at_fork.in_range);
  EXPECT_GT(tube.wrinkling_ratio, 0.9);
  EXPECT_GT(tube.twist_ratio, 0.9);
  EXPECT_GT(tube.largest_strain, 0.2);
}

// There the wall is judged: one and a half times as wide, it is strained by half.
TEST(Validity, BesideAForkTheWallGivesTheStrain) {
  const PreparedVessel vessel = forked();
  const RodPoses& rest = vessel.vessel.rod.rest;
  Validity walls, rods;
  add_validity(vessel, rest, {.walls = 1.5 * vessel.vessel.surface.points}, walls);
  add_validity(vessel, rest, {}, rods);
  EXPECT_NEAR(walls.largest_strain, 0.5, 1e-12);
  EXPECT_FALSE(walls.in_range);
  EXPECT_EQ(rods.largest_strain, 0);
}

// A tube curved at rest bends softer than its round section, by von Karman's factor: said where the
// model's sections stay round.
TEST(Validity, TheSofteningOfACurvedTubeIsSaidWhereItIsLeftOut) {
  shapes::Tube curved;
  curved.length = 100;
  curved.radius = curved.end_radius = 10;
  curved.along = 80;
  curved.bend = M_PI / 3;
  PreparedVessel vessel = judged_tube();
  vessel.vessel.surface = curved.surface();
  fit(vessel);
  const RodPoses poses = strained(vessel.vessel.rod, change_of(0, Vec3(0, 0.002, 0)));
  const auto said = [&](bool flatten) {
    Validity validity;
    add_validity(vessel, poses, {.sections_flatten = flatten}, validity);
    return std::any_of(
        validity.warnings.begin(), validity.warnings.end(),
        [](const std::string& w) { return w.find("von Karman") != std::string::npos; });
  };
  EXPECT_TRUE(said(false));
  EXPECT_FALSE(said(true));
}

}  // namespace
}  // namespace vasorod
