#include <fstream>

#include "tests/ingest/insitu/series_fixture.h"
#include "tests/support/contains.h"
#include "tests/support/point_series_for_tests.h"

// In-situ files as the Copernicus Marine toolbox writes them: a place and a depth beside each
// value, `flags_values` and `flags_meanings`.

namespace slackwater::ingest::tests::toolbox_series_test {
namespace {

using slackwater::tests::contains;
using slackwater::tests::shared_folder;

struct ToolboxSeries : SeriesTest {};

TEST_F(ToolboxSeries, TheProfilerIsReadWithItsDepthsAndFlags) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(shared / "data/cases/usual_downloads/adcp.nc");
  const DecodedGranule& decoded = holding(ingested, "eastward_sea_water_velocity");
  EXPECT_EQ(decoded.granule.station, "B-Sulafjorden");
  EXPECT_EQ(decoded.granule.grid.levels_m, (std::vector<double>{3, 10, 25}));
  EXPECT_NEAR(decoded.granule.grid.latitude_deg.at(0), 48.85, 1e-12);
  EXPECT_NEAR(decoded.granule.grid.longitude_deg.at(0), -2.55, 1e-12);
  ASSERT_EQ(decoded.granule.grid.times(), 48U);
  const GriddedField east = read(decoded, "eastward_sea_water_velocity");
  // The first rows of the toolbox's table of the same data, adcp.csv.
  EXPECT_NEAR(east.values[east.grid.offset(0, 0, 0, 0)], 0.97, 1e-6);
  EXPECT_NEAR(east.values[east.grid.offset(0, 2, 0, 0)], 0.75, 1e-6);
  EXPECT_NEAR(east.values[east.grid.offset(1, 1, 0, 0)], 0.7872787368783669, 1e-6);
  EXPECT_EQ(count(east, SampleStatus::ok), east.values.size()) << "flag 1 of flags_values: good";
}

TEST_F(ToolboxSeries, TheBuoysWavesAreRead) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(shared / "data/cases/usual_downloads/waves.nc");
  const std::string height = "sea_surface_wave_significant_height";
  const GriddedField waves = read(holding(ingested, height), height);
  ASSERT_EQ(waves.values.size(), 48U);
  EXPECT_NEAR(waves.values[0], 1.2, 1e-6);
  EXPECT_NEAR(waves.values[1], 1.2497688398080244, 1e-6);
}

TEST_F(ToolboxSeries, TheyArePointSeriesAndNoCurvilinearGrids) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const char* name : {"adcp.nc", "waves.nc"}) {
    EXPECT_TRUE(is_point_series(netcdf::File::open(shared / "data/cases/usual_downloads" / name)))
        << name;
  }
}

TEST_F(ToolboxSeries, ANumberForNotMeasuredThatNoAttributeNamesIsMissing) {
  slackwater::tests::PointSeriesForTests series;
  series.time = slackwater::tests::stepping_times(parse_day("2019-10-01"), 1, 10);
  series.depth_m = {4};
  series.levels = slackwater::tests::SeriesLevelsForTests::depth_axis;
  const UtcTime broken = parse_utc("2019-10-01T06:00:00Z");
  series.value = [&](UtcTime time, double) {
    return time == broken ? Horizontal(-99.0, -99.0) : Horizontal(0.25, 0.5);
  };
  slackwater::tests::write_point_series(file, series);
  const Ingested ingested = decode();
  const GriddedField east =
      read(holding(ingested, "eastward_sea_water_velocity"), "eastward_sea_water_velocity");
  EXPECT_EQ(east.grid.times(), 143U) << "a granule has the stamps at which there are records";
  EXPECT_EQ(count(east, SampleStatus::suspect), 0U);
  EXPECT_TRUE(contains(all_of(ingested.warnings), "are -99, far from the others"));
}

}  // namespace
}  // namespace slackwater::ingest::tests::toolbox_series_test
