#include "fields/base/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "fields/base/numbers/random.h"

namespace slackwater::text_test {
namespace {

template <typename... Values>
std::string printed(const char* format, Values... values) {
  char text[2048];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Numbers that round to even, are not normal, are no numbers, and any others.
std::vector<double> awkward_numbers() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers{0.0,
                              -0.0,
                              0.5,
                              1.5,
                              2.5,
                              -0.4,
                              0.125,
                              999999.5,
                              0.0001,
                              0.00001,
                              1e15,
                              1e16,
                              Limits::denorm_min(),
                              Limits::max(),
                              Limits::infinity(),
                              -Limits::infinity(),
                              Limits::quiet_NaN(),
                              -Limits::quiet_NaN()};
  Rng rng(20, "text");
  for (int i = 0; i < 2000; ++i) {
    numbers.push_back(rng.uniform(-400.0, 400.0));
    numbers.push_back(std::bit_cast<double>(rng.bits()));
  }
  return numbers;
}

TEST(Formatted, WritesNumbersAsPrintfDoes) {
  for (const double x : awkward_numbers()) {
    EXPECT_EQ(formatted("{:g} {:.4g} {:.9g} {:.17g}", x, x, x, x),
              printed("%g %.4g %.9g %.17g", x, x, x, x));
    EXPECT_EQ(formatted("{:.0f} {:.1f} {:.3f} {:.6f}", x, x, x, x),
              printed("%.0f %.1f %.3f %.6f", x, x, x, x));
    EXPECT_EQ(formatted("{:+.2f}|{:03.0f}|{:a}|{:.2e} %", x, x, x, x),
              printed("%+.2f|%03.0f|%a|%.2e %%", x, x, x, x));
    EXPECT_EQ(formatted("{:>9.1f}|{:<9.1f}|{:>+7.3f}", x, x, x),
              printed("%9.1f|%-9.1f|%+7.3f", x, x, x));
  }
  for (const int i : {-1234567, -5, 0, 7, 42, 99, 100, 2147483647})
    EXPECT_EQ(formatted("{} {:02} {:04} {:5}|{:<5}|{:+}", i, i, i, i, i, i),
              printed("%d %02d %04d %5d|%-5d|%+d", i, i, i, i, i, i));
  EXPECT_EQ(formatted("{:02X} {:016x} {}", 10U, std::uint64_t{0xfedcba}, ~std::uint64_t{0}),
            "0A 0000000000fedcba 18446744073709551615");
  EXPECT_EQ(formatted("{}", std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(Formatted, AFieldWithoutAFormIsTheShortestTextOfTheSameNumber) {
  EXPECT_EQ(formatted("{} {} {}", 0.1, 1.0 / 3.0, 1e300), "0.1 0.3333333333333333 1e+300");
  EXPECT_EQ(formatted("{:g}", 1.0 / 3.0), "0.333333");
}

TEST(Formatted, TakesTextsOfEveryKindAndOfAnyLength) {
  const std::string long_name(5000, 'x');
  EXPECT_EQ(formatted("{}", long_name), long_name);
  EXPECT_EQ(formatted("{}|{}|{}|{}|{}", "a", std::string("b"), std::string_view("c"), 'd', true),
            "a|b|c|d|true");
  EXPECT_EQ(formatted("{:>4}|{:<4}|{:.2}|{{}}", "ab", "ab", "abc"), "  ab|ab  |ab|{}");
  EXPECT_EQ(formatted("no field"), "no field");
  // No byte of a text is read as a format.
  EXPECT_EQ(formatted("{}", "{:s} %s {"), "{:s} %s {");
}

TEST(Joined, PutsTheSeparatorBetweenTexts) {
  EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "", "c"}, ", "), "a, b, , c");
  EXPECT_EQ(joined(std::vector<std::string_view>{"", "a"}, "; "), "a");
  EXPECT_EQ(joined(std::vector<std::string>{}, "; "), "");
}

TEST(LowerCase, TurnsTheLettersFromAToZAlone) {
  EXPECT_EQ(lower_case("Eastward_VELOCITY @[`{ 0É"), "eastward_velocity @[`{ 0É");
  EXPECT_TRUE(contains_ignoring_case("Quality FLAG", "flag"));
  EXPECT_TRUE(contains_ignoring_case("x", ""));
  EXPECT_FALSE(contains_ignoring_case("fla", "flag"));
}

TEST(Text, ASentenceHasACapitalAndOneFullStop) {
  EXPECT_EQ(sentence("the waves reach 2.1 m"), "The waves reach 2.1 m.");
  EXPECT_EQ(sentence("The tide is not in them."), "The tide is not in them.");
  EXPECT_EQ(sentence("is it?"), "Is it?");
  EXPECT_EQ(sentence("2 starts are left out"), "2 starts are left out.");
  EXPECT_EQ(sentence("élan"), "élan.");
  EXPECT_EQ(sentence(""), "");
}

}  // namespace
}  // namespace slackwater::text_test
