// Proposals for generated tubes, written as OBJ.
#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>
#include <vasorod/tube.h>

#include "obj_text.h"
#include "propose/propose_scene.h"
#include "result/write_vtp.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

std::string all(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

class ProposeScene : public ScratchFolder {
 protected:
  std::filesystem::path tube(const std::string& name, double scale, double radius = 5,
                             int around = 32, const std::string& head = "") const {
    TubeSpec spec;
    spec.length = 40 * scale;
    spec.radius = radius * scale;
    spec.around = around;
    spec.along = 40;
    return write(name, head + testing::obj_text(tube_surface(spec)));
  }
  // The scene as its own reader understands it.
  Scene proposed(const std::vector<std::filesystem::path>& surfaces,
                 const std::optional<std::string>& unit = {}) const {
    const Proposal proposal = propose_scene({surfaces, folder / "scene.yaml", unit});
    EXPECT_FALSE(proposal.decide.empty());
    return read_scene(write("scene.yaml", proposal.text));
  }
  std::string refusal(const std::vector<std::filesystem::path>& surfaces) const {
    try {
      propose_scene({surfaces, folder / "scene.yaml", {}});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(ProposeScene, TheUnitIsTheOneInWhichTheRadiiAreThoseOfGreatVessels) {
  EXPECT_EQ(proposed({tube("a.obj", 1)}).units.length, "mm");
  EXPECT_EQ(proposed({tube("a.obj", 0.1)}).units.length, "cm");
  EXPECT_EQ(proposed({tube("a.obj", 1e-3)}).units.length, "m");
  EXPECT_EQ(proposed({tube("a.obj", 0.2)}, "mm").units.length, "mm");
  const std::string said = refusal({tube("a.obj", 1e-6)});
  EXPECT_NE(said.find("implausible"), std::string::npos) << said;
}

// As `vasorod prepare` and results state it: a tube that would be taken for one in mm, in cm.
TEST_F(ProposeScene, TheUnitThatAFileStatesIsNoGuess) {
  const auto vtp = [&](const std::string& name, const std::string& unit) {
    TubeSpec spec;
    spec.length = 30;
    spec.radius = 2;
    spec.around = 32;
    spec.along = 40;
    const std::string units = unit.empty() ? "" : "length " + unit + ", stress MPa";
    return write(name, surface_vtp(tube_surface(spec), {.units = units}));
  };
  const Proposal stated =
      propose_scene({{vtp("a.vtp", "cm"), vtp("b.vtp", "")}, folder / "s.yaml", {}});
  EXPECT_NE(stated.text.find("units: {length: cm"), std::string::npos) << stated.text;
  EXPECT_NE(stated.text.find("as a.vtp says"), std::string::npos) << stated.text;
  EXPECT_EQ(all(stated.decide).find("units"), std::string::npos) << all(stated.decide);
  EXPECT_EQ(proposed({vtp("a.vtp", "")}).units.length, "mm");
  const std::string said = refusal({vtp("a.vtp", "cm"), vtp("b.vtp", "mm")});
  EXPECT_NE(said.find("b.vtp: found lengths in mm (Units in the file) where a.vtp has them in cm"),
            std::string::npos)
      << said;
  const Proposal over = propose_scene({{vtp("a.vtp", "cm")}, folder / "s.yaml", "mm"});
  EXPECT_NE(all(over.decide).find("a.vtp says cm"), std::string::npos) << all(over.decide);
}

TEST_F(ProposeScene, EveryEndIsHeldAndTheWallFollowsTheRadius) {
  const Scene scene = proposed({tube("aorta.obj", 1), tube("some vessel.obj", 1, 10)});
  ASSERT_EQ(scene.vessels.size(), 2u);
  EXPECT_EQ(scene.vessels[0].name, "aorta");
  EXPECT_EQ(scene.vessels[1].name, "some_vessel");
  EXPECT_EQ(*scene.vessels[1].surface, folder / "some vessel.obj");
  EXPECT_NEAR(scene.vessels[0].wall->thickness, 0.6, 0.011);
  EXPECT_NEAR(scene.vessels[1].wall->thickness, 1.2, 0.051);
  ASSERT_EQ(scene.ends.size(), 4u);
  for (const EndCondition& end : scene.ends) EXPECT_TRUE(end.hold);
  EXPECT_FALSE(scene.glenn);
}

TEST_F(ProposeScene, ACoarseSurfaceIsRemeshedAndAFineOneIsNot) {
  EXPECT_FALSE(proposed({tube("a.obj", 1)}).vessels[0].remesh);
  const Scene coarse = proposed({tube("a.obj", 1, 5, 12)});
  ASSERT_TRUE(coarse.vessels[0].remesh);
  EXPECT_NEAR(*coarse.vessels[0].remesh, 2 * M_PI * 5 / 48, 0.05);
}

TEST_F(ProposeScene, SurfacesInTwoSpacesAreRefused) {
  const auto lps = tube("a.obj", 1, 5, 32, "# SPACE=LPS\n"),
             ras = tube("b.obj", 1, 5, 32, "# SPACE=RAS\n");
  const std::string said = refusal({tube("c.obj", 1), lps, ras});
  EXPECT_NE(said.find("b.obj: found the space RAS"), std::string::npos) << said;
  EXPECT_EQ(proposed({lps}).vessels.size(), 1u);
}

TEST_F(ProposeScene, NamesThatAResultCannotHaveAreRefused) {
  std::filesystem::create_directory(folder / "other");
  const auto one = tube("svc.obj", 1);
  std::filesystem::copy_file(one, folder / "other" / "svc.obj");
  const std::string twice = refusal({one, folder / "other" / "svc.obj"});
  EXPECT_NE(twice.find("other/svc.obj: found the name \"svc\""), std::string::npos) << twice;
  const std::string stump = refusal({one, tube("svc_stump.obj", 1)});
  EXPECT_NE(stump.find("svc_stump.obj: found the name \"svc_stump\""), std::string::npos) << stump;
}

}  // namespace
}  // namespace vasorod
