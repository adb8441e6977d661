#include <array>

#include "tests/ingest/grib/grib_fixture.h"

namespace slackwater::ingest::tests::grib_grid_test {
namespace {

using GribGrid = GribTest;

/// Writes one field scanned as asked; its value is 100 * latitude + longitude, so every point tells
/// where it is.
void scan(grib::Message& message, bool westwards, bool northwards, bool columns_first,
          bool alternating) {
  constexpr long ni = 4;
  constexpr long nj = 3;
  message.set("Ni", ni);
  message.set("Nj", nj);
  message.set("iScansNegatively", westwards ? 1L : 0L);
  message.set("jScansPositively", northwards ? 1L : 0L);
  message.set("jPointsAreConsecutive", columns_first ? 1L : 0L);
  if (alternating) message.set("alternativeRowScanning", 1L);
  message.set("longitudeOfFirstGridPointInDegrees", westwards ? 2.0 : 359.0);
  message.set("longitudeOfLastGridPointInDegrees", westwards ? 359.0 : 2.0);
  message.set("latitudeOfFirstGridPointInDegrees", northwards ? 50.0 : 52.0);
  message.set("latitudeOfLastGridPointInDegrees", northwards ? 52.0 : 50.0);
  message.set("iDirectionIncrementInDegrees", 1.0);
  message.set("jDirectionIncrementInDegrees", 1.0);
  std::vector<double> values;
  const long lines = columns_first ? ni : nj;
  const long along = columns_first ? nj : ni;
  for (long line = 0; line < lines; ++line) {
    for (long n = 0; n < along; ++n) {
      const long step = alternating && line % 2 == 1 ? along - 1 - n : n;
      const long i = columns_first ? line : step;
      const long j = columns_first ? step : line;
      const double longitude =
          westwards ? 2.0 - static_cast<double>(i) : -1.0 + static_cast<double>(i);
      const double latitude =
          northwards ? 50.0 + static_cast<double>(j) : 52.0 - static_cast<double>(j);
      values.push_back((100 * latitude + longitude) / 200.0);
    }
  }
  message.set("bitsPerValue", 24L);
  message.set_values(values);
}

TEST_F(GribGrid, AllSixteenScanningModesGiveTheSameField) {
  for (unsigned mode = 0; mode < 16; ++mode) {
    const bool alternating = (mode & 8U) != 0;  // GRIB 1 has no such mode
    for (const int edition : alternating ? std::vector<int>{2} : std::vector<int>{1, 2}) {
      SCOPED_TRACE("edition " + std::to_string(edition) + " mode " + std::to_string(mode));
      write_bent(edition, [&](grib::Message& message) {
        scan(message, (mode & 1U) != 0, (mode & 2U) != 0, (mode & 4U) != 0, alternating);
      });
      const Ingested ingested = decode();
      const GriddedField east = read(ingested.granules.at(0), "eastward_wind");
      EXPECT_EQ(east.grid.latitude_deg, axis(50, 1, 3));
      EXPECT_EQ(east.grid.longitude_deg, axis(-1, 1, 4));
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
          const double expected =
              (100 * (50.0 + static_cast<double>(j)) - 1.0 + static_cast<double>(i)) / 200.0;
          EXPECT_NEAR(east.values[east.grid.offset(0, 0, j, i)], expected, 1e-5);
        }
      }
    }
  }
}

