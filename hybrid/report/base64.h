// Bytes as text, for what is embedded in report.html.
#pragma once

#include <string>
#include <string_view>

namespace vasorod {

std::string base64(std::string_view bytes);

}  // namespace vasorod
