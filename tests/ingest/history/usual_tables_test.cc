#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/error.h"
#include "ingest/history/ndbc.h"
#include "ingest/history/read_history.h"
#include "ingest/history/sentinels.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

// Tables as NDBC, ERDDAP, THREDDS and the Copernicus toolbox write them, and the numbers that stand
// in them for "not measured".

namespace slackwater::tests::usual_tables_test {
namespace {

using namespace ingest;

const Vocabulary& words() {
  static const Vocabulary vocabulary =
      Vocabulary::load(source_folder() / "data" / "products" / "variables.yaml");
  return vocabulary;
}

constexpr const char* height = "sea_surface_wave_significant_height";

class UsualTables : public testing::Test {
 protected:
  HistoryOfFile read(const std::string& text, const std::vector<std::string>& wanted) {
    std::ofstream(folder_ / "a.csv", std::ios::binary) << text;
    return read_history(folder_ / "a.csv", wanted, options_, words());
  }
  std::string refusal(const std::string& text, const std::vector<std::string>& wanted) {
    try {
      static_cast<void>(read(text, wanted));
    } catch (const Error& error) {
      return error.message();
    }
    return "nothing was refused";
  }
  TemporaryFolder folder_;
  HistoryOptions options_;
};

std::size_t missing_in(const HistorySeries& series) {
  std::size_t missing = 0;
  for (const double value : series.value) missing += std::isnan(value) ? 1U : 0U;
  return missing;
}

/// The same numbers, missing where the other's are.
void expect_same(const HistorySeries& found, const HistorySeries& expected) {
  ASSERT_EQ(found.time, expected.time);
  for (std::size_t t = 0; t < expected.value.size(); ++t) {
    ASSERT_EQ(std::isnan(found.value[t]), std::isnan(expected.value[t])) << t;
    if (!std::isnan(expected.value[t])) ASSERT_EQ(found.value[t], expected.value[t]) << t;
  }
}

// --- NDBC ---

// The newest first, as in realtime2; MM, and the numbers for missing of each column.
const std::string realtime =
    "#YY  MM DD hh mm WDIR WSPD GST  WVHT   DPD   APD MWD   PRES  ATMP  WTMP  DEWP  VIS PTDY  "
    "TIDE\n"
    "#yr  mo dy hr mn degT m/s  m/s     m   sec   sec degT   hPa  degC  degC  degC  nmi  hPa    "
    "ft\n"
    "2025 03 01 02 50 230  6.0  8.0   1.2     7   5.1 220 1015.0   8.0   9.0    MM   MM   MM    "
    "MM\n"
    "2025 03 01 01 50 230   MM   MM    MM    MM    MM  MM 1015.1   8.0 999.0    MM   MM   MM    "
    "MM\n"
    "2025 03 01 00 50 230  5.0  8.0   1.0     9   5.1 220 1015.0   8.0   9.5    MM   MM   MM    "
    "MM\n";

TEST_F(UsualTables, NdbcsRealtimeTextIsTurnedRound) {
  const HistoryOfFile found =
      read(realtime,
           {"wind_speed", height, "sea_surface_wave_period_at_variance_spectral_density_maximum",
            "sea_surface_wave_from_direction_at_variance_spectral_density_maximum",
            "sea_water_temperature", "wind_from_direction"});
  ASSERT_TRUE(found.series[0] && found.series[1] && found.series[2] && found.series[3] &&
              found.series[4] && found.series[5]);
  const HistorySeries& wind = *found.series[0];
  EXPECT_EQ(wind.unit, "m s-1");
  ASSERT_EQ(wind.time.size(), 3U);
  EXPECT_EQ(wind.time.front(), parse_utc("2025-03-01T00:50:00Z"));
  EXPECT_EQ(wind.value[0], 5);
  EXPECT_TRUE(std::isnan(wind.value[1]));
  EXPECT_EQ(wind.value[2], 6);
  EXPECT_EQ(found.series[1]->value[2], 1.2);
  EXPECT_EQ(found.series[2]->value[0], 9);
  EXPECT_EQ(found.series[3]->value[0], 220);
  EXPECT_EQ(found.series[4]->unit, "degC");
  EXPECT_TRUE(std::isnan(found.series[4]->value[1])) << "999.0";
  bool tells_height = false;
  for (const std::string& warning : found.warnings)
    tells_height |= contains(warning, "anemometer").operator bool();
  EXPECT_TRUE(tells_height);
}

TEST_F(UsualTables, OlderNdbcTextHasNeitherMinutesNorUnitsNorFullYears) {
  const HistoryOfFile found = read(
      "YY MM DD hh WD   WSPD GST  WVHT  DPD   APD  MWD  BAR    ATMP  WTMP  DEWP  VIS\n"
      "98 12 31 22 230  5.0  8.0  1.0   9     5.1  220  1015.0 8.0   9.5   999.0 99.0\n"
      "98 12 31 23 999  99.0 99.0 99.00 99.00 99.0 999  9999.0 999.0 999.0 999.0 99.0\n",
      {height, "wind_from_direction"});
  const HistorySeries& waves = *found.series[0];
  EXPECT_EQ(waves.time[1], parse_utc("1998-12-31T23:00:00Z"));
  EXPECT_EQ(waves.value[0], 1);
  EXPECT_TRUE(std::isnan(waves.value[1]));
  EXPECT_TRUE(std::isnan(found.series[1]->value[1]));
  EXPECT_TRUE(contains(found.warnings.at(1), "1 of 2 values (50.0 %) of 'WVHT' are 99"))
      << found.warnings[1];
}

TEST_F(UsualTables, TheNdbcCasesAgreeWithTheirCleanTable) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto cases = shared / "data/cases/sentinels";
  options_.columns = {{"WSPD", "wind_speed", "m s-1"}, {"WVHT", height, "m"}};
  const std::vector<std::string> wanted{"wind_speed", height};
  const HistoryOfFile clean = read_history(cases / "ndbc_clean.csv", wanted, options_, words());
  const HistoryOfFile table = read_history(cases / "ndbc.csv", wanted, options_, words());
  const HistoryOfFile most = read_history(cases / "ndbc14.csv", wanted, options_, words());
  options_.columns.clear();
  const HistoryOfFile realtime_file =
      read_history(cases / "ndbc_rt.txt", wanted, options_, words());
  const HistoryOfFile historical = read_history(cases / "ndbc_hist.txt", wanted, options_, words());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    expect_same(*table.series[i], *clean.series[i]);
    expect_same(*realtime_file.series[i], *most.series[i]);
    expect_same(*historical.series[i], *most.series[i]);
    // 32 and 69 lines of the tables hold a 99.0.
    EXPECT_EQ(missing_in(*table.series[i]), 32U);
    EXPECT_EQ(missing_in(*most.series[i]), 69U) << "more than a tenth is no wrong unit";
  }
}

