#include <gtest/gtest.h>

#include "ingest/cf/time_code.h"
#include "tests/ingest/cf/tiny_product.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::time_decode_test {
namespace {

using netcdf::Type;
using netcdf::Writer;
using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::message_of;
using slackwater::ingest::tests::refusal_of;
using slackwater::ingest::tests::TinyProduct;
using slackwater::tests::contains;

std::string decoded(const std::string& units, double value,
                    const std::string& calendar = "standard") {
  std::vector<std::string> warnings;
  return format_utc(TimeCode::parse(units, calendar, warnings).decode(value));
}

TEST(TimeCode, ReadsTheFormsMetInTheWild) {
  // Expected values: cftime.num2date(value, units, calendar).
  EXPECT_EQ(decoded("hours since 1950-01-01", 658320), "2025-02-06T00:00:00Z");
  EXPECT_EQ(decoded("Hours since 1990-01-01", 213647), "2014-05-16T23:00:00Z");
  EXPECT_EQ(decoded("minutes since 1900-01-01 00:00:00", 64049790), "2021-10-12T00:30:00Z");
  EXPECT_EQ(decoded("hours since 1900-01-01 00:00:00.0", 1067497), "2021-10-12T01:00:00Z");
  EXPECT_EQ(decoded("seconds since 1970-01-01T00:00:00Z", 1400243400), "2014-05-16T12:30:00Z");
  EXPECT_EQ(decoded("days since 1950-01-01T00:00:00Z", 0.5), "1950-01-01T12:00:00Z");
  EXPECT_EQ(decoded("hours since 2023-07-20T10:00:00", 3), "2023-07-20T13:00:00Z");
  EXPECT_EQ(decoded("hours since 2023-7-2 6:00 UTC", 1), "2023-07-02T07:00:00Z");
  EXPECT_EQ(decoded("hours since 2023-07-20 00:00:00 +02:00", 0), "2023-07-19T22:00:00Z");
  EXPECT_EQ(decoded("hours since 2023-07-20 00:00:00 -0330", 0), "2023-07-20T03:30:00Z");
  EXPECT_EQ(decoded("nanoseconds since 1970-01-01", 1.4002434e18), "2014-05-16T12:30:00Z");
  EXPECT_EQ(decoded("seconds since 2000-01-01 00:00:00.25", 0.5), "2000-01-01T00:00:00.750Z");
  // Before October 1582 the standard calendar is Julian: two days from the proleptic one.
  EXPECT_EQ(decoded("days since 0001-01-01 00:00:00", 738886, "standard"), "2023-12-31T00:00:00Z");
  EXPECT_EQ(decoded("days since 0001-01-01 00:00:00", 738886, "proleptic_gregorian"),
            "2024-01-02T00:00:00Z");
}

TEST(TimeCode, CalendarsThatLieAreReadAsGregorianWithAWarning) {
  for (const char* calendar : {"julian", "noleap", "365_day"}) {
    std::vector<std::string> warnings;
    const TimeCode code = TimeCode::parse("hours since 1990-01-01", calendar, warnings);
    EXPECT_EQ(format_utc(code.decode(213647)), "2014-05-16T23:00:00Z");
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(contains(warnings[0], calendar));
  }
}

TEST(TimeCode, RefusesWhatHasNoDate) {
  const auto refusal = [](const std::string& units, const std::string& calendar) {
    return message_of([&] { (void)decoded(units, 1, calendar); });
  };
  EXPECT_TRUE(contains(refusal("months since 2000-01-01", "standard"), "no fixed length"));
  EXPECT_TRUE(contains(refusal("years since 2000-01-01", "standard"), "no fixed length"));
  EXPECT_TRUE(contains(refusal("hours since 2000-01-01", "360_day"), "calendar '360_day'"));
  EXPECT_TRUE(contains(refusal("hours since 1800-01-01", "julian"), "calendar 'julian'"));
  EXPECT_TRUE(contains(refusal("hours", "standard"), "no time units"));
  EXPECT_TRUE(
      contains(refusal("fortnights since 2000-01-01", "standard"), "unknown unit 'fortnights'"));
  EXPECT_TRUE(contains(refusal("hours since 2000-13-01", "standard"), "no reference date"));
  EXPECT_TRUE(contains(refusal("hours since 2001-02-29", "standard"), "no such reference date"));
  EXPECT_TRUE(
      contains(refusal("hours since 2000-01-01 25:00", "standard"), "no such reference time"));
  EXPECT_TRUE(contains(refusal("hours since yesterday", "standard"), "no reference date"));
  EXPECT_TRUE(contains(refusal("hours since 2000-01-01 12:00 somewhere", "standard"),
                       "unreadable after the date"));
}

TEST(TimeCode, FindsTheDateInsideAText) {
  EXPECT_EQ(find_date("forecast 20140516 12:00"), parse_utc("2014-05-16T12:00:00Z"));
  EXPECT_EQ(find_date("20221020"), parse_utc("2022-10-20T00:00:00Z"));
  EXPECT_EQ(find_date("2017-05-03 00:00:00"), parse_utc("2017-05-03T00:00:00Z"));
  EXPECT_EQ(find_date("2014-05-16"), parse_utc("2014-05-16T00:00:00Z"));
  EXPECT_EQ(find_date("20240301T063000Z"), parse_utc("2024-03-01T06:30:00Z"));
  EXPECT_EQ(find_date("2024-03-01T06:30:00+01:00"), parse_utc("2024-03-01T05:30:00Z"));
  EXPECT_TRUE(find_date_and_clock("2024-03-01T00:00:00Z")->has_clock);
  EXPECT_FALSE(find_date_and_clock("2024-03-01")->has_clock);
  EXPECT_EQ(find_date("analysis"), std::nullopt);
  EXPECT_EQ(find_date("version 99999999"), std::nullopt);
}

TEST(TimeAxis, DuplicateAndBackwardTimesAreRefusedWithTheirIndex) {
  TinyProduct product;
  product.time = {0, 1, 1};
  std::string message = refusal_of(product);
  EXPECT_TRUE(contains(message, "duplicate time at index 2: 2024-03-01T01:00:00Z")) << message;
  product.time = {0, 2, 1};
  message = refusal_of(product);
  EXPECT_TRUE(contains(
      message, "time runs backward at index 2: 2024-03-01T01:00:00Z after 2024-03-01T02:00:00Z"))
      << message;
}

TEST(TimeAxis, StampsThatAreNoNumbersAreRefused) {
  TinyProduct product;
  product.time = {0, std::numeric_limits<double>::quiet_NaN(), 2};
  EXPECT_TRUE(contains(refusal_of(product), "time axis 'time', index 1"));
  product.time = {0, 1, 9.96920996838687e36};
  EXPECT_TRUE(contains(refusal_of(product), "index 2"));
}

TEST(TimeAxis, GapsAreAllowedWithAWarning) {
  TinyProduct product;
  product.time = {0, 1, 2, 3, 7, 8};
  const auto found = decode(product);
  EXPECT_EQ(found.granule().grid.time.size(), 6U);
  EXPECT_TRUE(
      contains(found.warnings(), "nothing between 2024-03-01T03:00:00Z and 2024-03-01T07:00:00Z"));
}

TEST(TimeAxis, BoundsMakeMeans) {
  TinyProduct product;
  product.more = [](Writer& writer, int, const std::map<std::string, int>& d) {
    const int bounds =
        writer.variable("time_bnds", Type::float64, {d.at("time"), writer.dimension("bnds", 2)});
    writer.attribute(0, "bounds", "time_bnds");  // the time variable is the first one
    return [bounds](Writer& w) { w.write_all(bounds, std::vector<double>{-1, 0, 0, 1, 1, 2}); };
  };
  const auto found = decode(product);
  EXPECT_EQ(found.granule().grid.time[0],
            (TimeCell{parse_utc("2024-02-29T23:00:00Z"), parse_utc("2024-03-01T00:00:00Z")}));
}

TEST(TimeAxis, CellMethodsWithoutBoundsMakeCentredMeansWithAWarning) {
  TinyProduct product;
  product.more = [](Writer& writer, int variable, const std::map<std::string, int>&) {
    writer.attribute(variable, "cell_methods", "area: mean time: mean");
    return nullptr;
  };
  const auto found = decode(product);
  EXPECT_EQ(found.granule().grid.time[1],
            (TimeCell{parse_utc("2024-03-01T00:30:00Z"), parse_utc("2024-03-01T01:30:00Z")}));
  EXPECT_TRUE(contains(found.warnings(), "means without bounds"));
  product.time = {0};
  EXPECT_TRUE(contains(refusal_of(product), "its interval is unknown"));
}

TEST(TimeAxis, DailyMeansCoverTheirDayWhereverTheyAreStamped) {
  TinyProduct product;
  product.global["title"] =
      "daily mean fields from Global Ocean Physics Analysis and Forecast updated Daily";
  const TimeCell first{parse_utc("2024-03-01T00:00:00Z"), parse_utc("2024-03-02T00:00:00Z")};
  product.time = {0, 24};
  EXPECT_EQ(decode(product).granule().grid.time[0], first);
  product.time = {12, 36};
  EXPECT_EQ(decode(product).granule().grid.time[0], first);
}

TEST(StatusOfAFile, AReferenceBeforeTheValidTimesMakesAForecast) {
  TinyProduct product;
  product.global = {{"source", "MFS EAS9"}, {"bulletin_date", "20240229"}};
  Granule granule = decode(product).granule();
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, parse_utc("2024-02-29T00:00:00Z"));
  product.global["bulletin_date"] = "20250101";
  granule = decode(product).granule();
  EXPECT_EQ(granule.status, DataStatus::analysis);
  EXPECT_EQ(granule.reference_time, std::nullopt);
}

