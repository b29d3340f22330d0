#include <vasorod/error.h>
#include <vasorod/result_folder.h>

#include "planner/hand_made_result.h"
#include "planner/small_scene.h"
#include "planner/sources.h"

namespace vasorod::planner {
namespace {

class Sources : public SmallScene {
 protected:
  void write_result(const std::string& name) {
    Result result = hand_made_result();
    WriteOptions options;
    options.report = false;
    write_result_folder(result, folder / name, options);
  }
};

std::string listed(const std::vector<Source>& sources) {
  std::string text;
  for (const Source& one : sources)
    text += one.id + (one.kind == Source::Kind::scene ? " scene " : " result ") + one.name +
            (one.group.empty() ? "" : " of " + one.group) + "\n";
  return text;
}

TEST_F(Sources, WhatIsNamedAndWhatLiesBeside) {
  write("b.yaml", small_scene);
  write("a.yaml", small_scene);
  write("note.yaml", "a: 1\n");
  write("text.txt", small_scene);
  write_result("solved");
  std::filesystem::create_directories(folder / "tried" / "options");
  write("tried/options.csv", "");
  write_result("tried/options/0123");
  const std::string beside =
      "s2 scene a\n"
      "s3 result solved\n"
      "s4 result 0123 of tried\n";
  EXPECT_EQ(listed(find_sources({folder / "b.yaml"}, "/")), "s1 scene b\n" + beside);
  EXPECT_EQ(listed(find_sources({folder / "tried"}, "/")), "s1 result 0123 of tried\n");
  EXPECT_EQ(listed(find_sources({folder / "solved/"}, "/")).substr(0, 17), "s1 result solved\n");
  EXPECT_EQ(listed(find_sources({}, folder)),
            "s1 scene a\ns2 scene b\ns3 result solved\ns4 result 0123 of tried\n");
  EXPECT_EQ(folder_of(find_sources({folder / "b.yaml"}, "/"), "/"), folder);
}

TEST_F(Sources, WhatComesLaterIsAddedBehind) {
  write("m.yaml", small_scene);
  std::vector<Source> sources = find_sources({folder / "m.yaml"}, "/");
  write("a.yaml", small_scene);
  write_result("kept");
  add_new(folder, sources);
  EXPECT_EQ(listed(sources), "s1 scene m\ns2 scene a\ns3 result kept\n");
  add_new(folder, sources);
  EXPECT_EQ(sources.size(), 3U);
}

TEST_F(Sources, WhatIsNeitherIsRefused) {
  EXPECT_THROW(find_sources({folder / "none.yaml"}, folder), InputError);
  EXPECT_THROW(find_sources({folder}, folder), InputError);
}

}  // namespace
}  // namespace vasorod::planner
