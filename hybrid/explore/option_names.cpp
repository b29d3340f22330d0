#include "explore/option_names.h"

#include <filesystem>
#include <functional>
#include <map>
#include <yaml-cpp/yaml.h>

#include <vasorod/version.h>

#include "result/sha256.h"
#include "scene/parse_yaml.h"

namespace vasorod {
namespace {

// The hash of a surface's bytes says all that counts; surfaces in memory lie in another folder each
// time. Names that differ in their folders alone stay whole.
void leave_out_folders(YAML::Node vessels) {
  std::map<std::string, int> count;
  const auto named = [&](const std::function<void(YAML::Node)>& take) {
    for (YAML::Node vessel : vessels)
      if (YAML::Node surface = vessel["surface"]; surface && surface.IsScalar()) take(surface);
  };
  const auto name_of = [](const YAML::Node& surface) {
    return std::filesystem::path(surface.Scalar()).filename().string();
  };
  named([&](const YAML::Node& surface) { ++count[name_of(surface)]; });
  named([&](YAML::Node surface) {
    if (count[name_of(surface)] == 1) surface = name_of(surface);
  });
}

}  // namespace

OptionNames::OptionNames(const Scene& scene, const std::map<std::string, std::string>& inputs) {
  common_ = "vasorod " + version() + "\n";
  if (!scene.text.empty()) {
    YAML::Node root = parse_yaml(scene.file.string(), scene.text);
    // What sets no number of an option.
    for (const char* key : {"explore", "fidelity", "accuracy", "study"}) root.remove(key);
    leave_out_folders(root["vessels"]);
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
