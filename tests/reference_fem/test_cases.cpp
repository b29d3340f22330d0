// The scenes of benchmarks/cases/reference: solid and shell against the recorded output beside them, and
// against each other, which must be the closer the thinner the wall.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reference_fem/solve_scene.h"

namespace vasorod::fem {
namespace {

const std::string folder = VASOROD_SOURCE_DIR "/benchmarks/cases/reference/";

struct Outcome {
  double reaction = 0;  ///< force of the stretch, torque of the twist, moment of the bend; at the moved end
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
  const double reaction = name[0] == 's' ? end.force[2] : name[0] == 't' ? end.moment[2] : end.moment[1];
  return {reaction, r.vessels[0].current - r.vessels[0].rest};
}

TEST(Cases, SolidAndShellAgreeTheBetterTheThinnerTheWall) {
  const auto expected = nlohmann::json::parse(std::ifstream(folder + "expected.json"));
  for (const std::string kind : {"stretch", "twist", "bend"}) {
    double before = 1;
    for (const std::string t : {"2", "1", "05"}) {
      const std::string name = kind + "-t" + t;
      const Outcome solid = solved(name, ModelKind::solid), shell = solved(name, ModelKind::shell);
      EXPECT_NEAR(solid.reaction / expected[name]["solid"].get<double>(), 1, 1e-6) << name;
      EXPECT_NEAR(shell.reaction / expected[name]["shell"].get<double>(), 1, 1e-6) << name;
      const double gap = std::abs(shell.reaction / solid.reaction - 1);
      EXPECT_LT(gap, kind == "twist" ? 0.002 : 0.01) << name;
      EXPECT_LT((shell.displacement - solid.displacement).rowwise().norm().maxCoeff(), 0.01 * 10) << name;
      EXPECT_LT(gap, std::max(before, 1e-5)) << name;  // below 1e-5 it is the meshes' own error
      before = gap;
      std::printf("%s: solid %.8g, shell %.8g, relative %.1e, displacements %.1e of R\n", name.c_str(),
                  solid.reaction, shell.reaction, gap,
                  (shell.displacement - solid.displacement).rowwise().norm().maxCoeff() / 10);
    }
  }
}

}  // namespace
}  // namespace vasorod::fem
