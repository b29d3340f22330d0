// Two solves of one scene with other numbers of threads, by the built program.
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "program/run_program.h"

namespace vasorod::testing {

/// `words`: the scene and options of `vasorod solve`, quoted for the shell.
inline void expect_threads_change_no_number(const std::string& words) {
  const ScratchFolder scratch;
  nlohmann::json alone;
  for (const int threads : {1, 4}) {
    const auto run =
        run_program(vasorod("solve " + words + " -o '" + (scratch / "out").string() +
                            "' --json --no-report --threads " + std::to_string(threads)));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    auto result = nlohmann::json::parse(run.out);
    EXPECT_EQ(result.at("environment").at("threads"), threads);
    result.at("environment").erase("threads");
    result.erase("seconds");
    if (threads == 1)
      alone = result;
    else
      EXPECT_EQ(nlohmann::json::diff(alone, result), nlohmann::json::array()) << words;
  }
}

}  // namespace vasorod::testing
