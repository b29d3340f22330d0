#include <cmath>
#include <gtest/gtest.h>

#include "predict/prestress.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double mmhg = 133.322387415e-6;  // MPa
constexpr auto start = EndSelector::Kind::start, end = EndSelector::Kind::end;

// A tube of an infant's size, held at both ends. Lengths in `length` mm, stresses in `stress` MPa.
Scene held_tube(LumenPressure pressure, double prestretch, double length = 1, double stress = 1) {
  Scene scene;
  scene.name = "held";
  if (length != 1) scene.units = {"m", "Pa", 1, 1};
  VesselSpec vessel = tube("svc", 24 / length, {0, 0, 0}, 24);
  vessel.tube->radius = 3.3 / length;
  vessel.tube->along = 30;
  vessel.tube->bend_deg = 20;
  vessel.wall = Wall{0.4 / length, Material::isotropic(0.5 / stress, 0.45)};
  vessel.pressure = LumenPressure{pressure.scan / stress, pressure.after / stress};
  vessel.axial_prestretch = prestretch;
  scene.vessels = {vessel};
  scene.ends = {held("svc", start), held("svc", end)};
  scene.fidelity = "coupled";
  return scene;
}

double moved_by(const Result& result) {
  const VesselResult& vessel = result.vessels.at(0);
  return (vessel.current - vessel.rest).rowwise().norm().maxCoeff();
}

TEST(Prestress, AVesselAsSeenStaysAsItIs) {
  for (const char* fidelity : {"coupled", "section"}) {
    Scene seen = held_tube({10 * mmhg, 10 * mmhg}, 1.05), relaxed = held_tube({0, 10 * mmhg}, 1);
    seen.fidelity = relaxed.fidelity = fidelity;
    const Result result = predict(seen);
    EXPECT_EQ(result.status, Status::converged) << fidelity;
    EXPECT_LT(moved_by(result), 1e-9 * 3.3) << fidelity;
    ASSERT_TRUE(result.balance.at(0).pressure);
    EXPECT_NE(result.certificate.notes.at(0).find("10 mmHg (0.001333 MPa) as scanned, 10 mmHg"),
              std::string::npos)
        << result.certificate.notes[0];
    // Without the prestress it would not.
    EXPECT_GT(moved_by(predict(relaxed)), 0.06) << fidelity;
  }
}

// A stretched vessel pulls at its ends though nothing moves: E t times its circumference and
// strain.
TEST(Prestress, AStretchAloneIsModelled) {
  Scene scene = held_tube({}, 1.05);
  scene.vessels[0].pressure.reset();
  scene.vessels[0].tube->bend_deg = 0;
  for (const auto& [fidelity, share] : {std::pair("coupled", 0.01), {"section", 0.001}}) {
    scene.fidelity = fidelity;
    const Result result = predict(scene);
    EXPECT_EQ(result.status, Status::converged) << fidelity;
    EXPECT_LT(moved_by(result), 1e-9 * 3.3) << fidelity;
    EXPECT_FALSE(result.balance.at(0).pressure);
    const double force = 0.5 * 0.4 * 2 * M_PI * 3.3 * 0.05;
    EXPECT_NEAR(result.ends.at(1).force.z(), force, share * force) << fidelity;
  }
}

TEST(Prestress, APressureOfZeroIsNone) {
  for (const char* fidelity : {"rod", "skin", "section", "coupled"}) {
    Scene zero = held_tube({0, 0}, 1);
    zero.fidelity = fidelity;
    zero.ends[1].hold = false;
    zero.ends[1].move = Vec3(0, 1, -0.5);
    Scene none = zero;
    none.vessels[0].pressure.reset();
    const Result with = predict(zero), without = predict(none);
    EXPECT_EQ(without.status, Status::converged) << fidelity;
    EXPECT_EQ(with.status, without.status) << fidelity;
    const Vec3 pull = without.ends.at(1).force;
    EXPECT_GT(pull.norm(), 0) << fidelity;
    EXPECT_LT((with.ends.at(1).force - pull).norm(), 1e-9 * pull.norm()) << fidelity;
    EXPECT_LT((with.vessels[0].centerline->current - without.vessels[0].centerline->current)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9 * 3.3)
        << fidelity;
    if (std::string(fidelity) != "rod") {
      EXPECT_LT((with.vessels[0].current - without.vessels[0].current).cwiseAbs().maxCoeff(),
                1e-9 * 3.3)
          << fidelity;
    }
  }
}

