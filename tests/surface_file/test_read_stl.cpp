// STL files that do not hold what their head says, and files that may not be read.
#include <gtest/gtest.h>
#include <unistd.h>

#include <vasorod/error.h>

#include "scratch_folder.h"
#include "surface_file/read_polydata.h"
#include "surface_file/sample_surfaces.h"
#include "surface_file/surface_file.h"

namespace vasorod {
namespace {

class ReadStl : public ScratchFolder {
 protected:
  std::string bytes(bool ascii) const {
    write_stl(folder / "whole.stl", sample_tube(), ascii);
    std::ifstream in(folder / "whole.stl", std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  std::string refusal(const std::string& text) const {
    try {
      read_polydata(write("tube.stl", text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReadStl, BinaryShorterOrLongerThanItsHeadSaysIsRefused) {
  const std::string whole = bytes(false);
  const auto size = std::to_string(whole.size());
  EXPECT_EQ(refusal(whole), "");
  for (const std::size_t cut : {1U, 49U, 50U, 5000U}) {
    const std::string sentence = refusal(whole.substr(0, whole.size() - cut));
    EXPECT_NE(sentence.find("expected " + size), std::string::npos) << sentence;
  }
  EXPECT_NE(refusal(whole + "x").find("expected " + size), std::string::npos);
  EXPECT_NE(refusal(whole + std::string(50, 'x')).find("960 facets"), std::string::npos);
  EXPECT_NE(refusal(whole.substr(0, 83)).find("83 bytes"), std::string::npos);
}

TEST_F(ReadStl, ABinaryFileMayBeginWithSolid) {
  const std::string whole = bytes(false);
  EXPECT_EQ(refusal("solid" + whole.substr(5)), "");
  EXPECT_NE(refusal("solid" + whole.substr(5, whole.size() - 25)).find("facets"),
            std::string::npos);
}

TEST_F(ReadStl, AsciiSaysTheLineThatIsWrong) {
  const std::string whole = bytes(true);
  EXPECT_EQ(refusal(whole), "");
  EXPECT_NE(refusal(whole.substr(0, whole.size() / 2)).find("damaged or truncated"),
            std::string::npos);
  EXPECT_NE(refusal(whole.substr(0, whole.rfind("endsolid"))).find("it ends where"),
            std::string::npos);
  std::string wrong = whole;
  wrong.replace(wrong.find("vertex"), 6, "corner");
  EXPECT_NE(refusal(wrong).find("tube.stl:4: found a damaged or truncated file (the word "
                                "\"corner\" where vertex belongs)"),
            std::string::npos)
      << refusal(wrong);
  EXPECT_EQ(read_stl(write("two.stl", whole + whole)).polygons.size(),
            2 * static_cast<std::size_t>(sample_tube().triangles.rows()));
}

TEST_F(ReadStl, AFileThatMayNotBeReadSaysSo) {
  constexpr uid_t nobody = 65534;
  const bool root = geteuid() == 0;  // root may read everything
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj"}) {
    const auto file = write(name, "solid");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    if (root) {
      ASSERT_EQ(seteuid(nobody), 0);
    }
    try {
      read_polydata(file);
      ADD_FAILURE() << name;
    } catch (const FileError& error) {
      EXPECT_EQ(error.what(),
                file.string() + ": found a file that may not be read, expected a surface file");
    }
    if (root) {
      ASSERT_EQ(seteuid(0), 0);
    }
  }
}

}  // namespace
}  // namespace vasorod
