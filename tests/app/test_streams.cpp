#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "app/streams.h"

namespace vasorod {
namespace {

// Each in a process of its own, as the streams are the process's.
template <class Question>
void expect_in_a_process(Question&& question) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(_exit(question() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

TEST(Streams, AClosedStreamIsNotTheNextFileThatIsOpened) {
  expect_in_a_process([] {
    for (const int stream : {0, 1, 2}) close(stream);
    keep_streams_apart();
    return open("/dev/null", O_RDWR) > 2;
  });
}

TEST(Streams, AClosedStreamStillRefuses) {
  expect_in_a_process([] {
    for (const int stream : {0, 1, 2}) close(stream);
    keep_streams_apart();
    char byte = 'x';
    return read(0, &byte, 1) == -1 && write(1, &byte, 1) == -1 && write(2, &byte, 1) == -1;
  });
}

TEST(Streams, OpenStreamsStayWhatTheyAre) {
  expect_in_a_process([] {
    int ends[2];
    if (pipe(ends) != 0 || dup2(ends[1], 1) != 1) return false;
    keep_streams_apart();
    char byte = 'x';
    return write(1, &byte, 1) == 1 && read(ends[0], &byte, 1) == 1;
  });
}

TEST(Streams, APipeThatNobodyReadsIsAnError) {
  expect_in_a_process([] {
    int ends[2];
    if (pipe(ends) != 0) return false;
    keep_streams_apart();
    close(ends[0]);
    return write(ends[1], "x", 1) == -1 && errno == EPIPE;
  });
}

}  // namespace
}  // namespace vasorod
