#include "predict/memory_need.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;

// Measured peaks of whole runs (docs/comparison.md, docs/wall.md and /usr/bin/time), bytes: the
// estimate is below each, so that nothing that fits is refused, but not far below.
TEST(MemoryNeed, IsALittleBelowWhatWasMeasured) {
  struct Peak {
    std::string fidelity;
    double vertices, bytes;
  };
  for (const Peak& peak : {Peak{"coupled", 4.3e3, 255e6}, Peak{"coupled", 1.7e4, 1084e6},
                           Peak{"paper", 1e6, 4.2e9}, Peak{"skin", 1.2e5, 146e6}}) {
    const double least = least_memory(tube("vein"), peak.fidelity, peak.vertices);
    EXPECT_LT(least, peak.bytes) << peak.fidelity;
    EXPECT_GT(least, peak.bytes / 4) << peak.fidelity;
  }
}

TEST(MemoryNeed, OfASceneIsThatOfWhatIsSolved) {
  Scene scene = stretched_tube(0.05, "coupled");
  scene.vessels.push_back(tube("aorta2"));  // nothing moves it
  scene.vessels[0].tube->around = 1000;
  scene.vessels[0].tube->along = 999;
  const std::vector<double> sizes = stated_sizes(scene);
  EXPECT_EQ(sizes[0], 1e6);
  const double alone = least_memory(scene.vessels[0], "coupled", 1e6),
               beside = least_memory(scene.vessels[1], "skin", sizes[1]);
  EXPECT_NO_THROW(require_memory(scene, "coupled", sizes, 1.001 * (alone + beside)));
  try {
    require_memory(scene, "coupled", sizes, 0.999 * (alone + beside));
    ADD_FAILURE() << "accepted";
  } catch (const TooLarge& error) {
    const std::string said = error.what();
    for (const char* part : {"vessel aorta:", "1000000 vertices", "fidelity coupled", "GB"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  EXPECT_NO_THROW(require_memory(scene, "coupled", sizes, std::nullopt));
}

TEST(MemoryNeed, OfRodsGoesByTheirElements) {
  Scene scene;
  scene.vessels = {bare_rod("beam", 10, 1'000'000)};
  EXPECT_EQ(stated_sizes(scene), std::vector<double>{1e6});
  EXPECT_THROW(require_memory(scene, "rod", stated_sizes(scene), 1e8), TooLarge);
  EXPECT_NO_THROW(require_memory(scene, "rod", stated_sizes(scene), 1e10));
}

}  // namespace
}  // namespace vasorod
