// `slackwater climate`: roses, scatter tables and extremes of a place's past, for people and for
// programs, and all that can be wrong with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/text.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_climate_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string height = "sea_surface_wave_significant_height";
const std::string waves_from = "sea_surface_wave_from_direction";
const std::string peak = "sea_surface_wave_period_at_variance_spectral_density_maximum";

/// Hourly rows from a time on.
std::string table(const std::string& head, const std::vector<std::string>& rows,
                  const std::string& from = "2002-01-01T00:00:00Z") {
  std::string text = "time," + head + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += format_utc(parse_utc(from) + std::chrono::hours(i)) + "," + rows[i] + "\n";
  return text;
}

double sum_of(const json& rose) {
  double sum =
      rose.at("calm").at("share").get<double>() + rose.at("no_direction_share").get<double>();
  for (const json& sector : rose.at("sectors"))
    for (const json& share : sector.at("by_class")) sum += share.get<double>();
  return sum;
}

double sum_of_table(const json& scatter) {
  double sum = 0;
  for (const json& row : scatter.at("per_mille"))
    for (const json& cell : row) sum += cell.get<double>();
  return sum;
}

class ClimateCommand : public testing::Test {
 protected:
  ProgramResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), "climate");
    return store_.run(arguments);
  }
  json answer(Arguments arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  void expect_refused(const Arguments& arguments, int exit_code,
                      const std::vector<std::string>& words) const {
    expect_refusal(run(arguments), exit_code, words);
  }

  StoreForTests store_;
};

TEST_F(ClimateCommand, CountsASmallRoseAsByHand) {
  const std::string file = store_.write(
      "wind.csv",
      table("wind_speed,wind_from_direction",
            {"0.2,90", "5,350", "5,10", "9,100", ",100", "9,", "5,271", "0,", "4,359.5", "12,80"}));
  const json found = answer({file, "--roses", "--sectors", "4", "--classes", "wind=5,10"});
  ASSERT_EQ(found.at("parts").size(), 1U);
  const json& wind = found.at("parts").at(0);
  EXPECT_EQ(wind.at("of"), "wind");
  EXPECT_EQ(wind.at("known_steps"), 9);
  EXPECT_EQ(wind.at("missing_steps"), 1);
  EXPECT_EQ(wind.at("extremes"), nullptr);
  EXPECT_EQ(wind.at("greatest").at("value"), 12);
  EXPECT_EQ(wind.at("greatest").at("time"), "2002-01-01T09:00:00Z");
  const json& rose = wind.at("rose");
  EXPECT_EQ(rose.at("way"), "from");
  EXPECT_EQ(rose.at("known_steps"), 9);
  EXPECT_EQ(rose.at("missing_steps"), 1);
  EXPECT_DOUBLE_EQ(rose.at("calm").at("share").get<double>(), 2.0 / 9);
  EXPECT_DOUBLE_EQ(rose.at("no_direction_share").get<double>(), 1.0 / 9);
  EXPECT_EQ(rose.at("classes").at(1), (json{{"from", 5.0}, {"below", 10.0}}));
  const auto shares = [&](std::size_t sector) {
    return rose.at("sectors").at(sector).at("by_class").get<std::vector<double>>();
  };
  EXPECT_EQ(shares(0), (std::vector{1.0 / 9, 2.0 / 9, 0.0}));
  EXPECT_EQ(shares(1), (std::vector{0.0, 1.0 / 9, 1.0 / 9}));
  EXPECT_EQ(shares(2), (std::vector{0.0, 0.0, 0.0}));
  EXPECT_EQ(shares(3), (std::vector{0.0, 1.0 / 9, 0.0}));
  EXPECT_DOUBLE_EQ(sum_of(rose), 1);
  EXPECT_EQ(found.at("height_by_period"), nullptr);
  const ProgramResult told = run({file, "--roses"});
  EXPECT_TRUE(contains(told.out, "by the direction that it comes from")) << told.out;
  EXPECT_TRUE(contains(told.out, "calm (below 0.5 m s-1): 22.2 %")) << told.out;
  EXPECT_TRUE(contains(told.out, "1 more are missing and in no share")) << told.out;
}