// --- ERDDAP and THREDDS ---

TEST_F(UsualTables, ErddapsLineOfUnitsIsReadAndUtcIsItsZone) {
  const HistoryOfFile found = read(
      "time,wind_speed,sea_water_temperature\nUTC,knots,degree_C\n"
      "2025-03-01T00:00:00Z,10,NaN\n2025-03-01T01:00:00Z,12,8.5\n",
      {"wind_speed", "sea_water_temperature"});
  EXPECT_EQ(found.series[0]->unit, "knots");
  ASSERT_EQ(found.series[0]->value.size(), 2U);
  EXPECT_EQ(found.series[0]->value[1], 12);
  EXPECT_EQ(found.series[1]->unit, "degree_C");
  EXPECT_TRUE(std::isnan(found.series[1]->value[0]));
  const HistoryOfFile csvp =
      read("time (UTC),wind_speed (m s-1)\n2025-03-01T00:00:00,3\n", {"wind_speed"});
  EXPECT_EQ(csvp.series[0]->time[0], parse_utc("2025-03-01T00:00:00Z"));
}

TEST_F(UsualTables, AnyLineOfUnitsIsReadAndSaysNothingOfTheZone) {
  const std::string rows = ",10,1.5,3\n";
  const std::string head = "date,wind_speed,sea_surface_wave_significant_height,flag\n";
  const HistoryOfFile found =
      read(head + "yyyy-mm-dd,kt,cm,-\n2025-03-01T00:00Z" + rows, {"wind_speed", height});
  EXPECT_EQ(found.series[0]->unit, "kt");
  EXPECT_EQ(found.series[1]->unit, "cm");
  EXPECT_EQ(found.series[0]->value.size(), 1U);
  EXPECT_EQ(read(head + "UTC,kt,cm,1\n2025-03-01T00:00Z" + rows, {height}).series[0]->unit, "cm")
      << "ERDDAP's unit of a pure number";
  EXPECT_TRUE(contains(refusal(head + ",kt,cm,\n2025-03-01T00:00" + rows, {"wind_speed"}),
                       "without a zone"));
}

