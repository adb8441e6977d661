#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/frame.h"
#include "tests/ingest/insitu/series_fixture.h"
#include "tests/support/point_series_for_tests.h"

// CF writes a moored profile in many ways. Whatever the layout, the water that comes out is the
// water that went in, at its depths.

namespace slackwater::ingest::tests::series_layouts_test {
namespace {

using slackwater::tests::PointSeriesForTests;
using slackwater::tests::write_point_series;
using Layout = slackwater::tests::SeriesLevelsForTests;

const std::vector<double> depths{4, 9, 15, 26};

Horizontal water(UtcTime time, double depth_m) {
  const double hours = hours_between(parse_utc("2019-10-01T00:00:00Z"), time);
  return std::polar(0.5 - 0.01 * depth_m, 0.5 * hours + 0.1 * depth_m);
}

PointSeriesForTests current_series(Layout layout) {
  PointSeriesForTests series;
  series.time = slackwater::tests::stepping_times(parse_day("2019-10-01"), 1, 10);
  series.depth_m = depths;
  series.levels = layout;
  series.value = water;
  return series;
}

struct SeriesLayout : SeriesTest {
  /// Every depth was found once, and holds the water.
  void expect_the_water(const Ingested& ingested) {
    std::vector<double> found;
    for (const DecodedGranule& decoded : ingested.granules) {
      const GriddedField east = read(decoded, "eastward_sea_water_velocity");
      const GriddedField north = read(decoded, "northward_sea_water_velocity");
      ASSERT_EQ(east.grid.vertical, VerticalKind::depth_m);
      ASSERT_EQ(east.grid.times(), 144U);
      for (std::size_t k = 0; k < east.grid.levels(); ++k) {
        const double depth = east.grid.levels_m[k];
        found.push_back(depth);
        for (std::size_t t = 0; t < east.grid.times(); ++t) {
          const Horizontal wanted = water(east.grid.time[t].start, depth);
          const std::size_t o = east.grid.offset(t, k, 0, 0);
          EXPECT_NEAR(east.values[o], wanted.real(), 1e-6);  // float storage
          EXPECT_NEAR(north.values[o], wanted.imag(), 1e-6);
        }
      }
    }
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), depths.size());
    for (std::size_t k = 0; k < depths.size(); ++k) EXPECT_NEAR(found[k], depths[k], 1e-5);
  }
};

TEST_F(SeriesLayout, EveryWayOfStatingDepthGivesTheSameWater) {
  for (const Layout layout :
       {Layout::depth_axis, Layout::depth_axis_first, Layout::station_axis, Layout::upwards,
        Layout::above_bed, Layout::own_variables, Layout::own_stations}) {
    SCOPED_TRACE(static_cast<int>(layout));
    write_point_series(file, current_series(layout));
    expect_the_water(decode());
    std::filesystem::remove(file);
  }
}

TEST_F(SeriesLayout, SpeedAndDirectionGiveTheSameWaterAsComponents) {
  for (const Layout layout : {Layout::depth_axis, Layout::own_variables, Layout::own_stations}) {
    SCOPED_TRACE(static_cast<int>(layout));
    PointSeriesForTests series = current_series(layout);
    series.as_speed_and_direction = true;
    write_point_series(file, series);
    expect_the_water(decode());
    std::filesystem::remove(file);
  }
}

TEST_F(SeriesLayout, TheStandardErrorThatAFileStatesIsKeptInMetresPerSecond) {
  const auto stated = [&](Layout layout, bool as_speed, std::optional<double> error) {
    PointSeriesForTests series = current_series(layout);
    series.as_speed_and_direction = as_speed;
    series.standard_error_m_s = error;
    write_point_series(file, series);
    const Ingested ingested = decode();
    expect_the_water(ingested);
    const DecodedGranule& decoded = holding(ingested, "eastward_sea_water_velocity");
    const auto kept = GranuleFile::open(decoded.content_file).granule().stated_error_m_s;
    EXPECT_EQ(kept, decoded.granule.stated_error_m_s) << "the store keeps it";
    return kept;
  };
  for (const Layout layout :
       {Layout::depth_axis, Layout::own_variables, Layout::depth_axis_first}) {
    for (const bool as_speed : {false, true}) {
      ASSERT_TRUE(stated(layout, as_speed, 0.07));
      EXPECT_NEAR(*stated(layout, as_speed, 0.07), 0.07, 1e-6) << "written in cm/s";
    }
  }
  EXPECT_FALSE(stated(Layout::depth_axis, false, std::nullopt));
  EXPECT_FALSE(stated(Layout::depth_axis, false, 0.0)) << "nobody measures without an error";
}