/// North wind blows to the south, and a current is told by where it goes.
TEST_F(ClimateCommand, ComponentsAreTheSameRoseAsSpeedAndDirection) {
  std::vector<std::string> components;
  std::vector<std::string> polar;
  for (int i = 0; i < 48; ++i) {
    const double to = (7.5 + 30 * i) * std::acos(-1.0) / 180;
    const double speed = 2 + i % 3;
    components.push_back(formatted("{},{},{},{}", speed * std::sin(to), speed * std::cos(to),
                                   0.1 * speed * std::sin(to), 0.1 * speed * std::cos(to)));
    polar.push_back(formatted("{},{},{},{}", speed, std::fmod(187.5 + 30 * i, 360.0), 0.1 * speed,
                              std::fmod(7.5 + 30 * i, 360.0)));
  }
  const std::string one = store_.write(
      "components.csv", table("eastward_wind,northward_wind,eastward_sea_water_velocity,"
                              "northward_sea_water_velocity",
                              components));
  const std::string other =
      store_.write("polar.csv", table("wind_speed,wind_from_direction,sea_water_speed,"
                                      "sea_water_velocity_to_direction",
                                      polar));
  const Arguments options{"--roses", "--classes", "wind=2.5,3.5", "--classes", "current=0.25,0.35"};
  const auto roses = [&](const std::string& file) {
    Arguments asked{file};
    asked.insert(asked.end(), options.begin(), options.end());
    return answer(asked).at("parts");
  };
  const json by_components = roses(one);
  const json by_direction = roses(other);
  ASSERT_EQ(by_components.size(), 2U);
  for (std::size_t p = 0; p < 2; ++p) {
    EXPECT_EQ(by_components.at(p).at("rose").at("sectors"),
              by_direction.at(p).at("rose").at("sectors"));
    // Each of twelve sectors had four of 48 hours.
    for (const json& sector : by_components.at(p).at("rose").at("sectors"))
      EXPECT_NEAR(sector.at("share").get<double>(), 4.0 / 48, 1e-15);
  }
  EXPECT_EQ(by_components.at(1).at("rose").at("way"), "to");
}

TEST_F(ClimateCommand, CountsASmallScatterTableAsByHand) {
  const std::string file = store_.write(
      "waves.csv", table(height + "," + peak + "," + waves_from,
                         {"0.4,4,10", "0.5,5,10", "1.2,9,200", "1.2,9.5,200", ",7,10", "2,,10"}));
  const json found = answer(
      {file, "--scatter", "--classes", "waves=0.5,1", "--classes", "period=5,8", "--sectors", "4"});
  const json& table_found = found.at("height_by_period");
  EXPECT_EQ(table_found.at("per_mille"),
            (json{{250.0, 0.0, 0.0}, {0.0, 250.0, 0.0}, {0.0, 0.0, 500.0}}));
  EXPECT_EQ(table_found.at("known_steps"), 4);
  EXPECT_EQ(table_found.at("missing_steps"), 2);
  const json& by_direction = found.at("height_by_direction");
  EXPECT_EQ(by_direction.at("per_mille"),
            (json{{200.0, 0.0, 0.0, 0.0}, {200.0, 0.0, 0.0, 0.0}, {200.0, 0.0, 400.0, 0.0}}));
  EXPECT_EQ(found.at("parts").at(0).at("rose"), nullptr);
}

TEST_F(ClimateCommand, ClassesInAnotherUnitAreNotMovedByRounding) {
  const std::string file =
      store_.write("cm.csv", table("Hs," + waves_from, {"57,10", "56,10", "58,10", "57,10"}));
  const json found =
      answer({file, "--column", "Hs=" + height + ":cm", "--roses", "--classes", "waves=0.57 m"});
  const json& sector = found.at("parts").at(0).at("rose").at("sectors").at(0);
  EXPECT_EQ(sector.at("by_class"), (json{0.25, 0.75}));
  const ProgramResult told = run({file, "--column", "Hs=" + height + ":cm", "--roses"});
  EXPECT_TRUE(contains(told.out, "Waves: " + height + ", m (Hs)")) << told.out;
}

