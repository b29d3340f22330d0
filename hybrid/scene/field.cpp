#include "scene/field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <vasorod/error.h>

#include "data/whole_file.h"
#include "scene/parse_yaml.h"

namespace vasorod {

namespace {

// The whole text as a finite number, else empty. YAML's .inf and .nan are not accepted.
std::optional<double> parse_number(const std::string& text) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Whether a scalar is unquoted. A quoted one is text even if it spells a number.
bool plain(const YAML::Node& node) {
  return node.IsScalar() && node.Tag() == "?";
}

}  // namespace

Field::Field(std::string file, std::string key, const YAML::Node& node)
    : file_(std::move(file)), key_(std::move(key)), node_(node), line_(node_.Mark().line + 1) {}

void Field::refuse(const std::string& what) const {
  const std::string place = file_.empty() ? "" : file_ + ":" + std::to_string(line_) + ": ";
  throw InputError(one_line(place + (key_.empty() ? "" : key_ + ": ") + "found " + what));
}

void Field::refuse(const std::string& what, const std::string& expected) const {
  refuse(what + ", expected " + expected);
}

std::string Field::found() const {
  switch (node_.Type()) {
    case YAML::NodeType::Scalar:
      return plain(node_) ? in_quotes(node_.Scalar()) : "the text " + in_quotes(node_.Scalar());
    case YAML::NodeType::Sequence:
      return "a list of " + std::to_string(node_.size());
    case YAML::NodeType::Map:
      return "a map of keys";
    default:
      return "nothing";
  }
}

void Field::check_keys(const std::vector<std::string>& known) const {
  if (!node_.IsMap()) refuse(found(), "a map of " + listed(known));
  std::vector<std::string> seen;
  for (const auto& entry : node_) {
    const Field key(file_, key_, entry.first);
    if (!entry.first.IsScalar()) key.refuse(key.found() + " as a key", listed(known));
    const std::string& name = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const auto meant = nearest_word(name, known);
      key.refuse("the unknown key " + in_quotes(name), meant ? in_quotes(*meant) : listed(known));
    }
    if (std::find(seen.begin(), seen.end(), name) != seen.end())
      key.refuse("the key " + in_quotes(name) + " a second time", "it once");
    seen.push_back(name);
  }
}

bool Field::has(const std::string& name) const {
  return find(name).has_value();
}

std::optional<Field> Field::find(const std::string& name) const {
  if (!node_.IsMap()) return std::nullopt;
  for (const auto& entry : node_)
    if (entry.first.IsScalar() && entry.first.Scalar() == name) {
      Field field(file_, key_.empty() ? name : key_ + "." + name, entry.second);
      if (field.line_ <= 0)
        field.line_ = entry.first.Mark().line + 1;  // an empty value has no line of its own
      return field;
    }
  return std::nullopt;
}

Field Field::at(const std::string& name, const std::string& expected) const {
  if (auto field = find(name)) return *field;
  renamed(key_.empty() ? name : key_ + "." + name).refuse("nothing", expected);
}

Field Field::renamed(std::string key) const {
  Field field = *this;
  field.key_ = std::move(key);
  return field;
}

std::string Field::text(const std::string& expected) const {
  if (!node_.IsScalar() || node_.Scalar().empty()) refuse(found(), expected);
  return node_.Scalar();
}

std::string Field::one_of(const std::vector<std::string>& words) const {
  if (!node_.IsScalar() || std::find(words.begin(), words.end(), node_.Scalar()) == words.end())
    refuse(found(), listed(words));
  return node_.Scalar();
}

bool Field::boolean() const {
  if (plain(node_)) {
    const std::string& word = node_.Scalar();
    if (word == "true" || word == "True" || word == "TRUE") return true;
    if (word == "false" || word == "False" || word == "FALSE") return false;
  }
  refuse(found(), "true or false");
}