TEST_F(SeriesLayout, AVariableMayBeCalledWhatItIs) {
  PointSeriesForTests series = current_series(Layout::depth_axis);
  series.bare = true;
  write_point_series(file, series);
  expect_the_water(decode());
}

TEST_F(SeriesLayout, HeightsAboveABedOfUnknownDepthAreRefusedWithTheRemedy) {
  netcdf::Writer writer = netcdf::Writer::create(file);
  const int time_dimension = writer.dimension("time", 2);
  const int level_dimension = writer.dimension("z", 2);
  const int time = writer.variable("time", netcdf::Type::float64, {time_dimension});
  writer.attribute(time, "units", "hours since 2019-10-01 00:00:00");
  const int z = writer.variable("z", netcdf::Type::float64, {level_dimension});
  writer.attribute(z, "units", "m");
  writer.attribute(z, "long_name", "height above sea bed");
  const int lat = writer.variable("lat", netcdf::Type::float64, {});
  const int lon = writer.variable("lon", netcdf::Type::float64, {});
  const int u = writer.variable("u", netcdf::Type::float32, {time_dimension, level_dimension});
  writer.attribute(u, "standard_name", "eastward_sea_water_velocity");
  writer.attribute(u, "units", "m s-1");
  writer.end_definitions();
  writer.write_all(time, std::vector<double>{0, 1});
  writer.write_all(z, std::vector<double>{5, 10});
  writer.write_all(lat, std::vector<double>{54});
  writer.write_all(lon, std::vector<double>{6});
  writer.write_all(u, std::vector<double>{0.1, 0.2, 0.3, 0.4});
  writer.close();
  EXPECT_NE(refusal().find("expected a global attribute water_depth"), std::string::npos)
      << refusal();
}

TEST_F(SeriesLayout, AWindWithAClockOfItsOwnIsReadBesideTheCurrent) {
  netcdf::Writer writer = netcdf::Writer::create(file);
  const auto axis = [&](const char* name, std::size_t length) {
    const int dimension = writer.dimension(name, length);
    const int id = writer.variable(name, netcdf::Type::float64, {dimension});
    writer.attribute(id, "units", "hours since 2019-10-01 00:00:00");
    return std::pair(dimension, id);
  };
  const auto [time_dimension, time] = axis("time", 4);
  const auto [wind_dimension, wind_time] = axis("time_wind", 2);
  const int lat = writer.variable("lat", netcdf::Type::float64, {});
  const int lon = writer.variable("lon", netcdf::Type::float64, {});
  const auto quantity = [&](const std::string& name, int dimension) {
    const int id = writer.variable(name, netcdf::Type::float32, {dimension});
    writer.attribute(id, "standard_name", name);
    writer.attribute(id, "units", "m s-1");
    return id;
  };
  const int u = quantity("eastward_sea_water_velocity", time_dimension);
  writer.attribute(u, "sensor_depth", 5.0);
  const int w = quantity("eastward_wind", wind_dimension);
  writer.end_definitions();
  writer.write_all(time, std::vector<double>{0, 0.5, 1, 1.5});
  writer.write_all(wind_time, std::vector<double>{0, 1});
  writer.write_all(lat, std::vector<double>{54});
  writer.write_all(lon, std::vector<double>{6});
  writer.write_all(u, std::vector<double>{0.1, 0.2, 0.3, 0.4});
  writer.write_all(w, std::vector<double>{7, 8});
  writer.close();
  const Ingested ingested = decode();
  EXPECT_EQ(holding(ingested, "eastward_sea_water_velocity").granule.grid.times(), 4U);
  const GriddedField wind = read(holding(ingested, "eastward_wind"), "eastward_wind");
  ASSERT_EQ(wind.grid.times(), 2U);
  EXPECT_EQ(wind.grid.time[1].start, parse_utc("2019-10-01T01:00:00Z"));
  EXPECT_FLOAT_EQ(wind.values[1], 8.0F);
}

}  // namespace
}  // namespace slackwater::ingest::tests::series_layouts_test
