// What a request of the page holds: JSON of which everything is checked before it is used.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod::planner {

using Json = nlohmann::ordered_json;

/// A request that is not answered with what was asked for. The message is one sentence.
struct Refusal : std::runtime_error {
  Refusal(int http_status, const std::string& sentence)
      : std::runtime_error(sentence), status(http_status) {}
  int status;  ///< of HTTP: 400, 403, 404, 409, 413...
};

/// One object of a request. Every accessor throws a Refusal (400) "KEY: found X, expected Y".
class Body {
 public:
  /// Parses a whole body: one object, not nested deeper than any request is. Empty text is {}.
  explicit Body(const std::string& text);
  /// An object below `where`.
  Body(Json value, std::string where);

  /// Throws where there is a key that is not in `known`.
  void check_keys(const std::vector<std::string>& known) const;
  /// Whether the key is there and not null.
  bool has(const std::string& key) const;
  /// A finite number within [low, high].
  double number(const std::string& key, double low, double high) const;
  int integer(const std::string& key, int low, int high) const;
  /// Three finite numbers of magnitude at most data/limits.h's largest length.
  Vec3 vec3(const std::string& key) const;
  /// Of unit length.
  Vec3 direction(const std::string& key) const;
  /// At most `longest` bytes.
  std::string text(const std::string& key, std::size_t longest = 256) const;
  /// The same; empty where the key is absent or null.
  std::optional<std::string> optional_text(const std::string& key) const;
  bool flag(const std::string& key, bool absent) const;
  std::vector<std::string> words(const std::string& key) const;
  Body object(const std::string& key) const;
  const Json& value(const std::string& key) const;
  /// Throws the sentence about a key.
  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

 private:
  Json value_;
  std::string where_;  // "plan.", before keys
};

/// The JSON of a point or a direction.
Json json_of(const Vec3& v);
/// Rows of points, as lists of three numbers.
Json json_of(const Points& points);

}  // namespace vasorod::planner
