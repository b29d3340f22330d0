// Files that are no scene, and mutations of a valid scene that must be read or refused.
#include <algorithm>
#include <random>
#include <sstream>

#include "bad_scene.h"

namespace vasorod {
namespace {

using testing::base;
using testing::refusal;

class BadFile : public ScratchFolder {};

TEST_F(BadFile, MissingEmptyFolderAndBinary) {
  EXPECT_NE(refusal(folder / "none.yaml").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder).find("folder"), std::string::npos);
  EXPECT_NE(refusal(write("empty.yaml", "")).find("empty"), std::string::npos);
  EXPECT_NE(refusal(write("comment.yaml", "# nothing\n")).find("empty"), std::string::npos);
  EXPECT_NE(refusal(write("word.yaml", "hello")).find("expected a map"), std::string::npos);
  EXPECT_FALSE(refusal(write("binary.yaml", std::string("\0\1\2\xff\xfe{[", 7))).empty());
  EXPECT_FALSE(refusal(write("deep.yaml", std::string(20000, '['))).empty());
}

TEST_F(BadFile, WhatWouldNeverEndOrFillTheMemory) {
  for (const std::string text : {",", "{scene: x},", ",#5: d", "!#up1, pu^SNull", ",(", "]", "}",
                                 "a: 1\n,", "--- ,", ", !!str"}) {
    const std::string sentence = refusal(write("stray.yaml", text));
    EXPECT_NE(sentence.find(", expected "), std::string::npos) << text << ": " << sentence;
  }
  EXPECT_NE(refusal(write("comma.yaml", ",")).find(":1: found a stray \",\" in column 1"),
            std::string::npos);
  for (const std::string part : {"[", "{a: ", "- ", "? "}) {
    std::string text;
    for (int k = 0; k < 100000; ++k) text += part;
    EXPECT_NE(refusal(write("deep.yaml", text)).find(", expected "), std::string::npos);
  }
  std::ostringstream doubled;  // 2^40 values where it is written in full
  doubled << "a0: &a0 [x, x]\n";
  for (int k = 1; k < 40; ++k)
    doubled << "a" << k << ": &a" << k << " [*a" << k - 1 << ", *a" << k - 1 << "]\n";
  EXPECT_NE(refusal(write("doubled.yaml", doubled.str())).find("more than 2000000 values"),
            std::string::npos);
  EXPECT_NE(refusal(write("large.yaml", std::string{}.append(17'000'000, '#'))).find("bytes"),
            std::string::npos);
  EXPECT_NE(refusal(write("zero.yaml", std::string("scene: a\0b", 10))).find("0x00"),
            std::string::npos);
}

// Every mutation is read or refused with one line; no other outcome is allowed.
TEST_F(BadFile, MutationsAreReadOrRefused) {
  std::mt19937 random(1);
  const std::string letters = "[]{}:,-#&*!|>'\"%@` \n\t0123456789.eE+xaz_\xc3\xa9\x01";
  auto pick = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  int refused = 0;
  constexpr int rounds = 400;
  for (int round = 0; round < rounds; ++round) {
    std::string text = base;
    const size_t changes = 1 + pick(4);
    for (size_t k = 0; k < changes && !text.empty(); ++k) {
      const size_t at = pick(text.size());
      switch (pick(5)) {
        case 0:
          text[at] = letters[pick(letters.size())];
          break;
        case 1:
          text.insert(at, 1, letters[pick(letters.size())]);
          break;
        case 2:
          text.erase(at, 1 + pick(5));
          break;
        case 3:
          text.insert(at, text.substr(pick(text.size()), pick(40)));
          break;
        default:
          text.resize(std::max<size_t>(at, 1));
          break;
      }
    }
    const auto file = write("scene.yaml", text);
    try {
      read_scene(file);
    } catch (const InputError& error) {
      ++refused;
      const std::string sentence = error.what();
      ASSERT_EQ(sentence.find('\n'), std::string::npos) << text;
      ASSERT_NE(sentence.find(", expected "), std::string::npos) << sentence;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(refused, rounds / 2);
}

// Replaces every value of the scene in turn by one of a wrong type.
TEST_F(BadFile, WrongKindsOfEveryValue) {
  for (const char* wrong : {"[]", "{}", "[[1]]", "{a: 1}", "~", "-1", "0", "1e400", ".inf", "\"\"",
                            "*x", "&x", "!!int a"}) {
    for (size_t colon = base.find(": "); colon != std::string::npos;
         colon = base.find(": ", colon + 1)) {
      const size_t end = base.find_first_of(",}\n", colon);
      std::string text = base;
      text.replace(colon + 2, end - colon - 2, wrong);
      const auto file = write("scene.yaml", text);
      try {
        read_scene(file);
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << text;
      } catch (const std::exception& error) {
        FAIL() << error.what() << "\n" << text;
      }
    }
  }
}

}  // namespace
}  // namespace vasorod
