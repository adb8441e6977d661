#include "tests/ingest/insitu/series_fixture.h"
#include "tests/support/contains.h"

namespace slackwater::ingest::tests::series_statistic_test {
namespace {

using netcdf::Type;
using netcdf::Writer;
using slackwater::tests::contains;

struct SeriesStatistic : SeriesTest {
  /// A buoy's wave heights with these cell methods, and its peak period where asked for.
  void write(const std::string& cell_methods, bool with_period) const {
    Writer writer = Writer::create(file);
    const int time = writer.dimension("TIME", 6);
    const int stamps = writer.variable("TIME", Type::float64, {time});
    writer.attribute(stamps, "units", "hours since 2024-03-01 00:00:00");
    writer.attribute(stamps, "standard_name", "time");
    const int latitude = writer.variable("LATITUDE", Type::float64, {});
    writer.attribute(latitude, "units", "degrees_north");
    writer.attribute(latitude, "standard_name", "latitude");
    const int longitude = writer.variable("LONGITUDE", Type::float64, {});
    writer.attribute(longitude, "units", "degrees_east");
    writer.attribute(longitude, "standard_name", "longitude");
    writer.attribute(Writer::global, "featureType", "timeSeries");
    const auto series = [&](const char* name, const char* standard_name, const char* unit) {
      const int id = writer.variable(name, Type::float32, {time});
      writer.attribute(id, "standard_name", standard_name);
      writer.attribute(id, "units", unit);
      return id;
    };
    const int height = series("VHM0", "sea_surface_wave_significant_height", "m");
    writer.attribute(height, "cell_methods", cell_methods);
    int period = -1;
    if (with_period) {
      period = series("VTPK", "sea_surface_wave_period_at_variance_spectral_density_maximum", "s");
    }
    writer.end_definitions();
    writer.write_all(stamps, std::vector<double>{0, 1, 2, 3, 4, 5});
    writer.write_all(latitude, std::vector<double>{54.0});
    writer.write_all(longitude, std::vector<double>{6.5});
    writer.write_all(height, std::vector<double>(6, 1.5));
    if (with_period) writer.write_all(period, std::vector<double>(6, 7.0));
    writer.close();
  }
};

TEST_F(SeriesStatistic, ABuoysMaximumIsNotItsHeight) {
  write("time: maximum", false);
  EXPECT_TRUE(contains(refusal(), "'VHM0': maximum over time")) << refusal();
  std::filesystem::remove(file);
  write("time: mean", false);
  EXPECT_EQ(refusal(), "nothing was refused");
}

TEST_F(SeriesStatistic, BesideOtherSeriesItIsLeftOutAndTold) {
  write("time: standard_deviation", true);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  EXPECT_EQ(ingested.granules[0].granule.variables.at(0).source_name, "VTPK");
  EXPECT_TRUE(contains(all_of(ingested.warnings), "'VHM0': standard deviation over time"));
}

}  // namespace
}  // namespace slackwater::ingest::tests::series_statistic_test
