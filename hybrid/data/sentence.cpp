#include "data/sentence.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace vasorod {
namespace {

// Edit distance, for suggestions.
int letters_off(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const int replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

// As printf does in the C locale, whatever the program's locale is.
std::string written(double value, std::chars_format format, int digits) {
  std::array<char, 400> text;  // the largest double has 309 digits before the point
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
  return error == std::errc() ? std::string(text.data(), end) : std::string("?");
}

}  // namespace

std::string number_text(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

std::string number_beside(double value, double limit, int digits) {
  std::string text = number_text(value, digits);
  constexpr int exact = 17;
  while (digits < exact) {
    const double seen = std::strtod(text.c_str(), nullptr);
    if ((seen < limit) == (value < limit) && (seen > limit) == (value > limit)) break;
    text = number_text(value, ++digits);
  }
  return text;
}

std::string fixed_text(double value, int digits) {
  return written(value, std::chars_format::fixed, digits);
}

std::string scientific_text(double value, int digits) {
  return written(value, std::chars_format::scientific, digits);
}

std::string place_text(const Vec3& p, int digits) {
  return "(" + number_text(p.x(), digits) + ", " + number_text(p.y(), digits) + ", " +
         number_text(p.z(), digits) + ")";
}

std::string one_line(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto after = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool second_set = byte == 0xC2 && after >= 0x80 && after < 0xA0;  // U+0080 to U+009F
    if (byte >= 32 && byte != 127 && !second_set) {
      out += text[i];
    } else if (byte == '\n' || byte == '\t' || byte == '\r') {
      out += byte == '\n' ? "\\n" : byte == '\t' ? "\\t" : "\\r";
    } else {
      char hex[8];
      std::snprintf(hex, sizeof hex, "\\x%02x", second_set ? after : byte);
      out += hex;
      i += second_set ? 1 : 0;
    }
  }
  return out;
}

std::string shortened(const std::string& text, std::size_t longest) {
  if (text.size() <= longest) return one_line(text);
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xC0) == 0x80)
    --longest;  // whole characters of UTF-8
  return one_line(text.substr(0, longest)) + "...";
}

std::string in_quotes(const std::string& text) {
  return "\"" + shortened(text) + "\"";
}

std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return out;
}

std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known) {
  std::optional<std::string> best;
  int least = 3;
  if (word.size() > 100) return best;
  for (const std::string& candidate : known) {
    const int off = letters_off(word, candidate);
    if (off < least && off < static_cast<int>(candidate.size())) {
      least = off;
      best = candidate;
    }
  }
  return best;
}

}  // namespace vasorod
