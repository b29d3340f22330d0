// Bytes as text, for the data embedded in report.html.
#pragma once

#include <string>
#include <string_view>

namespace vasorod {

std::string base64(std::string_view bytes);

}  // namespace vasorod
