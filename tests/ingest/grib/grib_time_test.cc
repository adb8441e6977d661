#include <algorithm>
#include <array>

#include "tests/ingest/grib/grib_fixture.h"

namespace slackwater::ingest::tests::grib_time_test {
namespace {

using GribTime = GribTest;
using std::chrono::hours;
using std::chrono::minutes;

std::vector<GribField> pair(UtcTime run, int step) {
  return {wind_field("10u", run, step), wind_field("10v", run, step)};
}

std::vector<GribField> all(std::initializer_list<std::vector<GribField>> lists) {
  std::vector<GribField> out;
  for (const auto& list : lists) out.insert(out.end(), list.begin(), list.end());
  return out;
}

TEST_F(GribTime, ARunHoldsItsStepZeroAndIsAForecast) {
  write_grib(file, all({pair(run, 6), pair(run, 0), pair(run, 3)}), 2,
             false);  // out of order on purpose
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  const Granule& granule = ingested.granules[0].granule;
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, run);
  ASSERT_EQ(granule.grid.time.size(), 3U);
  EXPECT_EQ(granule.grid.time[0], TimeCell::instant(run));
  EXPECT_NEAR(read(ingested.granules[0], "eastward_wind").values[0], wind_at(54, 5, 0, true),
              packing_m_s);
}

TEST_F(GribTime, TwoRunsBecomeTwoForecasts) {
  write_grib(file, all({pair(run, 3), pair(run + hours(12), 3), pair(run, 15)}), 1, false);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 2U);
  EXPECT_EQ(ingested.granules[0].granule.reference_time, run);
  EXPECT_EQ(ingested.granules[0].granule.grid.times(), 2U);
  EXPECT_EQ(ingested.granules[1].granule.reference_time, run + hours(12));
  EXPECT_EQ(ingested.granules[1].granule.grid.times(), 1U);
}

TEST_F(GribTime, HourlyAnalysesShareOneGranule) {
  write_grib(file, all({pair(run, 0), pair(run + hours(1), 0), pair(run + hours(2), 0)}), 1, false);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  EXPECT_EQ(ingested.granules[0].granule.status, DataStatus::analysis);
  EXPECT_FALSE(ingested.granules[0].granule.reference_time);
  EXPECT_EQ(ingested.granules[0].granule.grid.times(), 3U);
}

TEST_F(GribTime, WhatTheOperatorSaysWins) {
  write_grib(file, pair(run, 6), 2, false);
  options.as = DataStatus::analysis;
  EXPECT_EQ(decode().granules[0].granule.status, DataStatus::analysis);
  EXPECT_FALSE(decode().granules[0].granule.reference_time);
  options.as = DataStatus::forecast;
  options.issued = run - hours(6);
  EXPECT_EQ(decode().granules[0].granule.reference_time, run - hours(6));

  write_grib(file, pair(run, 0), 2, false);
  options.issued.reset();
  EXPECT_THROW(static_cast<void>(decode()), Error);  // an analysis states no time of issue
}

TEST_F(GribTime, StepsInMinutesAreExact) {
  for (const int edition : {1, 2}) {
    write_bent(edition, [&](grib::Message& message) {
      message.set(edition == 1 ? "unitOfTimeRange" : "indicatorOfUnitOfTimeRange", 0L);
      message.set(edition == 1 ? "P1" : "forecastTime", 45L);
    });
    EXPECT_EQ(decode().granules[0].granule.grid.time[0], TimeCell::instant(run + minutes(45)))
        << edition;
  }
}

TEST_F(GribTime, AMeanOverStepsKeepsItsInterval) {
  write_bent(2, [](grib::Message& message) {
    message.set("stepType", std::string("avg"));
    message.set("stepRange", std::string("3-6"));
  });
  const Granule granule = decode().granules[0].granule;
  EXPECT_EQ(granule.grid.time[0], (TimeCell{run + hours(3), run + hours(6)}));
  EXPECT_EQ(granule.grid.levels_m, std::vector<double>{10.0});
}

TEST_F(GribTime, AGustIsStampedWithTheEndOfItsInterval) {
  write_bent(2,
             [](grib::Message& message) {
               message.set("stepType", std::string("max"));
               message.set("stepRange", std::string("3-6"));
             },
             {"i10fg"});
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.variables[0].standard_name, "wind_speed_of_gust");
  EXPECT_EQ(ingested.granules[0].granule.grid.time[0], TimeCell::instant(run + hours(6)));
  EXPECT_NE(ingested.warnings.at(0).find("maxima over an interval"), std::string::npos);
}

TEST_F(GribTime, WindAt10And100MetresSharesAGranuleAndAGustHasItsOwn) {
  auto fields = pair(run, 3);
  for (const char* name : {"100u", "100v", "10fg"}) fields.push_back(wind_field(name, run, 3));
  write_grib(file, fields, 1, false);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 2U);
  const auto& wind = *std::find_if(ingested.granules.begin(), ingested.granules.end(),
                                   [](auto& g) { return g.granule.variables.size() == 2; });
  EXPECT_EQ(wind.granule.grid.levels_m, (std::vector<double>{10, 100}));
  const GriddedField east = read(wind, "eastward_wind");
  EXPECT_NEAR(east.values[0], wind_at(54, 5, 3, true), packing_m_s);
  EXPECT_NEAR(east.values[east.grid.offset(0, 1, 4, 6)], wind_at(55, 6.5, 3, true), packing_m_s);
}

TEST_F(GribTime, WindOnNamedHeightsIsReadAndPressureLevelsArePassedOver) {
  auto write = [&](const std::string& level_type) {
    write_bent(2,
               [&](grib::Message& message) {
                 message.set("typeOfLevel", level_type);
                 message.set("level", 80L);
               },
               {"u", "v"});
  };
  write("heightAboveGround");
  EXPECT_EQ(decode().granules[0].granule.grid.levels_m, std::vector<double>{80});
  write("isobaricInhPa");
  EXPECT_NE(refusal().find("u on isobaricInhPa"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_time_test
