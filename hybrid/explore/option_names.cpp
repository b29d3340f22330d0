#include "explore/option_names.h"

#include <fstream>
#include <iterator>
#include <yaml-cpp/yaml.h>

#include <vasorod/error.h>
#include <vasorod/version.h>

#include "result/sha256.h"
#include "scene/parse_yaml.h"

namespace vasorod {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

OptionNames::OptionNames(const Scene& scene, const std::map<std::string, std::string>& inputs) {
  common_ = "vasorod " + version() + "\n";
  if (!scene.file.empty()) {
    YAML::Node root = parse_yaml(scene.file.string(), text_of(scene.file));
    // What sets no number of an option.
    for (const char* key : {"explore", "fidelity", "accuracy", "study"}) root.remove(key);
    common_ += YAML::Dump(root) + "\n";
  }
  for (const auto& [name, hash] : inputs)
    if (name != scene.file.filename().string()) common_ += name + " " + hash + "\n";
}

std::string OptionNames::of(const Option& option, const std::string& sample) const {
  constexpr std::size_t letters = 16;
  return sha256_of_text(common_ + option.text() + (sample.empty() ? "" : "\nsample " + sample))
      .substr(0, letters);
}

}  // namespace vasorod
