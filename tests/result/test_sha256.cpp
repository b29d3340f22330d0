#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "result/sha256.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

class Sha256 : public ScratchFolder {};

// FIPS 180-4 examples, NIST.
TEST_F(Sha256, MatchesThePublishedDigests) {
  EXPECT_EQ(sha256_of_file(write("empty", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_file(write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(write("million", std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_F(Sha256, ATextHasTheDigestOfItsFile) {
  EXPECT_EQ(sha256_of_text("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text(""), sha256_of_file(write("empty", "")));
}

TEST_F(Sha256, RefusesAMissingFile) {
  EXPECT_THROW(sha256_of_file(folder / "none"), InputError);
}

}  // namespace
}  // namespace vasorod
