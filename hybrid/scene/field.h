// One value of a scene file and its place in the file. Every accessor checks type and range and
// throws InputError "FILE:LINE: KEY: found X, expected Y".
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

#include <vasorod/types.h>

#include "data/limits.h"
#include "data/sentence.h"

namespace vasorod {

class Field {
 public:
  Field(std::string file, std::string key, const YAML::Node& node);

  const std::string& key() const { return key_; }
  int line() const { return line_; }
  bool is_map() const { return node_.IsMap(); }
  bool is_list() const { return node_.IsSequence(); }

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;
  /// Throws "found WHAT"; WHAT also says what was expected.
  [[noreturn]] void refuse(const std::string& what) const;
  /// The value in words, for messages.
  std::string found() const;

  /// Checks that this is a map whose keys are in `known`, each at most once.
  void check_keys(const std::vector<std::string>& known) const;
  bool has(const std::string& name) const;
  /// The value of a key of this map; an error if it is missing.
  Field at(const std::string& name, const std::string& expected) const;
  std::optional<Field> find(const std::string& name) const;

  /// Whether this is that word, with or without quotes.
  bool is(const std::string& word) const { return node_.IsScalar() && node_.Scalar() == word; }
  std::string text(const std::string& expected) const;
  std::string one_of(const std::vector<std::string>& words) const;
  bool boolean() const;
  double number(const std::string& expected = "a number") const;
  double positive() const;
  double not_negative(double largest) const;
  /// Above 0 and within the limits of data/limits.h.
  double length() const;
  double stiffness() const;  ///< a stress too
  /// |value| <= largest.
  double number_up_to(double largest, const std::string& expected = "a number") const;
  /// lowest <= value <= highest.
  double number_in(double lowest, double highest) const;
  int integer_in(int lowest, int highest) const;
  /// Three numbers of magnitude at most `largest`.
  Vec3 vec3(double largest = largest_length) const;
  /// The items of a list, with keys "key[0]", ...
  std::vector<Field> list(const std::string& expected) const;
  /// The same field under a more informative key: a vessel's name instead of its number.
  Field renamed(std::string key) const;

 private:
  double within(double lowest, double highest) const;

  std::string file_, key_;
  YAML::Node node_;
  int line_ = 0;
};

/// The bytes of a scene file. Throws InputError if it is missing or no file, FileError if it cannot
/// be read.
std::string scene_file_text(const std::string& file);
/// The text of a scene file as one map. Throws InputError if it is not YAML with one document.
/// `file`: for messages; of an empty one they name no place but the key.
Field read_yaml(const std::string& file, const std::string& text);

/// Checks d3 and d1 given at `place`: not zero, at right angles within 1e-3. Makes them
/// orthonormal.
void check_directions(const Field& place, Vec3& tangent, Vec3& normal);

}  // namespace vasorod