TEST_F(ClimateCommand, GapsAreToldByMonthAndAreNoCalms) {
  std::vector<std::string> rows(31 * 24, "3,20");
  std::fill_n(rows.begin(), 15 * 24, ",");
  const std::string file = store_.write("gaps.csv", table("wind_speed,wind_from_direction", rows));
  const json wind = answer({file, "--roses"}).at("parts").at(0);
  EXPECT_EQ(wind.at("rose").at("calm").at("share"), 0);
  EXPECT_EQ(wind.at("coverage_by_month").at(0),
            (json{{"month", 1}, {"steps", 31 * 24}, {"known_steps", 16 * 24}}));
  EXPECT_EQ(wind.at("coverage_by_month").at(1).at("steps"), 0);
  const ProgramResult told = run({file});
  EXPECT_TRUE(contains(told.out, "known, %")) << told.out;
  EXPECT_TRUE(contains(told.out, "51.6")) << told.out;
  EXPECT_TRUE(contains(told.err, "nothing is known of Feb, Mar")) << told.err;
  EXPECT_TRUE(contains(told.out, "no extremes from storms: 0.04 years are known")) << told.out;
  EXPECT_FALSE(contains(told.out, "storms over a threshold")) << told.out;
}

/// Twelve years, six-hourly, with a storm every 12.2 days whose peak is 3 m and more, exponential.
/// @param digits  of the heights, behind the point  @param per_m  units of a metre
std::string twelve_years_of_storms(const std::string& column, int digits, double per_m) {
  std::string text = "time," + column + "\n";
  unsigned random = 1;
  const auto uniform = [&] {
    random = random * 1664525U + 1013904223U;
    return static_cast<double>(random >> 8U) / 16777216.0;
  };
  UtcTime time = parse_utc("2000-01-01T00:00:00Z");
  for (int storm = 0; storm < 12 * 30; ++storm) {
    const double top = 3 - 0.8 * std::log(1 - uniform());
    for (int step = 0; step < 49; ++step) {
      const double now = std::abs(step - 20) < 4 ? top - 0.3 * std::abs(step - 20) : 1;
      text += format_utc(time) + "," + formatted("{:.{}f}", now * per_m, digits) + "\n";
      time += std::chrono::hours(6);
    }
  }
  return text;
}

/// Heights in centimetres, of which some are the threshold itself, however it is written.
TEST_F(ClimateCommand, AThresholdIsTheSameInEachUnit) {
  const std::string text = twelve_years_of_storms("Hs", 0, 100);
  ASSERT_TRUE(contains(text, ",452\n"));
  const std::string file = store_.write("cm.csv", text);
  const auto peaks = [&](const std::string& threshold) {
    return answer({file, "--column", "Hs=" + height + ":cm", "--extremes", "--threshold",
                   "waves=" + threshold})
        .at("parts")
        .at(0)
        .at("extremes")
        .at("peaks");
  };
  const json in_metres = peaks("4.52 m");
  EXPECT_EQ(in_metres, peaks("452 cm"));
  EXPECT_EQ(in_metres, peaks("4520 mm"));
}

/// What is supported is told with an interval, the rest is not.
TEST_F(ClimateCommand, ExtremesSayMethodThresholdAndWhatIsNotSupported) {
  const std::string file = store_.write("storms.csv", twelve_years_of_storms(height, 2, 1));
  const json found = answer({file, "--extremes", "--return-period", "1,10,100"});
  const json& extremes = found.at("parts").at(0).at("extremes");
  const json& peaks = extremes.at("peaks");
  EXPECT_EQ(peaks.at("why_not"), nullptr);
  EXPECT_GE(peaks.at("storms_per_year").get<double>(), 5);
  ASSERT_EQ(peaks.at("returns").size(), 3U);
  const json& ten = peaks.at("returns").at(1);
  EXPECT_EQ(ten.at("support"), "supported");
  EXPECT_LT(ten.at("interval_90").at(0), ten.at("value"));
  EXPECT_LT(ten.at("value"), ten.at("interval_90").at(1));
  // 3 - 0.8 ln(1 / (30 x 10)) = 7.56 is what the storms were drawn from.
  EXPECT_LT(ten.at("interval_90").at(0).get<double>(), 7.56);
  EXPECT_GT(ten.at("interval_90").at(1).get<double>(), 7.56);
  EXPECT_EQ(peaks.at("returns").at(2), (json{{"years", 100.0},
                                             {"support", "beyond_history"},
                                             {"value", nullptr},
                                             {"interval_90", nullptr}}));
  EXPECT_GE(extremes.at("thresholds").size(), 4U);
  EXPECT_EQ(extremes.at("annual_maxima").size(), 12U);
  EXPECT_EQ(extremes.at("gumbel").at("why_not"), nullptr);
  EXPECT_TRUE(contains(extremes.at("gev").at("why_not").get<std::string>(), "expected 20"));
  EXPECT_EQ(answer({file, "--extremes", "--return-period", "10,100,1,10"}), found);
  const ProgramResult told = run({file, "--extremes"});
  for (const char* words :
       {"Hosking and Wallis 1987", "Coles 2001", "not supported", "storms at least 48 h apart",
        "other thresholds", "parametric bootstrap, seed 1", "maxima of years: 2000 "})
    EXPECT_TRUE(contains(told.out, words)) << words << "\n" << told.out;
  EXPECT_TRUE(contains(told.out, ", the greatest with 5 storms a year: "));
  const ProgramResult many = run({file, "--extremes", "--storms-per-year", "100"});
  EXPECT_TRUE(contains(many.out, ", with most storms: none has 100 a year: ")) << many.out;
  const ProgramResult low = run({file, "--extremes", "--threshold", "waves=0"});
  EXPECT_TRUE(contains(low.out, "1 storm over the threshold")) << low.out;
  EXPECT_TRUE(contains(low.out, "another --threshold (a low one joins storms")) << low.out;
  const json asked =
      answer({file, "--extremes", "--threshold", "waves=350 cm", "--separation", "3d"});
  EXPECT_EQ(asked.at("parts").at(0).at("extremes").at("peaks").at("threshold"), 3.5);
  EXPECT_EQ(asked.at("parts").at(0).at("extremes").at("separation_h"), 72);
}

