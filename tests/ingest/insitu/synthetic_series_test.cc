#include <array>
#include <numbers>

#include "tests/ingest/insitu/series_fixture.h"

namespace slackwater::ingest::tests::synthetic_series_test {
namespace {

using netcdf::Type;
using netcdf::Writer;

/// What a buoy file may ask of the reader.
struct Recipe {
  std::size_t times = 24;
  std::string feature = "timeSeriesProfile";
  std::string time_units = "hours since 2024-03-10 00:00:00";
  std::string speed_units = "cm s-1";
  double position_step_deg = 0.0;
  std::string title = "a buoy";
  bool backward = false;
  bool all_fill = false;
  bool with_wanted = true;
};

class SyntheticSeries : public SeriesTest {
 protected:
  /// One wind and one current meter at a point: speeds and directions that box the compass.
  void write_buoy(const Recipe& recipe) const {
    Writer writer = Writer::create(file);
    const int time_dimension = writer.dimension("TIME", recipe.times);
    const int time = writer.variable("TIME", Type::float64, {time_dimension});
    writer.attribute(time, "standard_name", "time");
    writer.attribute(time, "units", recipe.time_units);
    const int flags = writer.variable("TIME_QC", Type::int8, {time_dimension});
    writer.attribute(flags, "conventions", "OceanSITES reference table 2");
    const int latitude = writer.variable("LATITUDE", Type::float64, {time_dimension});
    writer.attribute(latitude, "standard_name", "latitude");
    const int longitude = writer.variable("LONGITUDE", Type::float64, {time_dimension});
    writer.attribute(longitude, "standard_name", "longitude");
    const auto variable = [&](const char* name, const std::string& standard_name,
                              const std::string& units, double sensor_depth) {
      const int id = writer.variable(name, Type::float32, {time_dimension}, {{}, 0, -999.0});
      writer.attribute(id, "standard_name", recipe.with_wanted ? standard_name : "air_pressure");
      writer.attribute(id, "units", units);
      writer.attribute(id, "sensor_depth", sensor_depth);
      return id;
    };
    const int wind_speed = variable("WSPD", "wind_speed", "m s-1", -4.0);
    const int wind_from = variable("WDIR", "wind_from_direction", "degree", -4.0);
    const int speed = variable("HCSP", "sea_water_speed", recipe.speed_units, 2.0);
    const int towards = variable("HCDT", "sea_water_velocity_to_direction", "degree", 2.0);
    writer.attribute(Writer::global, "featureType", recipe.feature);
    writer.attribute(Writer::global, "platform_code", "B1");
    writer.attribute(Writer::global, "title", recipe.title);
    writer.end_definitions();
    std::vector<double> hours;
    std::vector<double> good;
    std::vector<double> latitudes;
    std::vector<double> longitudes;
    std::vector<double> tens;
    std::vector<double> fifties;
    std::vector<double> directions;
    for (std::size_t t = 0; t < recipe.times; ++t) {
      const auto step = static_cast<double>(t);
      hours.push_back(recipe.backward && t == 5 ? 3.0 : step);
      good.push_back(t == 7 ? 4.0 : 1.0);
      latitudes.push_back(54.0);
      longitudes.push_back(179.999 + recipe.position_step_deg * step);
      tens.push_back(recipe.all_fill ? -999.0 : 10.0);
      fifties.push_back(recipe.all_fill ? -999.0 : 50.0);
      directions.push_back(recipe.all_fill ? -999.0 : 15.0 * step);
    }
    writer.write_all(time, hours);
    writer.write_all(flags, good);
    writer.write_all(latitude, latitudes);
    writer.write_all(longitude, longitudes);
    writer.write_all(wind_speed, tens);
    writer.write_all(wind_from, directions);
    writer.write_all(speed, fifties);
    writer.write_all(towards, directions);
    writer.close();
  }
};

TEST_F(SyntheticSeries, WindComesFromAndCurrentGoesTo) {
  write_buoy({});
  const Ingested ingested = decode();
  const DecodedGranule& wind = holding(ingested, "eastward_wind");
  const DecodedGranule& current = holding(ingested, "eastward_sea_water_velocity");
  EXPECT_EQ(wind.granule.grid.levels_m, std::vector<double>{4.0});
  EXPECT_EQ(current.granule.grid.levels_m, std::vector<double>{2.0});
  const GriddedField wind_east = read(wind, "eastward_wind");
  const GriddedField wind_north = read(wind, "northward_wind");
  const GriddedField east = read(current, "eastward_sea_water_velocity");
  const GriddedField north = read(current, "northward_sea_water_velocity");
  for (std::size_t i = 0; i < current.granule.grid.times(); ++i) {
    const double hour =
        hours_between(parse_utc("2024-03-10T00:00:00Z"), current.granule.grid.time[i].start);
    const double angle = 15.0 * hour * std::numbers::pi / 180.0;
    EXPECT_NEAR(wind_east.values[i], -10.0 * std::sin(angle), 1e-5);
    EXPECT_NEAR(wind_north.values[i], -10.0 * std::cos(angle), 1e-5);
    EXPECT_NEAR(east.values[i], 0.5 * std::sin(angle), 1e-6);  // 50 cm/s
    EXPECT_NEAR(north.values[i], 0.5 * std::cos(angle), 1e-6);
  }
}

TEST_F(SyntheticSeries, ATimeFlaggedBadIsLeftOut) {
  write_buoy({});
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.grid.times(), 23U);
  EXPECT_NE(all_of(ingested.warnings).find("left out 1 times"), std::string::npos);
}

TEST_F(SyntheticSeries, ABuoyAcrossTheAntimeridianHasItsMedianThere) {
  Recipe recipe;
  recipe.position_step_deg = 0.0002;  // 179.999 to 180.0036
  write_buoy(recipe);
  const Ingested ingested = decode();
  const double longitude = ingested.granules[0].granule.grid.longitude_deg[0];
  EXPECT_GT(std::abs(longitude), 179.99);
  EXPECT_GE(longitude, -180.0);
  EXPECT_LT(longitude, 180.0);
  EXPECT_NE(all_of(ingested.warnings).find("moves up to"), std::string::npos);
}

TEST_F(SyntheticSeries, AShipIsNotAMooring) {
  Recipe recipe;
  recipe.position_step_deg = 0.05;
  write_buoy(recipe);
  EXPECT_NE(refusal().find("not a ship or a drifter"), std::string::npos);
}

TEST_F(SyntheticSeries, WhatCannotBePlacedOrUnderstoodIsRefused) {
  Recipe backward;
  backward.backward = true;
  write_buoy(backward);
  EXPECT_NE(refusal().find("time runs backward at index 5"), std::string::npos) << refusal();

  Recipe unit;
  unit.speed_units = "kelvin";
  write_buoy(unit);
  EXPECT_NE(refusal().find("kelvin"), std::string::npos) << refusal();

  Recipe fill;
  fill.all_fill = true;
  write_buoy(fill);
  EXPECT_NE(refusal().find("no value was accepted"), std::string::npos) << refusal();

  Recipe foreign;
  foreign.with_wanted = false;
  write_buoy(foreign);
  EXPECT_NE(refusal().find("expected a current, wind or wave variable"), std::string::npos)
      << refusal();

  Recipe time;
  time.time_units = "months since 2024-03-10";
  write_buoy(time);
  EXPECT_NE(refusal().find("month"), std::string::npos) << refusal();
}

TEST_F(SyntheticSeries, WhatTheOperatorSaysWins) {
  write_buoy({});
  options.as = DataStatus::forecast;
  EXPECT_NE(refusal().find("--issued"), std::string::npos);
  options.issued = parse_utc("2024-03-09T00:00:00Z");
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.status, DataStatus::forecast);
  EXPECT_EQ(ingested.granules[0].granule.reference_time, options.issued);
  options = {};
  options.cut = BoundingBox::from_degrees(0, 50, 10, 60);
  EXPECT_NE(refusal().find("outside the box"), std::string::npos);
}

