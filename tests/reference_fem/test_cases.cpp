// The scenes of benchmarks/cases/reference compared with closed forms; solid and shell compared
// with the recorded output beside them and with each other, where thinner walls must agree better.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include <vasorod/read_scene.h>

#include "reference_fem/solve_scene.h"

namespace vasorod::fem {
namespace {

const std::string folder = VASOROD_SOURCE_DIR "/benchmarks/cases/reference/";

struct Outcome {
  double reaction =
      0;  ///< force of the stretch, torque of the twist, moment of the bend; at the moved end
  Points displacement;
};

Outcome solved(const std::string& name, ModelKind model) {
  SolveOptions options;
  options.model = model;
  options.refine = 0;
  options.around = 8;
  options.along = 12;
  const Result r = solve_scene(read_scene(folder + name + ".yaml"), options);
  EXPECT_EQ(r.status, Status::converged) << name;
  const EndReaction& end = r.ends[1];
  const double reaction = name[0] == 's'   ? end.force[2]
                          : name[0] == 't' ? end.moment[2]
                                           : end.moment[1];
  return {reaction, r.vessels[0].current - r.vessels[0].rest};
}

TEST(Cases, SolidAndShellAgreeTheBetterTheThinnerTheWall) {
  const auto expected = nlohmann::json::parse(std::ifstream(folder + "expected.json"));
  for (const std::string kind : {"stretch", "twist", "bend"}) {
    const std::string thickness = kind + "-t";
    double before = 1;
    for (const char* t : {"2", "1", "05"}) {
      const std::string name = thickness + t;
      const Outcome solid = solved(name, ModelKind::solid), shell = solved(name, ModelKind::shell);
      EXPECT_NEAR(solid.reaction / expected[name]["solid"].get<double>(), 1, 1e-6) << name;
      EXPECT_NEAR(shell.reaction / expected[name]["shell"].get<double>(), 1, 1e-6) << name;
      const double gap = std::abs(shell.reaction / solid.reaction - 1);
      EXPECT_LT(gap, kind == "twist" ? 0.002 : 0.01) << name;
      EXPECT_LT((shell.displacement - solid.displacement).rowwise().norm().maxCoeff(), 0.01 * 10)
          << name;
      EXPECT_LT(gap, std::max(before, 1e-5)) << name;  // below 1e-5, mesh errors dominate
      before = gap;
      std::printf("%s: solid %.8g, shell %.8g, relative %.1e, displacements %.1e of R\n",
                  name.c_str(), solid.reaction, shell.reaction, gap,
                  (shell.displacement - solid.displacement).rowwise().norm().maxCoeff() / 10);
    }
  }
}

Result solid_of(const std::string& name, LawKind law) {
  SolveOptions options;
  options.law = law;
  options.refine = 0;
  options.around = 8;
  const Scene scene = read_scene(folder + name + ".yaml");
  options.along = static_cast<int>(std::lround(scene.vessels[0].tube->length / 10));
  Result r = solve_scene(scene, options);
  EXPECT_TRUE(r.status == Status::converged || r.status == Status::equilibrium_only) << name;
  return r;
}

/// E I and k of tip(L) / P = L^3 / 3 E I + L / k G A + c, G = 1 / 2.6.
std::array<double, 2> cantilever_fit(LawKind law) {
  Eigen::Matrix3d powers;
  Vec3 compliance;
  const std::array<int, 3> lengths{40, 60, 90};
  for (int i = 0; i < 3; ++i) {
    const double L = lengths[static_cast<std::size_t>(i)];
    const Result r =
        solid_of("cantilever-" + std::to_string(lengths[static_cast<std::size_t>(i)]), law);
    compliance[i] = r.ends[1].center[0] / 1e-4;
    powers.row(i) << L * L * L, L, 1;
  }
  const Vec3 fit = powers.inverse() * compliance;
  return {1 / (3 * fit[0]), 1 / (fit[1] * 125.6637061436 / 2.6)};
}

/// Mean outward displacement of the section at half the length.
double widening(const VesselResult& vessel) {
  double sum = 0;
  int count = 0;
  const double middle = (vessel.rest.col(2).minCoeff() + vessel.rest.col(2).maxCoeff()) / 2;
  for (Eigen::Index i = 0; i < vessel.rest.rows(); ++i) {
    if (std::abs(vessel.rest(i, 2) - middle) > 1e-6) continue;
    const Vec3 rest = vessel.rest.row(i), moved = vessel.current.row(i);
    sum += (moved - rest).head<2>().dot(rest.head<2>().normalized());
    ++count;
  }
  return sum / count;
}

TEST(Cases, ClosedForms) {
  const std::map<std::string, LawKind> laws{
      {"biot", LawKind::biot}, {"svk", LawKind::svk}, {"neo-hookean", LawKind::neo_hookean}};
  const auto cases = nlohmann::json::parse(std::ifstream(folder + "closed_forms.json"));
  std::optional<std::array<double, 2>> fit;
  for (const auto& [what, row] : cases.items()) {
    const std::string scene = row["scene"];
    const LawKind law = laws.at(row["law"]);
    double found = 0;
    if (scene == "cantilever") {
      if (!fit) fit = cantilever_fit(law);
      found = (*fit)[what[0] == 'E' ? 0 : 1];
    } else {
      const Result r = solid_of(scene, law);
      found = scene == "lame"  ? widening(r.vessels[0])
              : scene == "bar" ? r.ends[1].force[2]
                               : r.ends[1].moment[2];
    }
    const double exact = row["value"];
    std::printf("%s: %.9g (%.9g), relative %.1e\n", what.c_str(), found, exact, found / exact - 1);
    EXPECT_NEAR(found / exact, 1, row["within"].get<double>()) << what;
  }
}

}  // namespace
}  // namespace vasorod::fem