TEST_F(UsualTables, ALineOfWordsThatAreNoUnitsIsRefusedAsBefore) {
  EXPECT_TRUE(contains(refusal("time,wind_speed\nwhen,strong\n", {"wind_speed"}),
                       "line 2: found 'when' where a time was expected"));
}

TEST_F(UsualTables, NamesMayStandInTheLastComment) {
  const HistoryOfFile found = read(
      "# a buoy, of ours\n# time, wind_speed [m/s]\n2025-03-01T00:00Z,3\n2025-03-01T01:00Z,4\n",
      {"wind_speed"});
  ASSERT_TRUE(found.series[0]);
  ASSERT_EQ(found.series[0]->value.size(), 2U);
  EXPECT_EQ(found.series[0]->value[0], 3);
}

TEST_F(UsualTables, ErddapAndThreddsCasesAreRead) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto cases = shared / "data/cases/sentinels";
  for (const char* name : {"erddap.csv", "ncss.csv"}) {
    const HistoryOfFile found =
        read_history(cases / name, {height, "wind_speed"}, options_, words());
    ASSERT_TRUE(found.series[0] && found.series[1]) << name;
    ASSERT_EQ(found.series[0]->value.size(), 480U) << name;
    EXPECT_EQ(found.series[0]->unit, "m");
    EXPECT_EQ(found.series[0]->value[1], 1.09) << "the second row of the file";
    EXPECT_EQ(found.series[1]->value[2], 6.46);
    EXPECT_EQ(found.series[1]->time[1], parse_utc("2025-03-01T01:00:00Z"));
    EXPECT_TRUE(found.warnings.empty());
  }
}

TEST_F(UsualTables, ThreddsUnitsStandInTheNames) {
  const HistoryOfFile found =
      read("time,wind_speed[unit=\"knot\"]\n2025-03-01T00:00:00Z,3\n", {"wind_speed"});
  ASSERT_TRUE(found.series[0]);
  EXPECT_EQ(found.series[0]->unit, "knot");
}

// --- sentinels ---

HistorySeries series_of(std::vector<double> values) {
  HistorySeries series;
  series.name = "x";
  series.unit = "m";
  series.value = std::move(values);
  return series;
}