TEST(StatusOfAFile, AReferenceInTheMiddleCutsTheFileInTwo) {
  TinyProduct product;
  product.time = {-2, -1, 0, 1, 2};
  product.global = {{"source", "MFS EAS9"}, {"bulletin_date", "20240301"}};
  const auto found = decode(product);
  ASSERT_EQ(found.ingested.granules.size(), 2U);
  EXPECT_EQ(found.granule(0).status, DataStatus::analysis);
  EXPECT_EQ(found.granule(0).grid.time.size(), 3U);
  EXPECT_EQ(found.granule(1).status, DataStatus::forecast);
  EXPECT_EQ(found.field("eastward_sea_water_velocity", 1).values[0],
            static_cast<float>(product.value(3, 0, 0, 0)));
}

TEST(StatusOfAFile, TheOperatorWins) {
  TinyProduct product;
  product.global = {{"source", "MFS EAS9"}, {"bulletin_date", "20240229"}};
  IngestOptions options;
  options.as = DataStatus::analysis;
  EXPECT_EQ(decode(product, options).granule().status, DataStatus::analysis);
  options = {};
  options.issued = parse_utc("2024-02-28T06:00:00Z");
  EXPECT_EQ(decode(product, options).granule().reference_time, options.issued);
  product.global.clear();
  options = {};
  options.as = DataStatus::forecast;
  EXPECT_TRUE(contains(refusal_of(product, options), "usage: a forecast needs its issue time"));
}

}  // namespace
}  // namespace slackwater::ingest::time_decode_test
