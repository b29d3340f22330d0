// JSON for human readers: indented, with rows of numbers or words on one line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace vasorod {

std::string json_text(const nlohmann::ordered_json& value);

}  // namespace vasorod
