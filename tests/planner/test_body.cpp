#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

TEST(Body, GoodValuesAreRead) {
  const Body body(R"({"n": 2.5, "v": [1, -2, 3e2], "t": "text", "f": true, "w": ["a", "b"],
                      "o": {"i": 3}, "null": null})");
  EXPECT_EQ(body.number("n", 0, 3), 2.5);
  EXPECT_EQ(body.vec3("v"), Vec3(1, -2, 300));
  EXPECT_EQ(body.text("t"), "text");
  EXPECT_TRUE(body.flag("f", false));
  EXPECT_TRUE(body.flag("absent", true));
  EXPECT_EQ(body.words("w"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(body.object("o").integer("i", 0, 9), 3);
  EXPECT_FALSE(body.has("null"));
  EXPECT_FALSE(body.optional_text("null"));
  EXPECT_TRUE(Body("").words("w").empty());
}

TEST(Body, WrongValuesAreNamed) {
  const Body body(R"({"n": 2.5, "v": [1, 2], "big": [1e200, 0, 0], "t": 3, "o": {"i": 1.5}})");
  const auto expect = [](const char* word, auto&& work) {
    const Refusal refusal = refusal_of(work);
    EXPECT_EQ(refusal.status, 400);
    EXPECT_NE(std::string(refusal.what()).find(word), std::string::npos) << refusal.what();
    EXPECT_NE(std::string(refusal.what()).find("expected"), std::string::npos) << refusal.what();
  };
  expect("n: found 2.5", [&] { body.number("n", 0, 2); });
  expect("absent: found nothing", [&] { body.number("absent", 0, 2); });
  expect("v: found [1,2]", [&] { body.vec3("v"); });
  expect("big", [&] { body.vec3("big"); });
  expect("t: found 3", [&] { body.text("t"); });
  expect("o.i: found 1.5", [&] { body.object("o").integer("i", 0, 9); });
  expect("t", [&] { body.object("t"); });
  expect("\"n\"", [&] { body.check_keys({"v", "t"}); });
}

TEST(Body, WhatIsNoObjectIsRefused) {
  for (const char* text : {"{", "[]", "3", "\"x\"", "null", "{\"a\":}", "{\"a\":NaN}", "\x01",
                           "{\"a\": 1e999}", "{} {}", "\xff\xfe"})
    EXPECT_EQ(refusal_of([&] { Body body{std::string(text)}; }).status, 400) << text;
  const std::string deep(1000000, '[');
  EXPECT_NE(std::string(refusal_of([&] { Body body{deep}; }).what()).find("nested"),
            std::string::npos);
  // Brackets in a text are not nesting.
  EXPECT_EQ(Body("{\"t\": \"" + std::string(100, '[') + "\\\"[\"}").text("t").size(), 102U);
}

TEST(Body, PointsAreListsOfThree) {
  Points points(2, 3);
  points << 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(json_of(points).dump(), "[[1.0,2.0,3.0],[4.0,5.0,6.0]]");
}

}  // namespace
}  // namespace vasorod::planner
