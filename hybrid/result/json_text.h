// JSON laid out for people: indented, but a row of numbers or words stays on its line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace vasorod {

std::string json_text(const nlohmann::ordered_json& value);

}  // namespace vasorod
