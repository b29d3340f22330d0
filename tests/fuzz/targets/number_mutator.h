// Mutates scenes: bytes are seldom YAML afterwards, so most mutations replace one number or word
// by another and leave the rest as it is.
#pragma once

#include <array>
#include <cctype>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "fuzz/targets/fuzz_input.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace vasorod::fuzz {

struct Word {
  std::size_t begin, end;
};

inline std::vector<Word> words_of(std::string_view text, bool numbers) {
  const auto part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' ||
           c == '_';
  };
  std::vector<Word> words;
  for (std::size_t at = 0; at < text.size();) {
    if (!part(text[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && part(text[at])) ++at;
    const char first = text[begin];
    const bool number = std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '-' ||
                        first == '.' || first == '+';
    if (number == numbers) words.push_back({begin, at});
  }
  return words;
}

inline std::string other_number(const std::string& before, std::minstd_rand& random) {
  static const std::array<const char*, 30> fixed{
      "0",    "1",     "-1",   "2",   "0.5",   "-0.5",  "1e-9", "1e9",   "-1e9", "1e-30",
      "1e30", "-1e30", "1e-3", "1e3", "0.3",   "0.45",  "0.5",  "0.499", "6",    "8",
      "90",   "180",   "-180", "360", "719.5", "1e308", ".inf", "1e-7",  "5000", "20000"};
  if (random() % 2 == 0) return fixed[random() % fixed.size()];
  const double value = std::strtod(before.c_str(), nullptr);
  static const std::array<double, 10> factors{-1, 0.1, 10, 0.5, 2, 0.9, 1.1, 1e-3, 1e3, 1.001};
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value * factors[random() % factors.size()]);
  return text;
}

/// The scene with one to three numbers or words replaced, or libFuzzer's own mutation.
inline std::size_t mutate_scene(std::uint8_t* data, std::size_t size, std::size_t most,
                                unsigned seed) {
  std::minstd_rand random(seed);
  if (random() % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  std::string text(text_of(data, size));
  for (unsigned k = 1 + static_cast<unsigned>(random() % 3); k > 0; --k) {
    const bool numbers = random() % 4 != 0;
    const std::vector<Word> words = words_of(text, numbers);
    if (words.empty()) return LLVMFuzzerMutate(data, size, most);
    const Word at = words[random() % words.size()], from = words[random() % words.size()];
    const std::string before = text.substr(at.begin, at.end - at.begin);
    const std::string after =
        numbers ? other_number(before, random) : text.substr(from.begin, from.end - from.begin);
    text.replace(at.begin, at.end - at.begin, after);
  }
  if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

}  // namespace vasorod::fuzz
