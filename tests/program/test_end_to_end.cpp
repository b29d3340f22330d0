// The end-to-end join through the built program: two tubes that make one are that one.
#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program/solved_scene.h"
#include "real_anatomy.h"

namespace vasorod::testing {
namespace {

using nlohmann::json;

// Tubes of 30, the second behind the first, in other units and another place if asked.
struct Halves {
  double length = 1, stress = 1;  // of the scene's units, mm and MPa
  std::string unit_of_length = "mm", unit_of_stress = "MPa";
  bool turned = false;  // along x instead of z, and moved
  std::string rotation = "0";

  std::string vector(double x, double y, double z, bool point = false) const {
    // The turn takes z to x, x to y and y to z.
    double v[] = {x, y, z};
    if (turned) {
      const double w[] = {z + (point ? 7 : 0), x - (point ? 11 : 0), y + (point ? 3 : 0)};
      std::copy(w, w + 3, v);
    }
    std::ostringstream text;
    text.precision(17);
    text << '[' << v[0] * length << ", " << v[1] * length << ", " << v[2] * length << ']';
    return text.str();
  }
  std::string direction(double x, double y, double z) const {
    Halves one = *this;
    one.length = 1;
    return one.vector(x, y, z);
  }
  std::string tube(const std::string& name, double from, double tube_length, int along) const {
    std::ostringstream text;
    text.precision(17);
    text << "  - name: " << name << "\n    tube: {length: " << tube_length * length
         << ", radius: " << 4 * length << ", around: 24, along: " << along
         << ", position: " << vector(0, 0, from, true) << ", tangent: " << direction(0, 0, 1)
         << ", normal: " << direction(1, 0, 0) << "}\n    wall: {thickness: " << 0.4 * length
         << ", young: " << 0.5 * stress << ", poisson: 0.45}\n";
    return text.str();
  }
  std::string head() const {
    return "scene: halves\nunits: {length: " + unit_of_length + ", stress: " + unit_of_stress +
           "}\nvessels:\n";
  }
  std::string joined(const std::string& fidelity, const std::string& motion) const {
    return head() + tube("a", 0, 30, 30) + tube("b", 30, 30, 30) +
           "ends:\n  - {vessel: a, end: start, hold: true}\n  - {vessel: b, end: end, " + motion +
           "}\ncontact: []\nsurgery:\n  end_to_end:\n    rims: [{vessel: a, end: end}, {vessel: b, "
           "end: start}]\n    rotation_deg: " +
           rotation + "\nfidelity: " + fidelity + "\n";
  }
  std::string whole(const std::string& fidelity, const std::string& motion) const {
    return head() + tube("a", 0, 60, 60) +
           "ends:\n  - {vessel: a, end: start, hold: true}\n  - {vessel: a, end: end, " + motion +
           "}\ncontact: []\nfidelity: " + fidelity + "\n";
  }
};

Eigen::Vector3d vector(const json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

Eigen::Vector3d at_end(const json& result, const char* what) {
  return vector(result.at("ends")[1].at(what));
}

// The seam is a hinge. Under stretch and twist the walls' sections have no moment for it to lose
// but that of the narrowing beside held ends.
TEST(EndToEnd, TwoHalvesPullAndTwistAsTheUncutTube) {
  const Halves halves;
  for (const char* fidelity : {"rod", "paper", "coupled"}) {
    SCOPED_TRACE(fidelity);
    const double tolerance = fidelity == std::string("coupled") ? 4e-4 : 1e-7;
    const std::string stretch = "move: [0, 0, 2]", twist = "rotate_deg: [0, 0, 8]";
    const json pulled = solved_scene(halves.joined(fidelity, stretch));
    EXPECT_EQ(pulled.at("status"), "converged");
    const double force = at_end(solved_scene(halves.whole(fidelity, stretch)), "force").z();
    EXPECT_NEAR(at_end(pulled, "force").z() / force, 1, tolerance);
    const json twisted = solved_scene(halves.joined(fidelity, twist));
    const double torque = at_end(solved_scene(halves.whole(fidelity, twist)), "moment").z();
    EXPECT_NEAR(at_end(twisted, "moment").z() / torque, 1, tolerance);
  }
}

// The rods are not hinged: bent, they are the uncut rod.
TEST(EndToEnd, TwoHalvesAreTheUncutRodUnderABend) {
  const Halves halves;
  const std::string bend = "rotate_deg: [0, 20, 0], move: [9, 0, -2]";
  const json joined = solved_scene(halves.joined("rod", bend)),
             whole = solved_scene(halves.whole("rod", bend));
  for (const char* what : {"force", "moment"})
    EXPECT_LT((at_end(joined, what) - at_end(whole, what)).norm(),
              1e-6 * at_end(whole, what).norm());
}

// A prescribed rotation between held ends is a twisted tube: torque G 2 pi R^3 h phi / L.
TEST(EndToEnd, ARotationIsTheTorsionOfATwistedTube) {
  Halves halves;
  halves.rotation = "10";
  const double shear = 0.5 / (2 * 1.45), angle = 10 * M_PI / 180,
               torque = shear * 2 * M_PI * 4 * (16 + 0.04) * 0.4 * angle / 60;
  for (const auto& [fidelity, tolerance] : {std::pair("rod", 1e-3), {"coupled", 0.015}}) {
    SCOPED_TRACE(fidelity);
    const json result = solved_scene(halves.joined(fidelity, "hold: true"));
    EXPECT_EQ(result.at("end_to_end").at("join").at("rotation_deg"), 10);
    // The second vessel is turned by +10 degrees about +z and held back at its end.
    EXPECT_NEAR(at_end(result, "moment").z() / -torque, 1, tolerance);
  }
  halves.rotation = "auto";
  // By the angle between two points of the rim, so that the turned rims' points meet.
  const json result = solved_scene(halves.joined("coupled", "rotate_deg: [0, 0, 15]"));
  EXPECT_NEAR(result.at("end_to_end").at("join").at("rotation_deg").get<double>(), 15, 1e-6);
  EXPECT_LT(at_end(result, "moment").norm(), 1e-5 * torque);
}

TEST(EndToEnd, MovedRigidlyOrInOtherUnitsItIsTheSame) {
  const auto scene = [](const Halves& halves) {
    return halves.joined("coupled", "rotate_deg: " + halves.direction(0, 12, 3) +
                                        ", move: " + halves.vector(4, 0, 1));
  };
  Halves here;
  here.rotation = "15";
  Halves there = here, metres = here;
  there.turned = true;
  metres.length = 1e-3;
  metres.stress = 1e3;
  metres.unit_of_length = "m";
  metres.unit_of_stress = "kPa";
  const json original = solved_scene(scene(here));
  const Eigen::Vector3d force = at_end(original, "force"), moment = at_end(original, "moment");
  const auto expect_same = [&](const json& result, const Halves& of) {
    Eigen::Vector3d f = at_end(result, "force"), m = at_end(result, "moment");
    if (of.turned) {
      f = Eigen::Vector3d(f.y(), f.z(), f.x());
      m = Eigen::Vector3d(m.y(), m.z(), m.x());
    }
    const double unit = of.stress * of.length * of.length;
    EXPECT_LT((f / unit - force).norm(), 1e-5 * force.norm());
    EXPECT_LT((m / (unit * of.length) - moment).norm(), 1e-5 * moment.norm());
    const json &mine = result.at("end_to_end").at("mouth"),
               &other = original.at("end_to_end").at("mouth");
    EXPECT_NEAR(mine.at("area").get<double>() / (of.length * of.length),
                other.at("area").get<double>(), 1e-5 * other.at("area").get<double>());
    EXPECT_NEAR(mine.at("area_ratio").get<double>(), other.at("area_ratio").get<double>(), 1e-5);
  };
  expect_same(solved_scene(scene(there)), there);
  expect_same(solved_scene(scene(metres)), metres);
}

// From walls without stress: held ends, both lumens at 75 mmHg.
TEST(EndToEnd, UnderAPressureTwoHalvesPullAsTheUncutTube) {
  const Halves halves;
  const auto pressed = [](std::string scene) {
    const std::string wall = "poisson: 0.45}\n", pressure = "    pressure: {after: 0.01}\n";
    for (std::size_t at = scene.find(wall); at != std::string::npos;
         at = scene.find(wall, at + wall.size() + pressure.size()))
      scene.insert(at + wall.size(), pressure);
    return scene;
  };
  for (const auto& [fidelity, tolerance] : {std::pair("rod", 1e-7), {"coupled", 1e-3}}) {
    SCOPED_TRACE(fidelity);
    const json two = solved_scene(pressed(halves.joined(fidelity, "hold: true"))),
               one = solved_scene(pressed(halves.whole(fidelity, "hold: true")));
    EXPECT_EQ(two.at("status"), "converged");
    EXPECT_NEAR(at_end(two, "force").z() / at_end(one, "force").z(), 1, tolerance);
  }
}

// Walls with a lumen under one pressure are refused a second one, as in every operation.
TEST(EndToEnd, ThePressuresOfBothVesselsAreOne) {
  const Halves halves;
  std::string scene = halves.joined("coupled", "hold: true");
  const std::string wall = "poisson: 0.45}\n";
  scene.insert(scene.find(wall) + wall.size(), "    pressure: {scan: 0, after: 0.001}\n");
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << scene;
  const auto run = run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                                       (scratch / "out").string() + "'"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("expected one pressure, as the operation joins them"), std::string::npos)
      << run.err;
}

// The kept upper part of the superior vena cava with a tube as its graft.
std::string grafted(const std::string& fidelity) {
  return "scene: grafted\nunits: {length: mm, stress: MPa}\nvessels:\n  - name: svc\n    "
         "surface: " +
         (real_anatomy() / "svc.vtp").string() + R"(
    surface_is: outer
    remesh: 1.5
    wall: {thickness: 1.18, young: 0.80, poisson: 0.45}
  - name: graft
    tube: {length: 40, radius: 9, around: 36, along: 26, position: [-30, 491, -62],
           tangent: [0, -1, 0], normal: [1, 0, 0]}
    wall: {thickness: 0.6, young: 2, poisson: 0.45}
ends:
  - {vessel: svc, end: {near: [-33.5, 518, -66]}, hold: true}
  - {vessel: graft, end: end, hold: true}
surgery:
  end_to_end:
    rims:
      - {vessel: svc, cut: [-30, 495, -55], keep: {near: [-34.5, 518, -68]}}
      - {vessel: graft, end: start}
fidelity: )" +
         fidelity + "\n";
}

TEST(EndToEnd, RealAnatomyTakesAGraft) {
  for (const char* fidelity : {"skin", "paper", "coupled"}) {
    SCOPED_TRACE(fidelity);
    const json result = solved_scene(grafted(fidelity));
    EXPECT_EQ(result.at("status"), "converged");
    const json& report = result.at("end_to_end");
    EXPECT_EQ(report.at("narrower"), "svc");  // its wall is twice as thick
    EXPECT_LT(report.at("join").at("largest_gap").get<double>(), 0.01 * 9);
    EXPECT_GT(report.at("join").at("pairs").get<int>(), 36);
    EXPECT_NEAR(report.at("mouth").at("area_ratio").get<double>(), 0.93, 0.05);
    EXPECT_TRUE(result.at("self_intersections").empty());
    // Nothing else holds them: the two supports balance.
    const Eigen::Vector3d first = vector(result.at("ends")[0].at("force")),
                          second = vector(result.at("ends")[1].at("force"));
    EXPECT_LT((first + second).norm(), 1e-6 * first.norm());
  }
}

}  // namespace
}  // namespace vasorod::testing
