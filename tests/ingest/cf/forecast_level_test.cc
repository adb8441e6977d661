// The level of the sea in a forecast file.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/netcdf/file.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::forecast_level_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double fill = 9.969209968386869e+36;

/// The first column has a level but at one hour, the second none.
Snapshot levelled(std::size_t columns) {
  Snapshot s = slackwater::tests::made_up_forecast({.columns = columns, .hours = 24, .members = 1});
  s.wind_policy = WindPolicy::best;
  for (std::size_t t = 0; t < s.time.size(); ++t) {
    SeaLevel& level = s.columns[0].sea_level;
    level.level_m.push_back(t == 3 ? nan : 3.6 * std::cos(0.5 * static_cast<double>(t)));
    level.sigma_m.push_back(0.1 + 0.01 * static_cast<double>(t));
    level.source.push_back(t < 9 ? DataStatus::forecast : DataStatus::modelled);
  }
  return s;
}

TEST(ForecastLevel, ReturnsEveryBitAndAColumnWithoutStaysWithout) {
  for (const std::size_t columns : {1U, 2U}) {
    const slackwater::tests::TemporaryFolder folder;
    const Snapshot written = levelled(columns);
    write_forecast(folder / "f.nc", written);
    const Snapshot read = read_forecast(folder / "f.nc");
    const SeaLevel &a = written.columns[0].sea_level, &b = read.columns[0].sea_level;
    ASSERT_EQ(b.level_m.size(), a.level_m.size());
    for (std::size_t t = 0; t < a.level_m.size(); ++t) {
      if (t == 3) {
        EXPECT_TRUE(std::isnan(b.level_m[t])) << "missing, never zero";
      } else {
        EXPECT_EQ(b.level_m[t], a.level_m[t]);
      }
    }
    EXPECT_EQ(b.sigma_m, a.sigma_m);
    EXPECT_EQ(b.source, a.source);
    if (columns == 2) {
      EXPECT_TRUE(read.columns[1].sea_level.empty());
    }
  }
}

TEST(ForecastLevel, HasOneVariableWithTheStandardNameAndQuantilesOfANormal) {
  const slackwater::tests::TemporaryFolder folder;
  const Snapshot written = levelled(1);
  write_forecast(folder / "f.nc", written);
  const netcdf::File in = netcdf::File::open(folder / "f.nc");
  int named = 0;
  for (const netcdf::Variable& variable : in.variables()) {
    if (variable.text("standard_name") == "sea_surface_height_above_geoid") {
      ++named;
      EXPECT_EQ(variable.name, "sea_surface_height_above_geoid");
      EXPECT_EQ(variable.text("units"), "m");
      EXPECT_EQ(variable.shape.size(), 1U) << "over time alone";
    }
  }
  EXPECT_EQ(named, 1);
  const auto values = [&](const char* name) { return in.read_all(*in.find(name)); };
  const auto p10 = values("sea_surface_height_above_geoid_p10");
  const auto p90 = values("sea_surface_height_above_geoid_p90");
  EXPECT_EQ(values("sea_surface_height_above_geoid_p50"), values("sea_surface_height_above_geoid"));
  EXPECT_NEAR(p90[5] - p10[5], 2 * 1.2815515655446004 * 0.15, 1e-9);
  EXPECT_EQ(p10[3], fill);
  EXPECT_EQ(values("sea_surface_height_above_geoid")[3], fill);
}

TEST(ForecastLevel, AFileWithoutOneHasNoSuchVariablesAndIsReadAsBefore) {
  const slackwater::tests::TemporaryFolder folder;
  Snapshot written = levelled(1);
  written.columns[0].sea_level = {};
  write_forecast(folder / "f.nc", written);
  const netcdf::File in = netcdf::File::open(folder / "f.nc");
  for (const netcdf::Variable& variable : in.variables())
    EXPECT_EQ(variable.name.find("sea_surface_height"), std::string::npos) << variable.name;
  EXPECT_TRUE(read_forecast(folder / "f.nc").columns[0].sea_level.empty());
}

}  // namespace
}  // namespace slackwater::ingest::forecast_level_test
