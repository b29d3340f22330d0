#include "planner/save.h"

#include <cctype>

#include <vasorod/error.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "data/sentence.h"
#include "data/whole_file.h"
#include "planner/scene_edit.h"

namespace vasorod::planner {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::mutex& writing() {
  static std::mutex mutex;
  return mutex;
}

void check_name(const std::string& name, const std::string& ending) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  bool good = !name.empty() && name.size() <= 100 && plain(name.front()) &&
              name.ends_with(ending) && name.size() > ending.size();
  for (const char c : name) good = good && (plain(c) || c == '-' || c == '.');
  if (!good)
    throw Refusal(400, "name: found " + in_quotes(name) + ", expected letters, digits, _, - and ." +
                           (ending.empty() ? std::string() : " and " + ending + " at the end"));
}

Json save_scene(const OpenedScene& opened, const Plan& plan, const std::string& fidelity,
                const std::string& name, bool overwrite) {
  check_name(name, ".yaml");
  const fs::path file = opened.scene.file.parent_path() / name;
  const EditedScene edited = edited_scene(opened.scene.text, edit_for(opened, plan, fidelity));
  read_scene_text(edited.text, opened.scene.file.parent_path());  // refuses what would not be read
  const std::lock_guard<std::mutex> lock(writing());
  std::error_code error;
  if (overwrite && fs::is_directory(file, error))
    throw Refusal(409, in_quotes(name) + " is a folder, expected another name");
  if (overwrite)
    write_whole_file(file, edited.text);
  else if (!write_new_file(file, edited.text))
    throw Refusal(409,
                  in_quotes(name) + " is there already, expected another name or overwrite: true");
  return {{"file", file.string()}, {"note", edited.note ? Json(*edited.note) : Json()}};
}

Json keep_result(const StoredResult& stored, const fs::path& folder, const std::string& name) {
  check_name(name, "");
  const fs::path kept = folder / name;
  std::error_code error;
  if (fs::exists(fs::symlink_status(kept, error)))
    throw Refusal(409, in_quotes(name) + " is there already, expected another name");
  Result result = stored.result;
  write_result_folder(result, kept);
  return {{"folder", kept.string()}};
}

}  // namespace vasorod::planner
