#include "data/sentence.h"

#include <algorithm>
#include <cstdio>

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

}  // namespace

std::string number_text(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string place_text(const Vec3& p, int digits) {
  return "(" + number_text(p.x(), digits) + ", " + number_text(p.y(), digits) + ", " +
         number_text(p.z(), digits) + ")";
}

std::string in_quotes(const std::string& text) {
  constexpr size_t longest = 60;
  std::string out = "\"";
  for (const char c : text.substr(0, longest))
    out += static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
  return out + (text.size() > longest ? "...\"" : "\"");
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
