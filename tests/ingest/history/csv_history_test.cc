#include "ingest/history/csv_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/error.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::csv_history_test {
namespace {

using slackwater::tests::source_folder;

const Vocabulary& words() {
  static const Vocabulary vocabulary =
      Vocabulary::load(source_folder() / "data" / "products" / "variables.yaml");
  return vocabulary;
}

class CsvHistory : public testing::Test {
 protected:
  HistoryOfFile read(const std::string& text, const std::vector<std::string>& wanted) {
    std::ofstream(folder_ / "a.csv", std::ios::binary) << text;
    return read_history(folder_ / "a.csv", wanted, options_, words());
  }
  std::string refusal(const std::string& text,
                      const std::vector<std::string>& wanted = {"wind_speed"}) {
    try {
      static_cast<void>(read(text, wanted));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      EXPECT_EQ(error.message().rfind((folder_ / "a.csv").string(), 0), 0U) << error.message();
      return error.message();
    }
    return "nothing was refused";
  }
  slackwater::tests::TemporaryFolder folder_;
  HistoryOptions options_;
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST_F(CsvHistory, ColumnsByCfNameUnitAndUsersWord) {
  options_.columns = {{"Hs", "sea_surface_wave_significant_height", "cm"}};
  const HistoryOfFile found = read(
      "# a comment\n"
      "time,wind_speed [kt],Hs,remark,sea_surface_wave_from_direction\r\n"
      "2002-01-01T00:00Z,10,150,\"calm, grey\",1\r\n"
      "\n"
      "2002-01-01T01:00Z,,NA,,2\r\n"
      "2002-01-01T02:00Z, 1.25e1 ,+3.5,\"a \"\"b\"\"\",3",
      {"wind_speed", "sea_surface_wave_significant_height", "Hs", "sea_water_speed"});
  ASSERT_EQ(found.series.size(), 4U);
  const HistorySeries& wind = *found.series[0];
  EXPECT_EQ(wind.unit, "kt");
  EXPECT_EQ(wind.value[0], 10);
  EXPECT_TRUE(std::isnan(wind.value[1]));
  EXPECT_EQ(wind.value[2], 12.5);
  EXPECT_EQ(wind.time[2], parse_utc("2002-01-01T02:00:00Z"));
  EXPECT_EQ(found.series[1]->unit, "cm");
  EXPECT_EQ(found.series[1]->value[2], 3.5);
  EXPECT_EQ(found.series[2]->value[0], 150) << "by the name of the column too";
  EXPECT_FALSE(found.series[3].has_value());
  EXPECT_EQ(found.columns.size(), 5U);
}

TEST_F(CsvHistory, ASpeedIsMadeOfItsComponents) {
  const HistoryOfFile found = read(
      "time,eastward_wind,northward_wind\n"
      "2002-01-01T00:00Z,3,-4\n2002-01-01T01:00Z,3,\n",
      {"wind_speed"});
  EXPECT_EQ(found.series[0]->value[0], 5);
  EXPECT_TRUE(std::isnan(found.series[0]->value[1])) << "half a wind is none";
  EXPECT_EQ(found.series[0]->standard_name, "wind_speed");
}

TEST_F(CsvHistory, OffsetsAreTakenOffAndUtcIsAssumedOnlyWhereAsked) {
  const HistoryOfFile found =
      read("time,wind_speed\n2002-07-01T02:00+02:00,1\n2002-07-01T03:00+02:00,1\n", {"wind_speed"});
  EXPECT_EQ(found.series[0]->time[0], parse_utc("2002-07-01T00:00:00Z"));
  const std::string local = "datetime,wind_speed\n2002-07-01T02:00,1\n";
  EXPECT_SAYS(refusal(local), "line 2");
  EXPECT_SAYS(refusal(local), "without a zone");
  EXPECT_SAYS(refusal(local), "--assume-utc");
  options_.assume_utc = true;
  EXPECT_EQ(read(local, {"wind_speed"}).series[0]->time[0], parse_utc("2002-07-01T02:00:00Z"));
}

TEST_F(CsvHistory, TheRepeatedHourOfAutumnIsADuplicate) {
  options_.assume_utc = true;
  EXPECT_SAYS(refusal("time,wind_speed\n2002-10-27T01:00,1\n2002-10-27T02:00,1\n"
                      "2002-10-27T02:00,1\n"),
              "line 4: duplicate time 2002-10-27T02:00:00Z");
  EXPECT_SAYS(refusal("time,wind_speed\n2002-10-27T02:00,1\n2002-10-27T01:00,1\n"),
              "line 3: time runs backward");
}

TEST_F(CsvHistory, ValuesBeyondBeliefAreMissingAndTold) {
  std::string text = "time,wind_speed\n";
  for (int hour = 0; hour < 24; ++hour)
    text += "2002-01-01T" + std::string(hour < 10 ? "0" : "") + std::to_string(hour) + ":00Z," +
            (hour == 3 ? "-500" : "7") + "\n";
  const HistoryOfFile found = read(text, {"wind_speed"});
  EXPECT_TRUE(std::isnan(found.series[0]->value[3]));
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_SAYS(found.warnings[0], "1 of 24 values");
  EXPECT_SAYS(found.warnings[0], "-500 at 2002-01-01T03:00:00Z");
  EXPECT_SAYS(refusal("time,wind_speed\n2002-01-01T00:00Z,1e3\n2002-01-01T01:00Z,2e3\n"),
              "correct the unit");
}

TEST_F(CsvHistory, BadTablesAreRefusedWithTheLineAndWhatIsWrong) {
  const std::string head = "time,wind_speed\n";
  EXPECT_SAYS(refusal(head + "2002-01-01T00:00Z,1\n2002-01-01T01:00Z,calm\n"),
              "line 3: column 'wind_speed': found 'calm'");
  EXPECT_SAYS(refusal(head + "2002-01-01T00:00Z,\"7,5\"\n"), "7.5");
  EXPECT_SAYS(refusal(head + "2002-01-01T00:00Z,1,2\n"), "line 2: found 3 cells, expected 2");
  EXPECT_SAYS(refusal(head + "yesterday,1\n"), "found 'yesterday' where a time was expected");
  EXPECT_SAYS(refusal(head + "2002-01-01T00:00Z,\"1\n"), "quote that is not closed");
  EXPECT_SAYS(refusal("time;wind_speed\n2002-01-01T00:00Z;1\n"), "commas");
  EXPECT_SAYS(refusal("when,wind_speed\n2002-01-01T00:00Z,1\n"), "--time-column");
  EXPECT_SAYS(refusal(""), "the file is empty");
  EXPECT_SAYS(refusal(std::string("time,wind_speed\n\0\1\2", 20)), "no text");
  options_.time_column = "tme";
  EXPECT_SAYS(refusal(head), "did you mean 'time'");
}

TEST_F(CsvHistory, UnitsThatAreNoneOfTheQuantityAreRefused) {
  options_.columns = {{"w", "wind_speed", "s"}};
  EXPECT_SAYS(refusal("time,w\n2002-01-01T00:00Z,1\n"), "found unit 's'");
  options_.columns = {{"w", "visibility_in_air", ""}};
  EXPECT_SAYS(refusal("time,w\n2002-01-01T00:00Z,1\n", {"visibility_in_air"}),
              "--column 'w=visibility_in_air:UNIT'");
}

TEST_F(CsvHistory, TwoColumnsOfOneQuantityAreToldApartByTheirNames) {
  options_.columns = {{"w10", "wind_speed", "m s-1"}, {"w100", "wind_speed", "m s-1"}};
  const std::string text = "time,w10,w100\n2002-01-01T00:00Z,1,2\n";
  EXPECT_SAYS(refusal(text), "'w10' and 'w100'");
  EXPECT_EQ(read(text, {"w100"}).series[0]->value[0], 2);
}

TEST_F(CsvHistory, OnlyWhatIsWantedIsRead) {
  EXPECT_EQ(read("time,wind_speed,sea_water_speed\n2002-01-01T00:00Z,5,rubbish\n", {"wind_speed"})
                .series[0]
                ->value[0],
            5);
}

TEST_F(CsvHistory, FoldersAndNothingAreRefused) {
  try {
    static_cast<void>(read_history(folder_ / "none.csv", {}, options_, words()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
  }
  EXPECT_THROW(static_cast<void>(read_history(folder_.path(), {}, options_, words())), Error);
}

TEST(NamedColumn, NameStandardNameAndUnit) {
  const NamedColumn named = parse_named_column("wind speed=wind_speed:m s-1");
  EXPECT_EQ(named.column, "wind speed");
  EXPECT_EQ(named.standard_name, "wind_speed");
  EXPECT_EQ(named.unit, "m s-1");
  EXPECT_EQ(parse_named_column("a:b=c").column, "a:b");
  EXPECT_EQ(parse_named_column("a=b").unit, "");
  for (const char* text : {"", "a", "=b", "a=", "a=b:", "a=:m"})
    EXPECT_THROW(static_cast<void>(parse_named_column(text)), Error) << text;
}

}  // namespace
}  // namespace slackwater::ingest::csv_history_test