TEST(Sentinels, ANumberOfNinesFarFromTheRestIsMissingAndToldWithItsShare) {
  for (const double sentinel :
       {99.0, 99.99, 999.0, 9999.0, -99.0, -999.0, -9999.0, -32768.0, 1e20}) {
    HistorySeries series = series_of({1, sentinel, 3, 2, sentinel, 1.5, 2, 3});
    const auto told = reject_sentinels(series);
    EXPECT_TRUE(std::isnan(series.value[1]) && std::isnan(series.value[4])) << sentinel;
    EXPECT_EQ(missing_in(series), 2U);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_TRUE(contains(told[0], "2 of 8 values (25.0 %) of 'x' are ")) << told[0];
    EXPECT_TRUE(contains(told[0], "far from the others (1 to 3 m)")) << told[0];
  }
}

TEST(Sentinels, ANumberAmongTheOthersIsAValue) {
  HistorySeries direction = series_of({10, 99, 99, 350, 120});  // degrees
  HistorySeries humidity = series_of({60, 99, 99, 80, 97});
  HistorySeries deep = series_of({-60, -99, -99, -80});
  for (HistorySeries* series : {&direction, &humidity, &deep}) {
    EXPECT_TRUE(reject_sentinels(*series).empty());
    EXPECT_EQ(missing_in(*series), 0U);
  }
}

TEST(Sentinels, TwoAtOnceAndNothingElseAreFound) {
  HistorySeries two = series_of({1, 99, 2, 9999, 3});
  EXPECT_EQ(reject_sentinels(two).size(), 2U);
  EXPECT_EQ(missing_in(two), 2U);
  HistorySeries broken = series_of({99, 99, 99});
  EXPECT_TRUE(contains(reject_sentinels(broken).at(0), "there is no other value"));
  EXPECT_EQ(missing_in(broken), 3U);
}

TEST(Sentinels, SinglePrecisionIsComparedAsItIsKept) {
  HistorySeries series = series_of({1, static_cast<double>(99.99F), 2});
  EXPECT_EQ(reject_sentinels(series).size(), 1U);
}

TEST_F(UsualTables, NumbersThatTheUserNamesAreMissing) {
  options_.missing = {7.5};
  const HistoryOfFile found =
      read("time,wind_speed\n2025-03-01T00:00Z,7.5\n2025-03-01T01:00Z,8\n", {"wind_speed"});
  EXPECT_TRUE(std::isnan(found.series[0]->value[0]));
  EXPECT_TRUE(contains(found.warnings.at(0),
                       "1 of 2 values (50.0 %) of 'wind_speed' are 7.5, missing by --missing"));
}

TEST_F(UsualTables, SentinelsOfComponentsDoNotHideInTheirSpeed) {
  const HistoryOfFile found = read(
      "time,eastward_wind,northward_wind\n2025-03-01T00:00Z,3,4\n2025-03-01T01:00Z,99,99\n"
      "2025-03-01T02:00Z,4,3\n",
      {"wind_speed"});
  EXPECT_EQ(found.series[0]->value[0], 5);
  EXPECT_TRUE(std::isnan(found.series[0]->value[1])) << "not 140 m/s";
}

// --- the toolbox's table of observations ---

const std::string toolbox =
    "variable,platform_id,platform_type,time,longitude,latitude,depth,pressure,"
    "is_depth_from_producer,value,value_qc,institution,doi,product_doi\n";

std::string observation(const std::string& variable, const std::string& hour, double depth,
                        double value, int flag) {
  return variable + ",B,MO,2025-03-08T" + hour + ":00:00Z,-2.55,48.85," + std::to_string(depth) +
         ",,1," + std::to_string(value) + "," + std::to_string(flag) + ",X,,d\n";
}

TEST_F(UsualTables, TheToolboxsObservationsAreReadByShortNameAndFlag) {
  const HistoryOfFile found =
      read(toolbox + observation("VHM0", "00", 0, 1.5, 1) + observation("VHM0", "01", 0, 9.5, 4) +
               observation("VHM0", "02", 0, 1.25, 2) + observation("TEMP", "00", 0, 8.5, 1),
           {height, "sea_water_temperature"});
  ASSERT_TRUE(found.series[0] && found.series[1]);
  EXPECT_EQ(found.series[0]->value[0], 1.5);
  EXPECT_TRUE(std::isnan(found.series[0]->value[1])) << "flag 4, bad";
  EXPECT_EQ(found.series[0]->value[2], 1.25);
  EXPECT_EQ(found.series[1]->unit, "degC");
  EXPECT_TRUE(contains(found.warnings.at(0), "1 of 3 values of 'VHM0' are flagged bad"));
}

