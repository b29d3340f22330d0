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

/// Text with control characters written as \n, \t or \x1b, so that it stays one line on any screen.
std::string one_line(const std::string& text);

/// One line of at most `longest` bytes of the text.
std::string shortened(const std::string& text, std::size_t longest = 60);

/// `shortened` text in quotes, as values of a file are shown in a message.
std::string in_quotes(const std::string& text);

/// "a, b or c".
std::string listed(const std::vector<std::string>& words);

/// The word of `known` that `word` was probably meant to be (at most two letters off), or nothing.
std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known);

}  // namespace vasorod
