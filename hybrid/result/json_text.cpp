#include "result/json_text.h"

#include <algorithm>

namespace vasorod {

namespace {

using Json = nlohmann::ordered_json;

// Shortest digits that read back to the same double; null for numbers that are not finite. Bytes
// that are not UTF-8 are replaced.
std::string scalar_text(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool on_one_line(const Json& value) {
  return value.empty() ||
         (value.is_array() && std::none_of(value.begin(), value.end(), [](const Json& entry) {
            return entry.is_structured() ||
                   (entry.is_string() && entry.get_ref<const std::string&>().size() > 24);
          }));
}

void append(std::string& text, const Json& value, std::size_t indent) {
  if (!value.is_structured()) {
    text += scalar_text(value);
    return;
  }
  const bool inline_row = on_one_line(value), object = value.is_object();
  const std::string line = inline_row ? "" : "\n" + std::string(indent + 2, ' ');
  text += object ? '{' : '[';
  bool first = true;
  for (auto entry = value.begin(); entry != value.end(); ++entry) {
    if (!first) text += inline_row ? ", " : ",";
    first = false;
    text += line;
    if (object) text += scalar_text(entry.key()) + ": ";
    append(text, *entry, indent + 2);
  }
  if (!inline_row) text += "\n" + std::string(indent, ' ');
  text += object ? '}' : ']';
}

}  // namespace

std::string json_text(const Json& value) {
  std::string text;
  append(text, value, 0);
  return text + "\n";
}

}  // namespace vasorod
