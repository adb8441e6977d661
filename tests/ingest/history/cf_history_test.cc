#include "ingest/history/cf_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "ingest/netcdf/file.h"
#include "tests/support/point_series_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::cf_history_test {
namespace {

const Vocabulary& words() {
  static const Vocabulary vocabulary =
      Vocabulary::load(slackwater::tests::source_folder() / "data" / "products" / "variables.yaml");
  return vocabulary;
}

/// A series as anybody's script writes it: no position, packed, hours since.
struct PlainSeries {
  std::string units = "m";
  std::string standard_name = "sea_surface_wave_significant_height";
  std::string time_units = "hours since 2002-01-01 00:00:00";
  std::vector<double> hours{0, 1, 2, 4};
  std::vector<std::int64_t> packed{120, 150, -32767, 151};
  std::size_t places = 1;
};

std::filesystem::path write(const std::filesystem::path& file, const PlainSeries& plain) {
  netcdf::Writer out = netcdf::Writer::create(file);
  const int time = out.dimension("time", plain.hours.size());
  const int place = out.dimension("station", plain.places);
  const int hours = out.variable("time", netcdf::Type::float64, {time});
  out.attribute(hours, "units", plain.time_units);
  netcdf::Writer::Layout layout;
  layout.fill_value = -32767;
  const int height = out.variable("height", netcdf::Type::int16, {time, place}, layout);
  out.attribute(height, "scale_factor", 0.01);
  if (!plain.units.empty()) out.attribute(height, "units", plain.units);
  if (!plain.standard_name.empty()) out.attribute(height, "standard_name", plain.standard_name);
  out.end_definitions();
  out.write_all(hours, plain.hours);
  const std::size_t start[] = {0, 0};
  const std::size_t count[] = {plain.packed.size(), 1};
  out.write(height, start, count, std::span<const std::int64_t>(plain.packed));
  out.close();
  return file;
}

class CfHistory : public testing::Test {
 protected:
  HistoryOfFile read(const PlainSeries& plain, const std::vector<std::string>& wanted) {
    return read_history(write(folder_ / "a.nc", plain), wanted, options_, words());
  }
  std::string refusal(const PlainSeries& plain, const std::string& wanted = "height") {
    try {
      static_cast<void>(read(plain, {wanted}));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << error.message();
      return error.message();
    }
    return "nothing was refused";
  }
  slackwater::tests::TemporaryFolder folder_;
  HistoryOptions options_;
};

#define EXPECT_SAYS(text, words) EXPECT_NE((text).find(words), std::string::npos) << (text)

TEST_F(CfHistory, AnyVariableOverTimeIsRead) {
  const HistoryOfFile found = read({}, {"sea_surface_wave_significant_height"});
  const HistorySeries& height = *found.series.at(0);
  EXPECT_EQ(height.name, "height");
  EXPECT_EQ(height.unit, "m");
  EXPECT_TRUE(height.is_single_precision);
  EXPECT_EQ(height.value[0], static_cast<double>(1.2F));
  EXPECT_TRUE(std::isnan(height.value[2]));
  EXPECT_EQ(height.time[3], parse_utc("2002-01-01T04:00:00Z"));
  EXPECT_FALSE(read({}, {"wind_speed"}).series.at(0).has_value());
}

TEST_F(CfHistory, TheUsersWordStandsAboveTheFile) {
  PlainSeries plain;
  plain.standard_name.clear();
  plain.units.clear();
  options_.columns = {{"height", "visibility_in_air", "km"}};
  const HistoryOfFile found = read(plain, {"visibility_in_air"});
  EXPECT_EQ(found.series.at(0)->unit, "km");
  EXPECT_EQ(found.series.at(0)->standard_name, "visibility_in_air");
}

TEST_F(CfHistory, BadFilesAreRefused) {
  PlainSeries plain;
  plain.hours = {0, 1, 1, 4};
  EXPECT_SAYS(refusal(plain), "duplicate time");
  plain.hours = {0, 2, 1, 4};
  EXPECT_SAYS(refusal(plain), "backward");
  plain = {};
  plain.units = "s";
  EXPECT_SAYS(refusal(plain), "found unit 's'");
  plain.units.clear();
  EXPECT_SAYS(refusal(plain), "found no units");
  plain = {};
  plain.places = 3;
  EXPECT_SAYS(refusal(plain), "found 3 places along 'station'");
  plain = {};
  plain.time_units = "hours";
  EXPECT_SAYS(refusal(plain), "no time axis");
}

TEST_F(CfHistory, ACurrentIsReadAtADepthBetweenItsLevels) {
  slackwater::tests::PointSeriesForTests point;
  point.depth_m = {5, 10, 20};
  point.time = slackwater::tests::stepping_times(parse_day("2002-01-01"), 1, 60);
  point.value = [](UtcTime, double depth_m) { return Horizontal(0.01 * depth_m, 0); };
  const auto file = slackwater::tests::write_point_series(folder_ / "current.nc", point);
  const auto speed_at = [&](std::optional<double> depth_m) {
    options_.depth_m = depth_m;
    return read_history(file, {"sea_water_speed"}, options_, words()).series.at(0)->value.at(7);
  };
  EXPECT_NEAR(speed_at(10), 0.1, 1e-7);
  EXPECT_NEAR(speed_at(17.5), 0.175, 1e-7);
  EXPECT_THROW(speed_at(std::nullopt), Error);
  EXPECT_THROW(speed_at(25), Error);
}

/// Between a current to north and one to east, as strong: to the north-east, not to 45 of any two
/// numbers.
TEST_F(CfHistory, ADirectionIsMadeOfTheComponentsBetweenLevels) {
  slackwater::tests::PointSeriesForTests point;
  point.depth_m = {5, 15};
  point.time = slackwater::tests::stepping_times(parse_day("2002-01-01"), 1, 60);
  point.value = [](UtcTime, double depth_m) {
    return depth_m < 10 ? Horizontal(-0.3, 0.3) : Horizontal(0.3, 0.3);
  };
  const auto file = slackwater::tests::write_point_series(folder_ / "current.nc", point);
  const auto to_at = [&](double depth_m) {
    options_.depth_m = depth_m;
    const auto found =
        read_history(file, {"sea_water_velocity_to_direction"}, options_, words()).series.at(0);
    EXPECT_EQ(found->unit, "degree");
    EXPECT_EQ(found->standard_name, "sea_water_velocity_to_direction");
    return found->value.at(7);
  };
  EXPECT_NEAR(to_at(5), 315, 1e-4);
  EXPECT_NEAR(to_at(10), 0, 1e-4);
  EXPECT_NEAR(to_at(15), 45, 1e-4);
}

TEST_F(CfHistory, AGridIsNoSeries) {
  const UtcDay day = parse_day("2025-03-06");
  const auto file = slackwater::tests::write_product(folder_ / "grid.nc",
                                                     slackwater::tests::current_product(day));
  options_.depth_m = 10;
  try {
    static_cast<void>(read_history(file, {"sea_water_speed"}, options_, words()));
    FAIL();
  } catch (const Error& error) {
    EXPECT_SAYS(error.message(), "5 places along");
    EXPECT_SAYS(error.message(), "--site");
  }
}

}  // namespace
}  // namespace slackwater::ingest::cf_history_test