TEST_F(SyntheticSeries, AForecastOfOursIsNotTakenForAnObservation) {
  Recipe recipe;
  recipe.title = "Slackwater current forecast for somewhere";
  write_buoy(recipe);
  EXPECT_NE(refusal().find("Slackwater issued"), std::string::npos);
}

/// Two stations, each with a profile, bins before time in memory.
TEST_F(SyntheticSeries, EachStationOfAFileGetsItsGranule) {
  constexpr std::size_t times = 12;
  constexpr std::size_t levels = 5;
  Writer writer = Writer::create(file);
  const int stations = writer.dimension("station", 2);
  const int depth_dimension = writer.dimension("depth", levels);
  const int time_dimension = writer.dimension("time", times);
  const int time = writer.variable("time", Type::float64, {time_dimension});
  writer.attribute(time, "standard_name", "time");
  writer.attribute(time, "units", "hours since 2024-03-10 00:00:00");
  const int depth = writer.variable("depth", Type::float64, {depth_dimension});
  writer.attribute(depth, "standard_name", "depth");
  writer.attribute(depth, "units", "m");
  writer.attribute(depth, "positive", "down");
  const int latitude = writer.variable("lat", Type::float64, {stations});
  writer.attribute(latitude, "standard_name", "latitude");
  const int longitude = writer.variable("lon", Type::float64, {stations});
  writer.attribute(longitude, "standard_name", "longitude");
  const int east = writer.variable("u", Type::float32, {stations, depth_dimension, time_dimension});
  const int north =
      writer.variable("v", Type::float32, {stations, depth_dimension, time_dimension});
  for (const auto& [id, standard_name] : {std::pair(east, "eastward_sea_water_velocity"),
                                          std::pair(north, "northward_sea_water_velocity")}) {
    writer.attribute(id, "standard_name", standard_name);
    writer.attribute(id, "units", "m s-1");
  }
  writer.attribute(Writer::global, "featureType", "timeSeriesProfile");
  writer.attribute(Writer::global, "platform_code", "P");
  writer.end_definitions();
  std::vector<double> hours(times);
  for (std::size_t t = 0; t < times; ++t) hours[t] = static_cast<double>(t);
  writer.write_all(time, hours);
  writer.write_all(depth, std::array{25.0, 20.0, 15.0, 10.0, 5.0});  // from the bed up
  writer.write_all(latitude, std::array{54.0, 55.0});
  writer.write_all(longitude, std::array{6.0, 7.0});
  const auto truth = [](std::size_t s, std::size_t k, std::size_t t) {
    return 0.1 * static_cast<double>(s) + 0.01 * static_cast<double>(k) +
           0.001 * static_cast<double>(t) + 0.2;
  };
  std::vector<double> values;
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t k = 0; k < levels; ++k) {
      for (std::size_t t = 0; t < times; ++t) values.push_back(truth(s, k, t));
    }
  }
  writer.write_all(east, values);
  writer.write_all(north, values);
  writer.close();

  ASSERT_TRUE(is_point_series(netcdf::File::open(file)));
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 2U);
  EXPECT_EQ(ingested.granules[0].granule.station, "P-1");
  EXPECT_EQ(ingested.granules[1].granule.station, "P-2");
  EXPECT_EQ(ingested.granules[1].granule.grid.latitude_deg, std::vector<double>{55.0});
  EXPECT_EQ(ingested.granules[1].granule.grid.levels_m, (std::vector<double>{5, 10, 15, 20, 25}));
  const GriddedField field = read(ingested.granules[1], "eastward_sea_water_velocity");
  for (std::size_t t = 0; t < times; ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      EXPECT_EQ(field.values[field.grid.offset(t, k, 0, 0)],
                static_cast<float>(truth(1, levels - 1 - k, t)));
      EXPECT_EQ(field.status[field.grid.offset(t, k, 0, 0)], SampleStatus::not_checked);
    }
  }
}