TEST_F(UsualTables, TheToolboxsDepthsAreChosenAndSpeedsMade) {
  std::string text = toolbox;
  for (const char* hour : {"00", "01"}) {
    text += observation("EWCT", hour, 3, 0.25, 1) + observation("EWCT", hour, 11, 0.75, 1);
  }
  for (const char* hour : {"00", "01"}) {
    text += observation("NSCT", hour, 3, 0, 1) + observation("NSCT", hour, 11, 0, 1);
  }
  EXPECT_TRUE(contains(refusal(text, {"sea_water_speed"}), "found 2 depths, from 3 to 11 m"));
  EXPECT_TRUE(contains(refusal(text, {"sea_water_speed"}), "--depth"));
  options_.depth_m = 5;
  EXPECT_DOUBLE_EQ(read(text, {"sea_water_speed"}).series[0]->value[1], 0.375);
  options_.depth_m = 12;
  EXPECT_TRUE(contains(refusal(text, {"sea_water_speed"}), "expected 3 to 11 m"));
}

TEST_F(UsualTables, ADirectionBetweenDepthsIsThatOfTheNearer) {
  std::string text = toolbox;
  for (const char* hour : {"00", "01"})
    text += observation("HCDT", hour, 3, 350, 1) + observation("HCDT", hour, 11, 10, 1);
  const auto to_at = [&](double depth_m) {
    options_.depth_m = depth_m;
    return read(text, {"sea_water_velocity_to_direction"}).series[0]->value[1];
  };
  EXPECT_EQ(to_at(6), 350);
  EXPECT_EQ(to_at(8), 10);
}

TEST_F(UsualTables, SeveralPlatformsAreNoOnePlace) {
  std::string other = observation("VHM0", "00", 0, 1.5, 1);
  other.replace(other.find(",B,"), 3, ",C,");
  EXPECT_TRUE(contains(refusal(toolbox + observation("VHM0", "00", 0, 1.5, 1) + other, {height}),
                       "found 2 platforms (B, C)"));
}

TEST_F(UsualTables, TheToolboxsCasesAreReadFromBothOfItsForms) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto cases = shared / "data/cases/usual_downloads";
  // The numbers of the first rows of the tables; the files hold the same data.
  for (const char* name : {"waves.csv", "waves.nc"}) {
    const HistoryOfFile found = read_history(cases / name, {height}, options_, words());
    ASSERT_TRUE(found.series[0]) << name;
    ASSERT_EQ(found.series[0]->value.size(), 48U);
    EXPECT_EQ(found.series[0]->time[1], parse_utc("2025-03-08T01:00:00Z"));
    EXPECT_NEAR(found.series[0]->value[0], 1.2, 1e-6) << name;
    EXPECT_NEAR(found.series[0]->value[1], 1.2497688398080244, 1e-6) << name;
  }
  options_.depth_m = 10;
  for (const char* name : {"adcp.csv", "adcp.nc"}) {
    const HistoryOfFile found =
        read_history(cases / name, {"eastward_sea_water_velocity"}, options_, words());
    ASSERT_TRUE(found.series[0]) << name;
    ASSERT_EQ(found.series[0]->value.size(), 48U) << name;
    EXPECT_NEAR(found.series[0]->value[0], 0.9, 1e-6) << name;
    EXPECT_NEAR(found.series[0]->value[1], 0.7872787368783669, 1e-6) << name;
  }
}

}  // namespace
}  // namespace slackwater::tests::usual_tables_test
