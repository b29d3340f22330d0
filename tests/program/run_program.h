// Runs a built program like a user and captures its output.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>

namespace vasorod::testing {

struct ProgramRun {
  int exit_code = -1;
  std::string out, err;
};

inline std::string contents_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// An empty folder for one test; removed with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "vasorod-test-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// `command`: program and arguments in shell syntax.
inline ProgramRun run_program(const std::string& command) {
  const ScratchFolder scratch;
  const auto out = scratch / "out", err = scratch / "err";
  const int status =
      std::system((command + " >" + out.string() + " 2>" + err.string() + " </dev/null")
                      .c_str());  // NOLINT(cert-env33-c)
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents_of(out), contents_of(err)};
}

/// Whether `ulimit -v` bounds the memory: the address sanitizer reserves terabytes of addresses.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool addresses_can_be_limited = false;
#else
inline constexpr bool addresses_can_be_limited = true;
#endif

/// The built `vasorod`, quoted; VASOROD_PROGRAM is set by tests/program/CMakeLists.txt.
inline std::string vasorod(const std::string& arguments) {
  return "'" VASOROD_PROGRAM "' " + arguments;
}

}  // namespace vasorod::testing
