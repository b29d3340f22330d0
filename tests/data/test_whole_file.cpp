#include <gtest/gtest.h>
#include <string>

#include <vasorod/error.h>

#include "data/whole_file.h"
#include "scratch_folder.h"

namespace vasorod {
namespace {

class WholeFile : public ScratchFolder {};

TEST_F(WholeFile, HasEveryByte) {
  std::string bytes;
  for (int k = 0; k < 100'000; ++k) bytes += static_cast<char>(k * 7 % 256);
  EXPECT_EQ(whole_file(write("bytes", bytes)), bytes);
  EXPECT_EQ(whole_file(write("empty", "")), "");
}

TEST_F(WholeFile, WhatCannotBeReadIsAnError) {
  EXPECT_THROW(whole_file(folder / "missing"), FileError);
  EXPECT_THROW(whole_file(folder), FileError);
}

TEST_F(WholeFile, AFileIsWrittenWholeOrNotAtAll) {
  write_whole_file(folder / "file", "old");
  std::filesystem::create_directories(folder / "blocked" / "inside");
  EXPECT_THROW(write_whole_file(folder / "blocked", "a folder stands there"), FileError);
  EXPECT_THROW(write_whole_file(folder / "absent" / "file", "no such folder"), FileError);
  write_whole_file(folder / "file", "new");
  EXPECT_EQ(whole_file(folder / "file"), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder),
                          std::filesystem::directory_iterator()),
            2);
}

TEST_F(WholeFile, ANewFileIsWrittenOverNothing) {
  EXPECT_TRUE(write_new_file(folder / "file", "first"));
  EXPECT_FALSE(write_new_file(folder / "file", "second"));
  EXPECT_EQ(whole_file(folder / "file"), "first");
  std::filesystem::create_symlink(folder / "nowhere", folder / "link");
  EXPECT_FALSE(write_new_file(folder / "link", "through a link that leads nowhere"));
  std::filesystem::create_directories(folder / "blocked");
  EXPECT_FALSE(write_new_file(folder / "blocked", "a folder stands there"));
  EXPECT_THROW(write_new_file(folder / "absent" / "file", "no such folder"), FileError);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder),
                          std::filesystem::directory_iterator()),
            3);
}

}  // namespace
}  // namespace vasorod
