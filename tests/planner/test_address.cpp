#include <gtest/gtest.h>
#include <set>

#include "planner/address.h"

namespace vasorod::planner {
namespace {

TEST(Address, ATokenIs32DigitsAndNew) {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; ++k) {
    const std::string token = random_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos) << token;
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
}

TEST(Address, SecretsAreTheSameOrNot) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  EXPECT_TRUE(same_secret("", ""));
  for (const char* other : {"", "a", "ab", "abd", "bbc", "abcd", "abcabc"}) {
    EXPECT_FALSE(same_secret("abc", other)) << other;
    EXPECT_FALSE(same_secret(other, "abc")) << other;
  }
}

TEST(Address, OnlyItsOwnNamesAreItsHost) {
  const Address address{8123, "0123"};
  EXPECT_EQ(address.url(), "http://127.0.0.1:8123/0123/");
  EXPECT_TRUE(address.is_host("127.0.0.1:8123"));
  EXPECT_TRUE(address.is_host("localhost:8123"));
  EXPECT_TRUE(address.is_origin("http://127.0.0.1:8123"));
  EXPECT_TRUE(address.is_origin("http://localhost:8123"));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:812", "127.0.0.1:81234", "evil:8123",
                           "127.0.0.1:8123.evil", "evil127.0.0.1:8123", "[::1]:8123"}) {
    EXPECT_FALSE(address.is_host(host)) << host;
    EXPECT_FALSE(address.is_origin(std::string("http://") + host)) << host;
  }
  EXPECT_TRUE((Address{80, "0123"}).is_origin("http://localhost"));
  for (const char* origin :
       {"null", "", "https://127.0.0.1:8123", "http://127.0.0.1:8123/", "file://"})
    EXPECT_FALSE(address.is_origin(origin)) << origin;
}

TEST(Address, WhatIsBelowTheToken) {
  const Address address{8123, "0123"};
  EXPECT_EQ(address.below_token("/0123/"), "");
  EXPECT_EQ(address.below_token("/0123/api/x"), "api/x");
  for (const char* path : {"", "/", "/0123", "0123/", "/0124/", "//0123/", "/01234/", "/x/0123/"})
    EXPECT_FALSE(address.below_token(path)) << path;
}

}  // namespace
}  // namespace vasorod::planner
