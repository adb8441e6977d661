#include "api/door/edr/write/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace slackwater::api::edr::json_text_test {
namespace {

std::string value(double v) {
  std::string out;
  append_value(out, v);
  return out;
}

std::string coordinate(double v) {
  std::string out;
  append_coordinate(out, v);
  return out;
}

std::string text(std::string_view t) {
  std::string out;
  append_string(out, t);
  return out;
}

TEST(JsonText, ValuesHaveSixSignificantDigits) {
  EXPECT_EQ(value(0), "0");
  EXPECT_EQ(value(-0.0), "0");
  EXPECT_EQ(value(1), "1");
  EXPECT_EQ(value(-12.5), "-12.5");
  EXPECT_EQ(value(0.1234567), "0.123457");
  EXPECT_EQ(value(-0.00001234567), "-0.0000123457");
  EXPECT_EQ(value(123456.4), "123456");
  EXPECT_EQ(value(999999.7), "1000000");
  EXPECT_EQ(value(0.9999999), "1");
  EXPECT_EQ(value(99999.96), "100000");
  EXPECT_EQ(value(1e-5), "0.00001");
  EXPECT_EQ(value(1.234567e-7), "1.23457e-07");
  EXPECT_EQ(value(1e300), "1e+300");
  EXPECT_EQ(value(5e-324), "4.94066e-324");
}

TEST(JsonText, WhatIsNotFiniteIsNull) {
  EXPECT_EQ(value(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(value(std::numeric_limits<double>::infinity()), "null");
  EXPECT_EQ(value(-std::numeric_limits<double>::infinity()), "null");
}

/// Oracle: printf. Both are within half a unit of the sixth digit, and agree but for ties.
TEST(JsonText, ValuesOfAnySizeAgreeWithPrintf) {
  std::mt19937_64 random(7);
  std::size_t same = 0;
  constexpr std::size_t count = 100'000;
  for (std::size_t i = 0; i < count; ++i) {
    const double fraction = static_cast<double>(random() >> 11U) * 0x1p-53;
    const double exponent = static_cast<double>(random() % 24) - 12;
    const double v = (random() % 2 == 0 ? 1 : -1) * (0.1 + fraction) * std::pow(10, exponent);
    char printed[40];
    std::snprintf(printed, sizeof printed, "%.6g", v);
    const double ours = nlohmann::json::parse(value(v)).get<double>();
    same += ours == std::strtod(printed, nullptr) ? 1 : 0;
    const double unit = std::pow(10, std::floor(std::log10(std::abs(v))) - 5);
    ASSERT_LE(std::abs(ours - v), 0.5000001 * unit) << v << " became " << value(v);
  }
  EXPECT_GT(same, count - 3);
}

TEST(JsonText, CoordinatesHaveSevenDecimals) {
  EXPECT_EQ(coordinate(0), "0");
  EXPECT_EQ(coordinate(-180), "-180");
  EXPECT_EQ(coordinate(57.25), "57.25");
  EXPECT_EQ(coordinate(-2.45000004), "-2.45");
  EXPECT_EQ(coordinate(-2.45000006), "-2.4500001");
  EXPECT_EQ(coordinate(-1e-9), "0");
  EXPECT_EQ(coordinate(0.0000001), "0.0000001");
  EXPECT_EQ(coordinate(20000), "20000");
  EXPECT_EQ(coordinate(179.99999999), "180");
}

TEST(JsonText, StringsComeBackAsTheyWere) {
  std::string ascii;
  for (char c = 1; c < 127; ++c) ascii += c;
  for (const std::string& each : {std::string(), ascii, std::string("\0x", 2), std::string("\x7f"),
                                  std::string("Ærø © 海 🌊"), std::string("</script>\"\\")}) {
    EXPECT_EQ(nlohmann::json::parse(text(each)).get<std::string>(), each);
  }
}

TEST(JsonText, BytesThatAreNotUtf8AreReplaced) {
  for (const char* broken : {"\xff", "\xc3", "\xc0\xaf", "\xe2\x82", "\xed\xa0\x80",
                             "\xf4\x90\x80\x80", "\xe0\x80\xaf", "\x80"}) {
    const auto parsed = nlohmann::json::parse(text(std::string("a") + broken + "b"));
    const auto read = parsed.get<std::string>();
    EXPECT_TRUE(read.starts_with("a\xef\xbf\xbd") && read.ends_with("b")) << read;
  }
  std::mt19937_64 random(8);
  for (int i = 0; i < 2000; ++i) {
    std::string noise;
    for (int byte = 0; byte < 12; ++byte) noise += static_cast<char>(random() & 0xFFU);
    EXPECT_TRUE(nlohmann::json::accept(text(noise)));
  }
}

TEST(JsonText, TimesAreThoseOfFormatUtc) {
  std::mt19937_64 random(9);
  for (int i = 0; i < 1000; ++i) {
    const auto seconds = static_cast<std::int64_t>(random() % 300'000'000'000ULL) - 60'000'000'000;
    for (const std::int64_t ms : {0, 250}) {
      const UtcTime time{std::chrono::milliseconds(seconds * 1000 + ms)};
      std::string out;
      append_time(out, time);
      ASSERT_EQ(out, format_utc(time));
    }
  }
}

}  // namespace
}  // namespace slackwater::api::edr::json_text_test
