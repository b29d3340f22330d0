// PLY headers that promise more than the file holds.
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "scratch_folder.h"
#include "surface_file/surface_file.h"

namespace vasorod {
namespace {

class ReadPly : public ScratchFolder {
 protected:
  std::string refusal(const std::string& text) const {
    try {
      read_ply(write("vessel.ply", text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

std::string header(const std::string& elements) {
  return "ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n";
}

// 8 bytes for each property of each item would be 800 MB for a file of 150 kB.
TEST_F(ReadPly, ManyPropertiesOfManyItemsMustFitIntoTheFile) {
  std::string elements = "element vertex 50000\n";
  for (int k = 0; k < 2000; ++k) elements += "property char p" + std::to_string(k) + "\n";
  const std::string found = refusal(header(elements) + std::string(100'000, 'x'));
  EXPECT_NE(found.find("more items than fit into the file"), std::string::npos) << found;
}

TEST_F(ReadPly, AnItemOfOneByteForEachPropertyFits) {
  const SurfaceFile read =
      read_ply(write("vessel.ply", header("element vertex 3\nproperty char x\nproperty char y\n"
                                          "property char z\n") +
                                       std::string("\1\2\3\4\5\6\7\10\11")));
  EXPECT_EQ(read.points.rows(), 3);
  EXPECT_EQ(read.points(2, 1), 8);
}

}  // namespace
}  // namespace vasorod
