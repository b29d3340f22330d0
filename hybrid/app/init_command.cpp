#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>

#include <vasorod/error.h>

#include "app/commands.h"
#include "data/sentence.h"
#include "propose/propose_scene.h"

namespace vasorod {
namespace {

std::string shown(const std::filesystem::path& file) {
  return one_line(file.string());
}

void refuse_existing(const std::filesystem::path& file) {
  throw FileError(shown(file) +
                  ": exists already, and init overwrites nothing, expected a free "
                  "name");
}

// Creates the file; fails where it exists, also where it was created since it was looked for.
void write_new(const std::filesystem::path& file, const std::string& text) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "wx"),
                                                               std::fclose);
  if (!stream) {
    if (errno == EEXIST) refuse_existing(file);
    throw FileError(shown(file) + ": cannot be written: " + std::strerror(errno));
  }
  if (std::fwrite(text.data(), 1, text.size(), stream.get()) != text.size() ||
      std::fflush(stream.get()) != 0) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw FileError(shown(file) + ": cannot be written in full");
  }
}

}  // namespace

int init_command(const InitOptions& options) {
  std::error_code ignored;
  // Before the work, which takes seconds.
  if (std::filesystem::symlink_status(options.scene, ignored).type() !=
      std::filesystem::file_type::not_found)
    refuse_existing(options.scene);
  const std::filesystem::path folder =
      options.scene.has_parent_path() ? options.scene.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, ignored))
    throw FileError(shown(folder) + ": found no such folder, expected the one of the scene");
  ProposalRequest request;
  request.surfaces = options.surfaces;
  request.scene = options.scene;
  request.length_unit = options.length_unit;
  request.progress = options.progress;
  const Proposal proposal = propose_scene(request);
  write_new(options.scene, proposal.text);
  for (const std::string& line : proposal.found) std::cout << line << '\n';
  for (const std::string& line : proposal.decide) std::cout << "decide: " << line << '\n';
  std::cout << shown(options.scene) << '\n';
  return 0;
}

}  // namespace vasorod
