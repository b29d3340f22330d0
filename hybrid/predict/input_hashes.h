// Fingerprints of a scene's files for result.json, each taken when the file is read: what becomes
// of the file later does not matter.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <vasorod/scene.h>

namespace vasorod {

class InputHashes {
 public:
  /// Takes those of the scene's file, where there is one that was read, and of the files that its
  /// picks were read from. Throws FileError where one cannot be read. `scene` must outlive this.
  explicit InputHashes(const Scene& scene);

  /// That of the vessel's surface file; nothing where it has none.
  void add(const VesselSpec& vessel);
  /// The same round `read`, which reads that file. Throws FileError where it changes meanwhile.
  void while_reading(const VesselSpec& vessel, const std::function<void()>& read);

  /// SHA-256 by file name, or by path where two files have one name.
  const std::map<std::string, std::string>& hashes() const { return hashes_; }
  /// SHA-256 of the scene's file, which is the surface itself in `fit`; empty where there is none.
  std::string scene() const;

 private:
  std::string name_of(const std::filesystem::path& file) const;

  const Scene& scene_;
  std::vector<std::filesystem::path> files_;  // that the scene names
  std::map<std::string, std::string> hashes_;
};

}  // namespace vasorod
