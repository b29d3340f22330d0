// Pictures of kept options, for index.html: all from one side, each field with one scale.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "explore/row.h"

namespace vasorod {

/// The look of a solved result.
Look look_of(const Result& result);

/// One look for several: the side of the first, everything visible that is visible in one of them,
/// the widest ranges.
Look common_look(const std::vector<Look>& looks);

/// The colours in which options are drawn (report/draw_result.h) and their titles. Contact pressure
/// only where one of the rows has it.
std::vector<std::pair<std::string, std::string>> option_colours(const std::vector<Row>& rows);

/// {"COLOUR": "base64 of a PNG", ...}: the result in the folder, in each colour.
std::string option_pictures(const std::filesystem::path& result, const Look& look,
                            const std::vector<std::pair<std::string, std::string>>& colours);

}  // namespace vasorod