/// A profiler on the bed whose depth follows the tide.
TEST_F(SyntheticSeries, BinsOfAHeavingSensorLieAtTheirMedianDepthAndSaySo) {
  constexpr std::size_t times = 25;
  Writer writer = Writer::create(file);
  const int time_dimension = writer.dimension("TIME", times);
  const int bins = writer.dimension("HEIGHT_ABOVE_SENSOR", 4);
  const int time = writer.variable("TIME", Type::float64, {time_dimension});
  writer.attribute(time, "standard_name", "time");
  writer.attribute(time, "units", "hours since 2024-03-10 00:00:00");
  const int height = writer.variable("HEIGHT_ABOVE_SENSOR", Type::float32, {bins});
  writer.attribute(height, "standard_name", "height");
  writer.attribute(height, "positive", "up");
  writer.attribute(height, "units", "m");
  writer.attribute(height, "reference_datum", "sensor");
  const int depth = writer.variable("DEPTH", Type::float32, {time_dimension});
  writer.attribute(depth, "standard_name", "depth");
  writer.attribute(depth, "units", "m");
  const int latitude = writer.variable("LATITUDE", Type::float64, {});
  writer.attribute(latitude, "standard_name", "latitude");
  const int longitude = writer.variable("LONGITUDE", Type::float64, {});
  writer.attribute(longitude, "standard_name", "longitude");
  const int east = writer.variable("UCUR", Type::float32, {time_dimension, bins});
  writer.attribute(east, "standard_name", "eastward_sea_water_velocity");
  writer.attribute(east, "units", "m s-1");
  writer.end_definitions();
  std::vector<double> hours(times);
  std::vector<double> depths(times);
  for (std::size_t t = 0; t < times; ++t) {
    hours[t] = static_cast<double>(t);
    depths[t] = 30.0 + 3.0 * std::cos(2 * std::numbers::pi * static_cast<double>(t) / 12.0);
  }
  writer.write_all(time, hours);
  writer.write_all(height, std::array{4.0, 8.0, 12.0, 16.0});
  writer.write_all(depth, depths);
  writer.write_all(latitude, std::array{54.0});
  writer.write_all(longitude, std::array{6.0});
  writer.write_all(east, std::vector<double>(times * 4, 0.25));
  writer.close();

  const Ingested ingested = decode();
  const std::vector<double> levels = ingested.granules.at(0).granule.grid.levels_m;
  ASSERT_EQ(levels.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(levels[k], 30.0 - 16.0 + 4.0 * static_cast<double>(k), 0.01);
  EXPECT_NE(all_of(ingested.warnings).find("half a bin"), std::string::npos)
      << all_of(ingested.warnings);
}

}  // namespace
}  // namespace slackwater::ingest::tests::synthetic_series_test
