// Numbers, places and words as the sentences for a user write them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// `digits` significant digits, and no more than the number needs.
std::string number_text(double value, int digits = 6);

/// "(x, y, z)", fine enough to find the place in the file.
std::string place_text(const Vec3& p, int digits = 6);

/// Text as it is shown in a message: in quotes, shortened, and without what would break the line.
std::string in_quotes(const std::string& text);

/// "a, b or c".
std::string listed(const std::vector<std::string>& words);

/// The word of `known` that `word` was probably meant to be (at most two letters off), or nothing.
std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known);

}  // namespace vasorod