TEST(Prestress, MillimetresOrMetresGiveTheSame) {
  const Result one = predict(held_tube({5 * mmhg, 15 * mmhg}, 1)),
               other = predict(held_tube({5 * mmhg, 15 * mmhg}, 1, 1e3, 1e-6));
  EXPECT_EQ(one.status, Status::converged);
  EXPECT_LT((1e3 * other.vessels[0].current - one.vessels[0].current).rowwise().norm().maxCoeff(),
            1e-11);
  EXPECT_NEAR(other.ends[0].force.norm(), one.ends[0].force.norm(),
              1e-9 * one.ends[0].force.norm());
}

// Between the ends the walls feel what the supports do not carry: the pressure on the bend.
TEST(Prestress, ThePressureIsInTheBalance) {
  const Result result = predict(held_tube({0, 10 * mmhg}, 1));
  const Balance& balance = result.balance.at(0);
  EXPECT_LT((balance.support + *balance.pressure).norm(), 1e-6 * balance.support.norm());
  // p pi r_i^2 times the change of the axis' direction; the ends are rigid.
  const double expected = 10 * mmhg * M_PI * 3.1 * 3.1 * 2 * std::sin(M_PI / 18);
  EXPECT_NEAR(balance.pressure->norm(), expected, 0.02 * expected);
}

TEST(Prestress, JoinedVesselsHaveOnePressure) {
  Scene scene = held_tube({5 * mmhg, 12 * mmhg}, 1);
  scene.vessels.push_back(tube("rpa"));
  scene.glenn.emplace();
  scene.glenn->svc = "svc";
  scene.glenn->rpa = "rpa";
  const std::string said = refusal([&] { require_one_pressure(scene); });
  EXPECT_NE(said.find("12 mmHg (0.0016 MPa) in svc and 0 mmHg (0 MPa) in rpa"), std::string::npos)
      << said;
  scene.vessels[1].pressure = LumenPressure{15 * mmhg, 12 * mmhg};
  EXPECT_EQ(refusal([&] { require_one_pressure(scene); }), "");
}

TEST(Prestress, APressureBeyondTheWallIsRefused) {
  const std::string said = refusal([] { predict(held_tube({0, 1300 * mmhg}, 1)); });
  EXPECT_NE(said.find("vessel svc: pressure.after: found 1300 mmHg"), std::string::npos) << said;
}

// Far from the shape without stress that shape is looked for, which the result says. Without the
// pressure the vessel is nearly there: its ends are held where they were seen.
TEST(Prestress, AFarShapeWithoutStressIsNamed) {
  std::vector<Points> without;
  for (const char* fidelity : {"coupled", "section"}) {
    // All but the same pressure: it moves by no more than that says.
    Scene scene = held_tube({60 * mmhg, 60 * (1 + 1e-12) * mmhg}, 1);
    scene.fidelity = fidelity;
    Result result = predict(scene);
    int named = 0;
    for (const std::string& note : result.certificate.notes)
      named += note.find("prestress of svc: its shape without stress, which is up to ") == 0;
    EXPECT_EQ(named, 1) << fidelity;
    EXPECT_LT(moved_by(result), 1e-9 * 3.3) << fidelity;
    // One that stays as it was seen needs no more than equilibrium.
    scene.vessels[0].pressure = LumenPressure{60 * mmhg, 60 * mmhg};
    result = predict(scene);
    EXPECT_LT(moved_by(result), 1e-9 * 3.3) << fidelity;
    int linear = 0;
    for (const std::string& note : result.certificate.notes)
      linear += note.find("prestress of svc: it is that of a linear displacement") == 0;
    EXPECT_EQ(linear, 1) << fidelity;
    scene.vessels[0].tube->around = 48;
    scene.vessels[0].tube->along = 60;
    scene.vessels[0].pressure = LumenPressure{60 * mmhg, 0};
    result = predict(scene);
    EXPECT_LT(result.energy.total(), 1e-8) << fidelity;
    EXPECT_GT(moved_by(result), 0.25) << fidelity;
    without.push_back(result.vessels[0].current);
  }
  const double apart = std::sqrt((without[0] - without[1]).rowwise().squaredNorm().mean());
  EXPECT_LT(apart, 2e-3 * 3.3);
}

// A curved vessel bows far when it is stretched, by a small strain: its stress is linear and called
// rough.
TEST(Prestress, OfASmallStrainItIsLinear) {
  for (const char* fidelity : {"coupled", "section"}) {
    Scene scene = held_tube({5 * mmhg, 12 * mmhg}, 1.05);
    scene.fidelity = fidelity;
    scene.vessels[0].tube->bend_deg = 60;
    const Result result = predict(scene);
    EXPECT_EQ(result.status, Status::converged) << fidelity;
    int linear = 0;
    for (const std::string& note : result.certificate.notes)
      linear += note.find("prestress of svc: it is that of a linear displacement") == 0;
    EXPECT_EQ(linear, 1) << fidelity;
  }
}

}  // namespace
}  // namespace vasorod