TEST_F(ClimateCommand, AStormAtNewYearThatIsTwoMaximaIsPointedOut) {
  std::vector<std::string> rows(2 * 365 * 24, "1");
  rows[365 * 24 - 3] = "6";
  rows[365 * 24 + 2] = "5.5";
  const std::string file = store_.write("new_year.csv", table(height, rows));
  const json found = answer({file, "--extremes"});
  EXPECT_EQ(found.at("parts").at(0).at("extremes").at("annual_maxima").size(), 2U);
  const std::string note = "the maxima of 2002 and 2003 are 5 h apart, of one storm";
  EXPECT_TRUE(contains(found.at("notes").dump(), note));
  EXPECT_FALSE(
      contains(answer({file, "--extremes", "--separation", "5h"}).at("notes").dump(), note));
}

/// Four values in thirty years.
TEST_F(ClimateCommand, ValuesOfDecadesHaveNoExtremes) {
  const std::string file =
      store_.write("decades.csv",
                   "time,wind_speed\n1970-01-01T00:00Z,5\n1980-01-01T00:00Z,7\n"
                   "1989-12-31T00:00Z,6\n1999-12-31T00:00Z,9\n");
  const json extremes = answer({file, "--extremes"}).at("parts").at(0).at("extremes");
  EXPECT_TRUE(extremes.at("annual_maxima").empty());
  for (const char* way : {"peaks", "gumbel", "gev"})
    EXPECT_TRUE(contains(extremes.at(way).at("why_not").get<std::string>(),
                         "a value holds 87648 h, expected at most 6 h"));
}

TEST_F(ClimateCommand, EachSeriesHasItsOwnStep) {
  std::string waves = "time," + height + "\n";
  for (int i = 0; i < 8; ++i)
    waves += format_utc(parse_utc("2002-01-01T00:00:00Z") + std::chrono::hours(3 * i)) + ",2\n";
  const std::string hourly =
      store_.write("wind.csv", table("wind_speed", std::vector<std::string>(24, "7")));
  const std::string three_hourly = store_.write("waves.csv", waves);
  const json found = answer({hourly, three_hourly, "--extremes"});
  EXPECT_EQ(found.at("step_h"), 1);
  EXPECT_EQ(found.at("parts").at(0).at("own_step_h"), 1);
  EXPECT_EQ(found.at("parts").at(1).at("own_step_h"), 3);
  const ProgramResult told = run({hourly, three_hourly, "--extremes"});
  EXPECT_TRUE(contains(told.out, "Waves: " + height + ", m, a value every 3 h")) << told.out;
}

