#include "ingest/cf/granule_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "ingest/netcdf/file.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::granule_file_test {
namespace {

Granule granule_of(std::size_t times, std::size_t levels, std::size_t rows, std::size_t columns) {
  Granule granule;
  const UtcTime start = parse_utc("2024-03-01T00:00:00.123Z");
  for (std::size_t t = 0; t < times; ++t) {
    const UtcTime begin = start + std::chrono::hours(t);
    granule.grid.time.push_back({begin, begin + std::chrono::hours(1)});
  }
  granule.grid.vertical = VerticalKind::depth_m;
  for (std::size_t k = 0; k < levels; ++k)
    granule.grid.levels_m.push_back(0.494025 + 3.1 * static_cast<double>(k));
  for (std::size_t j = 0; j < rows; ++j)
    granule.grid.latitude_deg.push_back(46.0 + static_cast<double>(j) / 12.0);
  for (std::size_t i = 0; i < columns; ++i)
    granule.grid.longitude_deg.push_back(179.0 + static_cast<double>(i) / 12.0);
  granule.variables = {{"eastward_sea_water_velocity", "m s-1", "uo", true, false},
                       {"northward_sea_water_velocity", "m s-1", "vo", false, true}};
  granule.status = DataStatus::forecast;
  granule.reference_time = parse_utc("2024-02-29T06:00:00Z");
  granule.ensemble_member = 7;
  granule.water_depth_m = 35.25;
  granule.product_id = "TEST";
  granule.dataset_id = "cmems_mod_test";
  granule.attribution = "Nobody";
  granule.station = "Platform é";
  granule.is_point_series = true;
  return granule;
}

TEST(GranuleFile, TheRoundTripIsExact) {
  const slackwater::tests::TemporaryFolder folder;
  const Granule granule = granule_of(30, 5, 21, 37);
  Rng rng(42, "tests/granule_file");
  std::vector<float> values(granule.grid.size());
  for (float& value : values) {
    value = rng.uniform() < 0.3 ? std::numeric_limits<float>::quiet_NaN()
                                : static_cast<float>(rng.uniform(-2, 2));
  }
  std::vector<SampleStatus> status(values.size());
  for (SampleStatus& flag : status) flag = static_cast<SampleStatus>(rng.bits() % 9);
  {
    GranuleWriter writer(folder / "g.nc", granule);
    // Blocks that do not fit the chunks, in pieces of time and rows.
    for (std::size_t v = 0; v < 2; ++v) {
      for (std::size_t t = 0; t < 30; t += 7) {
        const std::size_t times = std::min<std::size_t>(7, 30 - t);
        for (std::size_t j = 0; j < 21; j += 10) {
          const std::size_t rows = std::min<std::size_t>(10, 21 - j);
          std::vector<float> block;
          for (std::size_t a = 0; a < times; ++a) {
            for (std::size_t k = 0; k < 5; ++k) {
              for (std::size_t b = 0; b < rows; ++b) {
                for (std::size_t i = 0; i < 37; ++i)
                  block.push_back(values[granule.grid.offset(t + a, k, j + b, i)]);
              }
            }
          }
          writer.put(v, t, times, j, rows, block);
        }
      }
    }
    writer.put_status(1, 0, 30, status);
    writer.finish();
  }
  const GranuleFile file = GranuleFile::open(folder / "g.nc");
  const Granule& found = file.granule();
  EXPECT_EQ(found.grid, granule.grid);
  EXPECT_EQ(found.variables, granule.variables);
  EXPECT_EQ(found.status, granule.status);
  EXPECT_EQ(found.reference_time, granule.reference_time);
  EXPECT_EQ(found.ensemble_member, granule.ensemble_member);
  EXPECT_EQ(found.water_depth_m, granule.water_depth_m);
  EXPECT_EQ(found.product_id, granule.product_id);
  EXPECT_EQ(found.dataset_id, granule.dataset_id);
  EXPECT_EQ(found.attribution, granule.attribution);
  EXPECT_EQ(found.station, granule.station);
  EXPECT_TRUE(found.is_point_series);

  const GriddedField block = file.read("northward_sea_water_velocity", 3, 10, 4, 6, 30, 7);
  EXPECT_EQ(block.grid.time.front(), granule.grid.time[3]);
  for (std::size_t t = 0; t < 10; ++t) {
    for (std::size_t k = 0; k < 5; ++k) {
      for (std::size_t j = 0; j < 6; ++j) {
        for (std::size_t i = 0; i < 7; ++i) {
          const std::size_t at = block.grid.offset(t, k, j, i);
          const std::size_t from = granule.grid.offset(3 + t, k, 4 + j, 30 + i);
          if (std::isnan(values[from])) {
            EXPECT_TRUE(std::isnan(block.values[at]));
          } else {
            EXPECT_EQ(block.values[at], values[from]);
          }
          EXPECT_EQ(block.status[at], status[from]);
        }
      }
    }
  }
}

TEST(GranuleFile, ChunksOfNothingTakeNoSpace) {
  const slackwater::tests::TemporaryFolder folder;
  Granule granule = granule_of(24, 10, 64, 64);
  granule.variables.pop_back();
  const std::vector<float> nothing(granule.grid.size(), std::numeric_limits<float>::quiet_NaN());
  GranuleWriter writer(folder / "g.nc", granule);
  writer.put(0, 0, 24, 0, 64, nothing);
  writer.finish();
  EXPECT_LT(std::filesystem::file_size(folder / "g.nc"),
            64U << 10);  // the values would take 3.9 MB
  const GriddedField field =
      GranuleFile::open(folder / "g.nc").read("eastward_sea_water_velocity", 23, 1, 60, 4, 0, 64);
  for (const float value : field.values) EXPECT_TRUE(std::isnan(value));
}

TEST(GranuleFile, AWriterThatIsNotFinishedLeavesNothing) {
  const slackwater::tests::TemporaryFolder folder;
  { const GranuleWriter writer(folder / "g.nc", granule_of(2, 2, 2, 2)); }
  EXPECT_FALSE(std::filesystem::exists(folder / "g.nc"));
}

TEST(GranuleFile, AStaticFieldHasNoTime) {
  const slackwater::tests::TemporaryFolder folder;
  Granule granule = granule_of(0, 0, 3, 4);
  granule.grid.vertical = VerticalKind::none;
  granule.variables = {{"sea_floor_depth_below_geoid", "m", "deptho", false, false}};
  GranuleWriter writer(folder / "g.nc", granule);
  writer.put(0, 0, 1, 0, 3, std::vector<float>(12, 30.0F));
  writer.finish();
  const GranuleFile file = GranuleFile::open(folder / "g.nc");
  EXPECT_EQ(file.granule().grid, granule.grid);
  EXPECT_EQ(file.read("sea_floor_depth_below_geoid", 0, 1, 0, 3, 0, 4).values,
            std::vector<float>(12, 30.0F));
}

TEST(GranuleFile, AForeignFileIsRefused) {
  const slackwater::tests::TemporaryFolder folder;
  netcdf::Writer writer = netcdf::Writer::create(folder / "f.nc");
  writer.end_definitions();
  writer.close();
  EXPECT_THROW((void)GranuleFile::open(folder / "f.nc"), Error);
}

}  // namespace
}  // namespace slackwater::ingest::granule_file_test