/// What the filter of NOMADS sends (a cut of 2026-07-29 as published: rows from south to north,
/// simple packing), one file a step and the files one after the other, as
/// `forecast --print-downloads` has them.
TEST_F(GribGrid, TheStepsOfAGfsRunCutByNomadsAreOneForecast) {
  std::vector<char> steps;
  for (const int step_h : {0, 3, 6}) {
    write_bent(2, [&](grib::Message& message) {
      message.set("centre", std::string("kwbc"));
      message.set("stepRange", std::to_string(step_h));
      scan(message, false, true, false, false);
    });
    const std::vector<char> one = contents();
    steps.insert(steps.end(), one.begin(), one.end());
  }
  write_contents(steps);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  const Granule& granule = ingested.granules[0].granule;
  EXPECT_EQ(granule.product_id, "NWP_kwbc");
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, run);
  EXPECT_EQ(granule.grid.levels_m, std::vector<double>{10.0});
  EXPECT_EQ(granule.grid.latitude_deg, axis(50, 1, 3));
  ASSERT_EQ(granule.grid.times(), 3U);
  for (std::size_t t = 0; t < 3; ++t)
    EXPECT_EQ(granule.grid.time[t],
              TimeCell::instant(run + std::chrono::hours(3 * static_cast<int>(t))));
  for (const char* name : {"eastward_wind", "northward_wind"})
    EXPECT_NEAR(read(ingested.granules[0], name).values[0], (100 * 50.0 - 1.0) / 200.0, 1e-5)
        << name;
}

TEST_F(GribGrid, AColumnThatRepeatsGreenwichIsDropped) {
  write_grib(file,
             std::array{wind_field("10u", run, 3, axis(0, 10, 3), axis(0, 10, 36)),
                        wind_field("10v", run, 3, axis(0, 10, 3), axis(0, 10, 36))},
             2, false);
  const std::vector<double> once = decode().granules[0].granule.grid.longitude_deg;
  write_bent(2, [](grib::Message& message) {
    message.set("Ni", 37L);
    message.set("Nj", 2L);
    message.set("longitudeOfFirstGridPointInDegrees", 0.0);
    message.set("longitudeOfLastGridPointInDegrees", 360.0);
    message.set("latitudeOfFirstGridPointInDegrees", 10.0);
    message.set("latitudeOfLastGridPointInDegrees", 0.0);
    message.set("iDirectionIncrementInDegrees", 10.0);
    message.set("jDirectionIncrementInDegrees", 10.0);
    message.set_values(std::vector<double>(74, 5.0));
  });
  EXPECT_EQ(decode().granules[0].granule.grid.longitude_deg, once);
}

TEST_F(GribGrid, OtherGridsAreRefusedWithTheirNameAndTheRemedy) {
  for (const char* type : {"rotated_ll", "lambert", "polar_stereographic", "mercator"}) {
    write_bent(2, [&](grib::Message& message) { message.set("gridType", std::string(type)); });
    const std::string why = refusal();
    EXPECT_NE(why.find(type), std::string::npos) << why;
    EXPECT_NE(why.find("regular_ll"), std::string::npos) << why;
    EXPECT_NE(why.find("cdo remapbil"), std::string::npos) << why;
  }
  std::ofstream stream(file, std::ios::binary);
  auto message = grib::Message::from_sample("reduced_gg_sfc_grib2");
  message.set("shortName", std::string("10u"));
  const auto bytes = message.bytes();
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  stream.close();
  EXPECT_NE(refusal().find("reduced_gg"), std::string::npos);
}

TEST_F(GribGrid, TwoGridsInOneFileBecomeTwoGranules) {
  write_grib(file,
             std::array{wind_field("10u", run, 3), wind_field("10v", run, 3),
                        wind_field("10u", run, 3, axis(40, 1, 3), axis(0, 1, 3)),
                        wind_field("10v", run, 3, axis(40, 1, 3), axis(0, 1, 3))},
             2, false);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 2U);
  EXPECT_NE(ingested.granules[0].granule.grid, ingested.granules[1].granule.grid);
  EXPECT_NE(ingested.granules[0].content_file, ingested.granules[1].content_file);
}

TEST_F(GribGrid, ABoxElsewhereIsRefused) {
  write_grib(file, std::array{wind_field("10u", run, 3), wind_field("10v", run, 3)}, 2, false);
  options.cut = BoundingBox::from_degrees(100, 0, 110, 10);
  EXPECT_NE(refusal().find("the cut selects nothing"), std::string::npos);
}

TEST_F(GribGrid, AnImpossibleSizeIsRefusedBeforeMemoryIsTaken) {
  write_bent(2, [](grib::Message& message) {
    message.set("Ni", 60000L);
    message.set("Nj", 60000L);
  });
  EXPECT_NE(refusal().find("60000 x 60000"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_grid_test