/// Twelve summers, three-hourly: four years known in all.
TEST_F(ClimateCommand, SummersHaveNoExtremesOfAYear) {
  std::string text = "time," + height + "\n";
  for (int year = 2000; year < 2012; ++year)
    for (int step = 0; step < 122 * 8; ++step)
      text += format_utc(parse_utc(formatted("{}-05-01T00:00:00Z", year)) +
                         std::chrono::hours(3 * step)) +
              formatted(",{:.2f}\n", 1 + (step % 40 == 0 ? 0.01 * (step * 7 % 97) + 1 : 0.0));
  const std::string file = store_.write("summers.csv", text);
  const json extremes = answer({file, "--extremes"}).at("parts").at(0).at("extremes");
  EXPECT_TRUE(contains(extremes.at("peaks").at("why_not").get<std::string>(),
                       "of Jan, Feb, Mar, Apr, Sep, Oct, Nov, Dec nothing is known"));
  EXPECT_FALSE(extremes.at("peaks").contains("returns"));
  EXPECT_TRUE(extremes.at("thresholds").empty());
  EXPECT_TRUE(extremes.at("annual_maxima").empty());
}

TEST_F(ClimateCommand, WhatMakesNoSenseIsRefusedInOneLine) {
  const std::string file =
      store_.write("wind.csv", table("wind_speed,wind_from_direction", {"5,10", "6,20", "7,30"}));
  expect_refused({}, 2, {"found no series"});
  expect_refused({file, "--site", "a"}, 2, {"found files and --site"});
  expect_refused({file, "--of", "tide"}, 2, {"--of", "'tide'", "wind, waves, current"});
  expect_refused({file, "--of", "waves"}, 4, {"found no " + height, "--column"});
  expect_refused({file, "--sectors", "0"}, 2, {"--sectors"});
  expect_refused({file, "--classes", "wind"}, 2, {"--classes", "without ="});
  expect_refused({file, "--classes", "gust=4"}, 2, {"'gust' is not known"});
  expect_refused({file, "--classes", "wind=8,4"}, 2, {"have to ascend"});
  expect_refused({file, "--classes", "wind=0,4"}, 2, {"leave the 0 away"});
  expect_refused({file, "--classes", "wind=-4"}, 2, {"less than 0"});
  expect_refused({file, "--classes", "wind=4,x"}, 2, {"without a finite number"});
  expect_refused({file, "--classes", "wind=4 m"}, 2, {"--classes", "'m'", "m s-1"});
  expect_refused({file, "--classes", "wind=4", "--classes", "wind=5"}, 2, {"twice"});
  expect_refused({file, "--calm", "wind=1,2"}, 2, {"2 numbers", "expected one"});
  expect_refused({file, "--calm", "period=1"}, 2, {"--calm of period"});
  expect_refused({file, "--calm", "wind=5"}, 3, {"above 5", "--calm"});
  for (const char* years : {"0", "0.01", "nan", "inf", "10001"})
    expect_refused({file, "--return-period", years}, 2, {"--return-period", "0.1 to 10000"});
  expect_refused({file, "--separation", "0h"}, 2, {"--separation 0h"});
  expect_refused({file, "--from", "2003-01-01"}, 4, {"--from"});
}

/// What an option asks for in vain would be taken as heard.
TEST_F(ClimateCommand, OptionsWithoutEffectAreRefused) {
  const std::string file =
      store_.write("wind.csv", table("wind_speed,wind_from_direction", {"5,10", "6,20", "7,30"}));
  const std::vector<std::pair<Arguments, std::string>> cases{
      {{"--roses", "--threshold", "wind=15"}, "found --threshold without --extremes"},
      {{"--roses", "--seed", "3"}, "found --seed without --extremes"},
      {{"--scatter", "--separation", "12h"}, "found --separation without --extremes"},
      {{"--extremes", "--sectors", "8"}, "found --sectors without --roses or --scatter"},
      {{"--extremes", "--calm", "wind=1"}, "found --calm of wind"},
      {{"--scatter", "--classes", "wind=4,8"}, "found --classes of wind"},
      {{"--roses", "--classes", "period=4,8"}, "found --classes of period"},
      {{"--of", "wind", "--threshold", "waves=4"}, "found --threshold of waves"},
      {{"--threshold", "waves=4"}, "found --threshold of waves, and no waves in the series"},
      {{"--classes", "current=1"}, "found --classes of current, and no current in the series"}};
  for (const auto& [options, words] : cases) {
    Arguments all{file};
    all.insert(all.end(), options.begin(), options.end());
    expect_refused(all, 2, {words});
  }
}

TEST_F(ClimateCommand, ASeriesWithoutItsDirectionSaysSoAndIsNoRose) {
  const std::string file = store_.write("wind.csv", table("wind_speed", {"5", "6", "7"}));
  const json found = answer({file});
  EXPECT_EQ(found.at("parts").at(0).at("rose"), nullptr);
  EXPECT_TRUE(contains(found.at("notes").dump(), "found no wind_from_direction: no rose of wind"));
}

