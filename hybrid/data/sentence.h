// Numbers, places and words as the sentences for a user write them.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// `digits` significant digits, and no more than the number needs.
std::string number_text(double value, int digits = 6);

/// As number_text, with the digits that it takes to stay on its side of a limit: 0.599 below 0.6.
std::string number_beside(double value, double limit, int digits);

/// With `digits` after the point, as 12.50; with an exponent, as 1.250e+01.
std::string fixed_text(double value, int digits);
std::string scientific_text(double value, int digits);

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

/// The parts one after the other; floating-point numbers as number_text writes them.
template <class... Parts>
std::string joined_text(const Parts&... parts) {
  const auto text = []<class Part>(const Part& part) -> std::string {
    if constexpr (std::floating_point<Part>)
      return number_text(part);
    else if constexpr (std::integral<Part>)
      return std::to_string(part);
    else
      return std::string(part);
  };
  return (std::string() + ... + text(parts));
}

}  // namespace vasorod
