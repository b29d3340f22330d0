#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>

#include <vasorod/version.h>

namespace vasorod {
namespace {

TEST(Version, IsTheProjects) {
  std::ifstream file(VASOROD_SOURCE_DIR "/CMakeLists.txt");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, std::regex("VERSION ([0-9]+\\.[0-9]+\\.[0-9]+)")));
  EXPECT_EQ(version(), found[1]);
}

}  // namespace
}  // namespace vasorod
