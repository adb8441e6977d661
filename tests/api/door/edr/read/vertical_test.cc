#include "api/door/edr/read/vertical.h"

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::vertical_test {
namespace {

using tests::contains;
using tests::refusal_of;

std::string refusal(std::string_view text) {
  return refusal_of([&] { (void)parse_vertical(text); });
}

TEST(Vertical, EveryFormIsRead) {
  const std::pair<const char*, VerticalQuery> forms[] = {
      {"10", Levels{10}},
      {"-2.5", Levels{-2.5}},
      {"0,5,10", Levels{0, 5, 10}},
      {"10,-5,0,10", Levels{-5, 0, 10}},
      {"0/50", LevelRange{0, 50}},
      {"-50/-10", LevelRange{-50, -10}},
      {"5/5", LevelRange{5, 5}},
      {"R3/100/50", Levels{100, 150, 200}},
      {"r3/0/-10", Levels{-20, -10, 0}},
      {"R1/7/0", Levels{7}},
  };
  for (const auto& [text, expected] : forms) EXPECT_EQ(parse_vertical(text), expected) << text;
  const auto twenty = std::get<Levels>(parse_vertical("R20/100/50"));
  EXPECT_EQ(twenty.size(), 20U);
  EXPECT_EQ(twenty.front(), 100);
  EXPECT_EQ(twenty.back(), 1050);
}

TEST(Vertical, WhatIsNoLevelIsRefused) {
  for (const char* text : {"",
                           ",",
                           "1,",
                           ",1",
                           "1,,2",
                           "/",
                           "1/",
                           "/1",
                           "../5",
                           "5/..",
                           "1/2/3",
                           "R",
                           "R3",
                           "R3/1",
                           "R3/1/2/3",
                           "R0/1/2",
                           "R-3/1/2",
                           "R3.5/1/2",
                           "Rx/1/2",
                           "R3//2",
                           "R/1/2",
                           "nan",
                           "inf",
                           "-inf",
                           "0x10",
                           "1e400",
                           "ten",
                           "10m",
                           "1 0",
                           "1;2",
                           "R99999999999999999999/0/1"}) {
    EXPECT_TRUE(contains(refusal(text), "z: found '")) << text;
  }
  EXPECT_TRUE(contains(refusal(std::string_view("1\0", 2)), "a level (10)"));
}

TEST(Vertical, WhatCannotBeIsRefusedWithTheReason) {
  EXPECT_TRUE(contains(refusal("50/0"), "the smaller level first"));
  EXPECT_TRUE(contains(refusal("R3/5/0"), "a step that is not 0"));
  EXPECT_TRUE(contains(refusal("20001"), "within 20000 m"));
  EXPECT_TRUE(contains(refusal("-1e30,0"), "within 20000 m"));
  EXPECT_TRUE(contains(refusal("R1000/0/1000"), "a sequence that stays"));
  EXPECT_TRUE(contains(refusal("R1001/0/1"), "at most 1000 levels"));
  EXPECT_EQ(std::get<Levels>(parse_vertical("R1000/0/1")).size(), max_levels);
}

TEST(Vertical, LimitsHoldForLists) {
  std::string many = "0";
  for (std::size_t i = 1; i <= max_levels; ++i) many.append(",").append(std::to_string(i));
  EXPECT_TRUE(contains(refusal(many), "at most 1000 levels"));
  EXPECT_TRUE(contains(refusal(std::string(1'000'000, ',')), "bytes"));
  EXPECT_TRUE(contains(refusal(std::string(30'000, '/')), "a level (10)"));
}

}  // namespace
}  // namespace slackwater::api::edr::vertical_test
