// Solves the text of a scene by the built program.
#pragma once

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "program/run_program.h"

namespace vasorod::testing {

/// result.json of the scene, without pictures; the program must end with `exit_code`.
inline nlohmann::json solved_scene(const std::string& scene, int exit_code = 0) {
  const ScratchFolder scratch;
  std::ofstream(scratch / "scene.yaml") << scene;
  const auto run =
      run_program(vasorod("solve '" + (scratch / "scene.yaml").string() + "' -o '" +
                          (scratch / "out").string() + "' --json --no-report --threads 1"));
  EXPECT_EQ(run.exit_code, exit_code) << run.err << run.out;
  return nlohmann::json::parse(run.out);
}

}  // namespace vasorod::testing
