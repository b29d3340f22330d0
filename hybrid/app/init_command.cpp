#include <iostream>

#include <vasorod/error.h>

#include "app/commands.h"
#include "data/sentence.h"
#include "data/whole_file.h"
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
  if (!write_new_file(options.scene, proposal.text)) refuse_existing(options.scene);
  for (const std::string& line : proposal.found) std::cout << line << '\n';
  for (const std::string& line : proposal.decide) std::cout << "decide: " << line << '\n';
  std::cout << shown(options.scene) << '\n';
  return 0;
}

}  // namespace vasorod