TEST_F(ClimateCommand, ATableThatNoStepFillsIsANote) {
  const std::string head = height + "," + peak + "," + waves_from;
  const auto notes = [&](const std::string& name, const std::string& columns,
                         const std::vector<std::string>& rows) {
    const json found = answer({store_.write(name, table(columns, rows)), "--scatter"});
    EXPECT_EQ(found.at("height_by_direction"), nullptr) << found;
    return found.at("notes").dump();
  };
  const std::string no_directions = "found no " + waves_from + ": no scatter of heights and";
  EXPECT_TRUE(contains(notes("none.csv", height + "," + peak, {"2,7", "2,8"}), no_directions));
  EXPECT_TRUE(contains(notes("nan.csv", head, {"2,7,", "2,8,"}), no_directions));
  EXPECT_TRUE(contains(notes("apart.csv", head, {"2,7,", ",8,10"}),
                       "found no step with a height of waves and " + waves_from));
}

TEST_F(ClimateCommand, AsksTheStoreAtASite) {
  store_.ingest_days(parse_day("2025-03-06"), 3);
  const json found = answer({"--site", store_.site(), "--depth", "10", "--roses", "--scatter"});
  for (const json& part : found.at("parts")) {
    EXPECT_GT(part.at("known_steps").get<int>(), 48) << part.at("of");
    EXPECT_NEAR(sum_of(part.at("rose")), 1, 1e-12) << part.at("of");
  }
  EXPECT_EQ(found.at("parts").back().at("of"), "current");
  EXPECT_EQ(found.at("parts").back().at("rose").at("direction_series"),
            "sea_water_velocity_to_direction");
  expect_refused({"--site", store_.site()}, 3, {"--depth"});
}

TEST_F(ClimateCommand, RealWavesAndWindOfNora3SumToTheWhole) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto file = shared / "data/nora3/NORA3_wind_wave_lon1.32_lat53.324_20221001_20221231.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const json found = answer(
      {file.string(), "--assume-utc", "--column", "wind_speed_10m=wind_speed:m s-1", "--column",
       "wind_direction_10m=wind_from_direction:degree", "--column", "hs=" + height + ":m",
       "--column", "tp=" + peak + ":s", "--column", "thq=" + waves_from + ":degree"});
  ASSERT_EQ(found.at("parts").size(), 2U);
  for (const json& part : found.at("parts")) {
    EXPECT_NEAR(sum_of(part.at("rose")), 1, 1e-12);
    EXPECT_EQ(part.at("known_steps"), 92 * 24);
    EXPECT_TRUE(
        contains(part.at("extremes").at("peaks").at("why_not").get<std::string>(), "0.25 years"));
  }
  for (const char* name : {"height_by_period", "height_by_direction"})
    EXPECT_NEAR(sum_of_table(found.at(name)), 1000, 1e-9);
  EXPECT_TRUE(contains(found.at("notes").dump(), "nothing is known of Jan, Feb"));
}

TEST_F(ClimateCommand, RealWavesOfAlphaVentusHaveAFiftyYearHeight) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto file = shared / "data/weather_windows/alpha_ventus_weather_2002_2014.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const json found = answer({file.string(), "--assume-utc", "--time-column", "datetime", "--column",
                             "waveheight=" + height + ":m", "--column",
                             "windspeed=wind_speed:m s-1", "--extremes"});
  const json& waves = found.at("parts").at(1);
  const json& returns = waves.at("extremes").at("peaks").at("returns");
  // A year's greatest is above x(T) with 1 - exp(-1/T): of thirteen years above x(1) 8.2, give or
  // take three times 1.7, above x(10) 1.2, give or take three times 1.1.
  const json& maxima = waves.at("extremes").at("annual_maxima");
  ASSERT_EQ(maxima.size(), 13U);
  const auto years_above = [&](const json& one) {
    return std::count_if(maxima.begin(), maxima.end(), [&](const json& year) {
      return year.at("value").get<double>() > one.at("value").get<double>();
    });
  };
  EXPECT_GE(years_above(returns.at(0)), 3);
  EXPECT_LE(years_above(returns.at(1)), 4);
  EXPECT_LT(returns.at(1).at("value"), returns.at(2).at("value"));
  EXPECT_EQ(returns.at(3).at("support"), "beyond_history");
}

}  // namespace
}  // namespace slackwater::tests::cli_climate_test
