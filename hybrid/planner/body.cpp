#include "planner/body.h"

#include <cmath>
#include <utility>

#include "data/limits.h"
#include "data/sentence.h"

namespace vasorod::planner {
namespace {

constexpr int deepest = 16;  // no request of the page is nested deeper than five

void check_depth(const std::string& text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest)
        throw Refusal(400, "body: found lists and objects nested deeper than " +
                               std::to_string(deepest) + ", expected those of a request");
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

Json parsed(const std::string& text) {
  if (text.empty()) return Json::object();
  check_depth(text);
  Json value;
  try {
    value = Json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Refusal(
        400, "body: found no JSON (" + shortened(error.what(), 160) + "), expected one object");
  }
  if (!value.is_object())
    throw Refusal(400,
                  std::string("body: found a JSON ") + value.type_name() + ", expected an object");
  return value;
}

std::string found_text(const Json& value) {
  return shortened(value.dump(-1, ' ', true, Json::error_handler_t::replace), 60);
}

}  // namespace

Body::Body(const std::string& text) : value_(parsed(text)) {}

Body::Body(Json value, std::string where) : value_(std::move(value)), where_(std::move(where)) {}

void Body::refuse(const std::string& key, const std::string& expected) const {
  const auto found = value_.find(key);
  throw Refusal(400, where_ + key + ": found " +
                         (found == value_.end() ? "nothing" : found_text(*found)) + ", expected " +
                         expected);
}

void Body::check_keys(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : value_.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw Refusal(400, (where_.empty() ? std::string("body: ") : where_ + " ") +
                             "found the key " + in_quotes(key) + ", expected " + listed(known));
}

bool Body::has(const std::string& key) const {
  const auto found = value_.find(key);
  return found != value_.end() && !found->is_null();
}

const Json& Body::value(const std::string& key) const {
  if (!has(key)) refuse(key, "a value");
  return *value_.find(key);
}

double Body::number(const std::string& key, double low, double high) const {
  const std::string expected = "a number from " + number_text(low) + " to " + number_text(high);
  if (!has(key) || !value(key).is_number()) refuse(key, expected);
  const double number = value(key).get<double>();
  if (!(number >= low && number <= high)) refuse(key, expected);
  return number;
}

int Body::integer(const std::string& key, int low, int high) const {
  const double number = this->number(key, low, high);
  if (number != std::floor(number)) refuse(key, "a whole number");
  return static_cast<int>(number);
}

Vec3 Body::vec3(const std::string& key) const {
  const std::string expected = "three numbers of magnitude at most " + number_text(largest_length);
  if (!has(key)) refuse(key, expected);
  const Json& list = value(key);
  if (!list.is_array() || list.size() != 3) refuse(key, expected);
  Vec3 v;
  for (int k = 0; k < 3; ++k) {
    const Json& one = list[static_cast<std::size_t>(k)];
    if (!one.is_number()) refuse(key, expected);
    v[k] = one.get<double>();
    if (!(std::abs(v[k]) <= largest_length)) refuse(key, expected);
  }
  return v;
}

Vec3 Body::direction(const std::string& key) const {
  const Vec3 v = vec3(key);
  const double length = v.stableNorm();
  if (!(length > 0) || !std::isfinite(length)) refuse(key, "a direction, not zero");
  return v / length;
}

std::string Body::text(const std::string& key, std::size_t longest) const {
  const std::string expected = "a text of at most " + std::to_string(longest) + " bytes";
  if (!has(key) || !value(key).is_string()) refuse(key, expected);
  std::string text = value(key).get<std::string>();
  if (text.size() > longest) refuse(key, expected);
  return text;
}

std::optional<std::string> Body::optional_text(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return text(key);
}

bool Body::flag(const std::string& key, bool absent) const {
  if (!has(key)) return absent;
  if (!value(key).is_boolean()) refuse(key, "true or false");
  return value(key).get<bool>();
}

std::vector<std::string> Body::words(const std::string& key) const {
  if (!has(key)) return {};
  const Json& list = value(key);
  if (!list.is_array() || list.size() > 1000) refuse(key, "a list of at most 1000 names");
  std::vector<std::string> words;
  for (const Json& one : list) {
    if (!one.is_string()) refuse(key, "a list of names");
    words.push_back(one.get<std::string>());
  }
  return words;
}

Body Body::object(const std::string& key) const {
  if (!has(key) || !value(key).is_object()) refuse(key, "an object");
  return {value(key), where_ + key + "."};
}

Json json_of(const Vec3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

Json json_of(const Points& points) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < points.rows(); ++i) rows.push_back(json_of(Vec3(points.row(i))));
  return rows;
}

}  // namespace vasorod::planner
