#include <gtest/gtest.h>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "app/ending.h"
#include "predict/memory_need.h"

namespace vasorod {
namespace {

// What the program says of an exception, and its exit code.
template <class Error>
std::pair<int, std::string> said(const Error& error) {
  ::testing::internal::CaptureStderr();
  int code = -1;
  try {
    throw error;
  } catch (...) {
    code = say_failure();
  }
  return {code, ::testing::internal::GetCapturedStderr()};
}

using Said = std::pair<int, std::string>;

TEST(Ending, EveryFailureIsOneSentenceAndItsExitCode) {
  EXPECT_EQ(said(StoppedEarly("early")), Said(1, "vasorod: early\n"));
  EXPECT_EQ(said(InputError("input")), Said(2, "vasorod: input\n"));
  EXPECT_EQ(said(FileError("file")), Said(3, "vasorod: file\n"));
  EXPECT_EQ(said(TooLarge("large")), Said(3, "vasorod: large\n"));
  EXPECT_EQ(said(std::runtime_error("bug")), Said(3, "vasorod: unexpected: bug\n"));
}

TEST(Ending, EveryWayOfHavingNoMemoryIsTheSameSentence) {
  const Said none = said(std::bad_alloc());
  EXPECT_EQ(none.first, 3);
  EXPECT_NE(none.second.find("found no memory left"), std::string::npos);
  EXPECT_EQ(said(std::length_error("vector")), none);
  EXPECT_EQ(
      said(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again))),
      none);
}

}  // namespace
}  // namespace vasorod
