#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "propose/scene_text.h"

namespace vasorod {
namespace {

TEST(SceneText, ATextReadsBackAsItself) {
  for (const std::string text :
       {"svc.vtp", "../a/b.stl", "/tmp/x_1-2.ply", "a b.vtp", "say \"hi\".vtp", "back\\slash.vtp",
        "#1.vtp", "a: b.vtp", "-a.vtp", "line\nbreak.vtp", "tab\t.vtp", "null", "{x}.vtp",
        "\xc3\xa4.vtp"}) {
    const YAML::Node read = YAML::Load("surface: " + yaml_text(text) + "\n");
    ASSERT_TRUE(read["surface"].IsScalar()) << yaml_text(text);
    EXPECT_EQ(read["surface"].Scalar(), text) << yaml_text(text);
    EXPECT_EQ(yaml_text(text).find('\n'), std::string::npos);
  }
}

TEST(SceneText, EndsAreThoseOfAScene) {
  EndSelector end;
  EXPECT_EQ(yaml_of(end), "start");
  end.kind = EndSelector::Kind::face;
  end.face = 12;
  EXPECT_EQ(yaml_of(end), "{face: 12}");
  end.kind = EndSelector::Kind::near;
  end.near = {1.5, -20, 1e-12};
  EXPECT_EQ(yaml_of(end), "{near: [1.5, -20, 0]}");
}

}  // namespace
}  // namespace vasorod