double Field::number(const std::string& expected) const {
  if (plain(node_))
    if (const auto value = parse_number(node_.Scalar())) return *value;
  refuse(found(), expected);
}

double Field::positive() const {
  const double value = number("a number above 0");
  if (value <= 0) refuse(shortened(node_.Scalar()), "a number above 0");
  return value;
}

double Field::not_negative(double largest) const {
  const double value = number_up_to(largest, "a number of at least 0");
  if (value < 0) refuse(shortened(node_.Scalar()), "a number of at least 0");
  return value;
}

double Field::within(double lowest, double highest) const {
  const double value = positive();
  if (value < lowest) refuse(number_text(value), "a number of at least " + number_text(lowest));
  if (value > highest) refuse(number_text(value), "a number of at most " + number_text(highest));
  return value;
}

double Field::length() const {
  return within(smallest_length, largest_length);
}

double Field::stiffness() const {
  return within(smallest_stiffness, largest_stiffness);
}

double Field::number_up_to(double largest, const std::string& expected) const {
  const double value = number(expected);
  if (std::abs(value) > largest)
    refuse(number_text(value),
           "a number from " + number_text(-largest) + " to " + number_text(largest));
  return value;
}

double Field::number_in(double lowest, double highest) const {
  const std::string expected =
      "a number from " + number_text(lowest) + " to " + number_text(highest);
  const double value = number(expected);
  if (value < lowest || value > highest) refuse(shortened(node_.Scalar()), expected);
  return value;
}

int Field::integer_in(int lowest, int highest) const {
  const std::string expected =
      "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest);
  const double value = number(expected);
  if (value != std::floor(value) || value < lowest || value > highest)
    refuse(shortened(node_.Scalar()), expected);
  return static_cast<int>(value);
}

std::vector<Field> Field::list(const std::string& expected) const {
  if (!node_.IsSequence()) refuse(found(), expected);
  std::vector<Field> items;
  for (const auto& item : node_) {
    Field field(file_, key_ + "[" + std::to_string(items.size()) + "]", item);
    if (field.line_ <= 0) field.line_ = line_;
    items.push_back(std::move(field));
  }
  return items;
}

Vec3 Field::vec3(double largest) const {
  const std::string expected = "three numbers [x, y, z]";
  const auto items = list(expected);
  if (items.size() != 3) refuse(found(), expected);
  return {items[0].number_up_to(largest), items[1].number_up_to(largest),
          items[2].number_up_to(largest)};
}

std::string scene_file_text(const std::string& file) {
  const std::string name = one_line(file);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw InputError(name + ": found no such file, expected a scene file");
  if (!std::filesystem::is_regular_file(file, ignored))
    throw InputError(name + ": found a folder or device, expected a scene file");
  return whole_file(file);
}

Field read_yaml(const std::string& file, const std::string& text) {
  const YAML::Node root = parse_yaml(file, text);
  if (root.IsDefined() && !root.IsNull()) return {file, "", root};
  throw InputError(file.empty() ? "found an empty text, expected a scene"
                                : one_line(file) + ":1: found an empty file, expected a scene");
}

void check_directions(const Field& place, Vec3& tangent, Vec3& normal) {
  for (const auto& [key, direction] :
       {std::pair("tangent", &tangent), std::pair("normal", &normal)})
    if (direction->norm() < smallest_length)
      place.at(key, "a direction")
          .refuse("[" + number_text(direction->x()) + ", " + number_text(direction->y()) + ", " +
                      number_text(direction->z()) + "]",
                  "a direction");
  tangent.normalize();
  normal.normalize();
  const double cosine = tangent.dot(normal);
  // 1e-3 allows for directions written with three digits; more is a mistake, not rounding.
  if (std::abs(cosine) > 1e-3)
    place.refuse("a normal at " +
                     number_text(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / M_PI) +
                     " degrees to the tangent",
                 "90 degrees, tangent and normal given together");
  normal = (normal - cosine * tangent).normalized();
}

}  // namespace vasorod
