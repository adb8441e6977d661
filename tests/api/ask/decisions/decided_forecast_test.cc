#include "api/ask/decisions/decided_forecast.h"

#include <gtest/gtest.h>

#include "api/ask/decisions/line_of_text.h"
#include "fields/base/error.h"

namespace slackwater::tests::decided_forecast_test {
namespace {

using namespace slackwater::api;
using std::chrono::hours;

const UtcTime midnight = parse_utc("2025-03-10T00:00:00Z");

/// Issued so many hours after midnight, valid for three days from then on.
store::ForecastRow row(std::int64_t id, int issued_h) {
  store::ForecastRow forecast;
  forecast.id = id;
  forecast.site_id = "farm";
  forecast.issued = midnight + hours(issued_h);
  forecast.valid_from = midnight;
  forecast.valid_to = midnight + hours(72);
  return forecast;
}

std::int64_t chosen(const std::vector<store::ForecastRow>& rows, int start_h, int recorded_h) {
  return decided_forecast(rows, midnight + hours(start_h), midnight + hours(recorded_h)).id;
}

std::string refusal(const std::vector<store::ForecastRow>& rows, int start_h, int recorded_h) {
  try {
    static_cast<void>(chosen(rows, start_h, recorded_h));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    return error.message();
  }
  ADD_FAILURE() << "chosen";
  return {};
}

TEST(DecidedForecast, IsTheLatestThatWasThereWhenItWasDecided) {
  const std::vector<store::ForecastRow> rows{row(1, 5), row(2, 8), row(3, 8), row(4, 12)};
  EXPECT_EQ(chosen(rows, 20, 6), 1);
  EXPECT_EQ(chosen(rows, 20, 8), 3) << "issued at that moment, filed last";
  EXPECT_EQ(chosen(rows, 20, 13), 4);
}

// Recorded late: what was issued after the start told nobody whether to begin.
TEST(DecidedForecast, WasIssuedBeforeTheStart) {
  const std::vector<store::ForecastRow> rows{row(1, 5), row(2, 12)};
  EXPECT_EQ(chosen(rows, 7, 40), 1);
  EXPECT_NE(refusal({row(2, 12)}, 7, 40).find("the first was issued later"), std::string::npos);
}

TEST(DecidedForecast, CoversTheStart) {
  store::ForecastRow shorter = row(2, 8);
  shorter.valid_to = midnight + hours(24);
  EXPECT_EQ(chosen({row(1, 5), shorter}, 20, 9), 2);
  EXPECT_EQ(chosen({row(1, 5), shorter}, 24, 9), 1) << "its end is no start";
  const std::string why = refusal({shorter}, 30, 9);
  EXPECT_NE(why.find("holds from 2025-03-10T00:00:00Z to 2025-03-11T00:00:00Z"), std::string::npos)
      << why;
}

TEST(DecidedForecast, IsNoHindcast) {
  store::ForecastRow hindcast = row(2, 8);
  hindcast.origin = ForecastOrigin::hindcast;
  EXPECT_EQ(chosen({row(1, 5), hindcast}, 20, 9), 1);
  EXPECT_NE(refusal({hindcast}, 20, 9).find("hindcasts alone"), std::string::npos);
}

TEST(LineOfText, IsTakenAsItIsWithoutItsBlankEnds) {
  EXPECT_EQ(line_of_text("--by", " \tÅsa O'Neil <a@b>  ", 20), "Åsa O'Neil <a@b>");
  EXPECT_EQ(line_of_text("--by", "日本\U0001F30A", 3), "日本\U0001F30A")
      << "characters are counted";
  EXPECT_EQ(line_of_text("--by", "   ", 3), "");
}

TEST(LineOfText, RefusesWhatWouldShowAsSomethingElse) {
  const auto is_refused = [](std::string_view text) {
    try {
      static_cast<void>(line_of_text("--by", text, 20));
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage && error.message().starts_with("--by: found ");
    }
    return false;
  };
  using namespace std::string_view_literals;
  for (const std::string_view text : {"a\nb"sv, "a\rb"sv, "a\0b"sv, "a\x1b[31mb"sv,
                                      "a\x7f"
                                      "b"sv,
                                      "a\xc2\x85"
                                      "b"sv,  // next line
                                      "a\xe2\x80\xa8"
                                      "b"sv,  // line separator
                                      "a\xe2\x80\xae"
                                      "b"sv,  // right-to-left override
                                      "a\xe2\x81\xa6"
                                      "b"sv})  // isolate
    EXPECT_TRUE(is_refused(text)) << text;
  // RFC 3629: lone bytes, overlong forms, a surrogate, beyond U+10FFFF, cut short.
  for (const std::string_view text :
       {"\xff"sv, "\x80"sv, "\xc0\xaf"sv, "\xe0\x80\xaf"sv, "\xf0\x80\x80\xaf"sv, "\xed\xa0\x80"sv,
        "\xf4\x90\x80\x80"sv, "a\xe2\x82"sv, "\xc3("sv})
    EXPECT_TRUE(is_refused(text)) << text;
  EXPECT_TRUE(is_refused("twenty-one characters"));
  EXPECT_FALSE(is_refused("only twenty of them."));
}

}  // namespace
}  // namespace slackwater::tests::decided_forecast_test
