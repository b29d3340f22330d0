#include <gtest/gtest.h>
#include <string>

#include "report/base64.h"

namespace vasorod {
namespace {

TEST(Base64, KnownTexts) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

// Decodes by the definition, six bits a character.
std::string decoded(const std::string& text) {
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    unsigned value = 63;  // '/'
    if (c >= 'A' && c <= 'Z') value = static_cast<unsigned>(c - 'A');
    if (c >= 'a' && c <= 'z') value = static_cast<unsigned>(c - 'a') + 26;
    if (c >= '0' && c <= '9') value = static_cast<unsigned>(c - '0') + 52;
    if (c == '+') value = 62;
    bits = bits << 6 | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255U);
    }
  }
  return bytes;
}

TEST(Base64, AnyBytesOfAnyLengthComeBack) {
  std::string bytes;
  for (int length = 0; length < 600; ++length) {
    const std::string text = base64(bytes);
    EXPECT_EQ(text.size(), (bytes.size() + 2) / 3 * 4);
    EXPECT_EQ(decoded(text), bytes) << length;
    bytes += static_cast<char>(static_cast<unsigned char>(length * 37));
  }
}

}  // namespace
}  // namespace vasorod
