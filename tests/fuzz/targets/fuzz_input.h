// What all fuzz targets share: the input as a file, and what a reader may do with it. A reader
// returns, or throws an InputError whose message is one short line. Everything else (another
// exception, a sanitizer's report, the limits of time and memory) is a finding.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

#include <vasorod/error.h>

namespace vasorod::fuzz {

namespace fs = std::filesystem;

/// Ends the process, which libFuzzer reports together with the input.
[[noreturn]] inline void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

/// This process's folder, in memory where the system has a place for that; removed at exit.
inline const fs::path& folder() {
  struct Folder {
    Folder() {
      const fs::path memory = "/dev/shm";
      std::error_code ignored;
      const fs::path base =
          access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path(ignored);
      std::string pattern = (base / "vasorod-fuzz-XXXXXX").string();
      if (mkdtemp(pattern.data()) == nullptr) finding("no folder for the inputs");
      path = pattern;
    }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
    fs::path path;
  };
  static const Folder one;
  return one.path;
}

inline void write_file(const fs::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.flush()) finding("an input cannot be written");
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Whether `read` returns. A refusal must be one line that fits on a screen.
template <class Read>
bool accepted(const Read& read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    for (const char c : message)
      if (static_cast<unsigned char>(c) < 32 || c == 127)
        finding("a control byte in the message: " + std::string(message));
    if (message.empty() || message.size() > 700) finding("message: " + std::string(message));
    return false;
  }
}

}  // namespace vasorod::fuzz
