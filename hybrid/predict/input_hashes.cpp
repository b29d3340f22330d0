#include "predict/input_hashes.h"

#include <algorithm>

#include <vasorod/error.h>

#include "result/sha256.h"

namespace vasorod {

InputHashes::InputHashes(const Scene& scene) : scene_(scene) {
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface) files_.push_back(*vessel.surface);
  for (const PickSpec* pick : scene.picks())
    if (!pick->markup.empty()) files_.push_back(pick->markup);
  // The file of a scene that `fit` makes is its surface.
  const bool surface = std::any_of(
      scene.vessels.begin(), scene.vessels.end(),
      [&](const VesselSpec& vessel) { return vessel.surface && *vessel.surface == scene.file; });
  if (!scene.file.empty() && !surface)
    hashes_[scene.file.filename().string()] = sha256_of_file(scene.file);
  for (const PickSpec* pick : scene.picks())
    if (!pick->markup.empty()) hashes_[name_of(pick->markup)] = sha256_of_file(pick->markup);
}

// A file's name, or its path where another input has that name too.
std::string InputHashes::name_of(const std::filesystem::path& file) const {
  const auto taken = [&](const std::filesystem::path& other) {
    return other.filename() == file.filename() &&
           other.lexically_normal() != file.lexically_normal();
  };
  const bool shared = taken(scene_.file) || std::any_of(files_.begin(), files_.end(), taken);
  if (!shared) return file.filename().string();
  const std::filesystem::path beside = file.lexically_relative(scene_.file.parent_path());
  return (beside.empty() ? file : beside).generic_string();
}

std::string InputHashes::scene() const {
  const auto found = hashes_.find(scene_.file.filename().string());
  return found == hashes_.end() ? std::string() : found->second;
}

void InputHashes::add(const VesselSpec& vessel) {
  if (vessel.surface) hashes_[name_of(*vessel.surface)] = sha256_of_file(*vessel.surface);
}

void InputHashes::while_reading(const VesselSpec& vessel, const std::function<void()>& read) {
  // A file that is not there or cannot be read is the reader's to name.
  std::error_code error;
  const bool file = vessel.surface && std::filesystem::is_regular_file(*vessel.surface, error);
  const std::string before = file ? sha256_of_file(*vessel.surface) : std::string();
  read();
  if (!vessel.surface) return;
  const std::string after = sha256_of_file(*vessel.surface);
  if (file && before != after)
    throw FileError(vessel.surface->string() +
                    ": changed while it was read, expected a file that nobody writes to");
  hashes_[name_of(*vessel.surface)] = after;
}

}  // namespace vasorod
