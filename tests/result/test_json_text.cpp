#include <gtest/gtest.h>
#include <limits>

#include "result/json_text.h"

namespace vasorod {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, RowsOfNumbersAndWordsStayOnTheirLine) {
  const Json value = {{"name", "svc"},
                      {"force", {1, -2.5, 0}},
                      {"terms", {"rod", "contact"}},
                      {"none", Json::array()},
                      {"end", {{"at", 0.25}}}};
  EXPECT_EQ(json_text(value),
            "{\n"
            "  \"name\": \"svc\",\n"
            "  \"force\": [1, -2.5, 0],\n"
            "  \"terms\": [\"rod\", \"contact\"],\n"
            "  \"none\": [],\n"
            "  \"end\": {\n"
            "    \"at\": 0.25\n"
            "  }\n"
            "}\n");
}

TEST(JsonText, LongTextsAndListsOfListsHaveLinesOfTheirOwn) {
  const Json value = {{"notes", {std::string(25, 'x')}}, {"poses", {{1, 2}, {3, 4}}}};
  EXPECT_EQ(json_text(value),
            "{\n"
            "  \"notes\": [\n"
            "    \"" +
                std::string(25, 'x') +
                "\"\n"
                "  ],\n"
                "  \"poses\": [\n"
                "    [1, 2],\n"
                "    [3, 4]\n"
                "  ]\n"
                "}\n");
}

TEST(JsonText, AnyValueReadsBack) {
  Json value = Json::array();
  Json nested = "deep";
  for (int i = 0; i < 40; ++i) {
    nested = i % 2 ? Json{{"key \"" + std::to_string(i) + "\"\n", nested}, {"n", 1.0 / (i + 3)}}
                   : Json::array({nested, i, true, nullptr, std::string(i, 'a')});
    value.push_back(nested);
  }
  value.push_back(std::numeric_limits<double>::denorm_min());
  value.push_back("\t\\ \x01 ü");
  EXPECT_EQ(Json::parse(json_text(value)), value);
}

TEST(JsonText, WhatIsNoTextOrNumberIsReplaced) {
  const Json value = {{"bad", "\xff"}, {"nan", std::numeric_limits<double>::quiet_NaN()}};
  const Json back = Json::parse(json_text(value));
  EXPECT_EQ(back.at("bad"), "\xEF\xBF\xBD");
  EXPECT_TRUE(back.at("nan").is_null());
}

}  // namespace
}  // namespace vasorod
