#include "tests/ingest/grib/grib_fixture.h"

namespace slackwater::ingest::tests::grib_round_trip_test {
namespace {

struct Coding {
  int edition;
  bool ccsds;
};

class GribRoundTrip : public GribTest, public ::testing::WithParamInterface<Coding> {
 protected:
  void write(const std::vector<GribField>& fields) const {
    write_grib(file, fields, GetParam().edition, GetParam().ccsds);
  }
};

TEST_P(GribRoundTrip, KeepsEveryValueWithinThePackingStep) {
  std::vector<GribField> fields;
  for (const int step : {0, 3, 6}) {
    for (const char* name : {"10u", "10v"}) fields.push_back(wind_field(name, run, step));
  }
  write(fields);
  ASSERT_TRUE(is_grib(file));
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 1U);
  const Granule& granule = ingested.granules[0].granule;
  EXPECT_EQ(granule.grid.vertical, VerticalKind::height_m);
  EXPECT_EQ(granule.grid.levels_m, std::vector<double>{10.0});
  ASSERT_EQ(granule.grid.times(), 3U);
  EXPECT_EQ(granule.grid.time[2], TimeCell::instant(run + std::chrono::hours(6)));
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, run);
  EXPECT_EQ(granule.published_after, std::chrono::hours(7) + std::chrono::minutes(34)) << "ECMWF's";
  EXPECT_FALSE(granule.ensemble_member);
  for (const bool east : {true, false}) {
    const GriddedField field =
        read(ingested.granules[0], east ? "eastward_wind" : "northward_wind");
    EXPECT_EQ(field.unit, "m s-1");
    for (std::size_t t = 0; t < 3; ++t) {
      for (std::size_t j = 0; j < field.grid.rows(); ++j) {
        for (std::size_t i = 0; i < field.grid.columns(); ++i) {
          EXPECT_NEAR(
              field.values[field.grid.offset(t, 0, j, i)],
              wind_at(54.0 + 0.25 * static_cast<double>(j), 5.0 + 0.25 * static_cast<double>(i),
                      3.0 * static_cast<double>(t), east),
              packing_m_s);
        }
      }
    }
  }
}

TEST_P(GribRoundTrip, GivesOneGranuleForEachMember) {
  std::vector<GribField> fields;
  for (const int member : {0, 1, 17}) {
    for (const char* name : {"10u", "10v"}) {
      GribField field = wind_field(name, run, 3);
      field.member = member;
      for (double& value : field.values) value += member;
      fields.push_back(std::move(field));
    }
  }
  write(fields);
  const Ingested ingested = decode();
  ASSERT_EQ(ingested.granules.size(), 3U);
  const std::vector<int> members{0, 1, 17};
  for (std::size_t m = 0; m < members.size(); ++m) {
    EXPECT_EQ(ingested.granules[m].granule.ensemble_member, members[m]);
    EXPECT_NEAR(read(ingested.granules[m], "eastward_wind").values[0],
                wind_at(54, 5, 3, true) + members[m], packing_m_s);
  }
}

TEST_P(GribRoundTrip, AMaskedPointIsMissingAndItsNeighboursAreNot) {
  std::vector<GribField> fields{wind_field("10u", run, 3), wind_field("10v", run, 3)};
  fields[0].values[8] = std::nan("");
  write(fields);
  const GriddedField east = read(decode().granules[0], "eastward_wind");
  for (std::size_t i = 0; i < east.values.size(); ++i)
    EXPECT_EQ(std::isnan(east.values[i]), i == 8) << i;
}

TEST_P(GribRoundTrip, AFieldAcrossGreenwichStaysWhole) {
  const auto longitude = axis(-1.0, 0.5, 6);
  write({wind_field("10u", run, 3, axis(50, 0.5, 3), longitude),
         wind_field("10v", run, 3, axis(50, 0.5, 3), longitude)});
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.grid.longitude_deg, longitude);
  const GriddedField east = read(ingested.granules[0], "eastward_wind");
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(east.values[i], wind_at(50, longitude[i], 3, true), packing_m_s);
}

TEST_P(GribRoundTrip, AFieldAcrossTheAntimeridianRunsPast180) {
  const auto longitude = axis(178.0, 1.0, 5);
  write({wind_field("10u", run, 3, axis(-20, 1, 3), longitude),
         wind_field("10v", run, 3, axis(-20, 1, 3), longitude)});
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.grid.longitude_deg, longitude);
  const GriddedField north = read(ingested.granules[0], "northward_wind");
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(north.values[i], wind_at(-20, longitude[i], 3, false), packing_m_s);
}

TEST_P(GribRoundTrip, AGlobalFieldIsCutAcrossTheAntimeridian) {
  const auto latitude = axis(-90, 10, 19);
  const auto longitude = axis(0, 10, 36);
  write({wind_field("10u", run, 3, latitude, longitude),
         wind_field("10v", run, 3, latitude, longitude)});
  EXPECT_EQ(decode().granules[0].granule.grid.longitude_deg, axis(-180, 10, 36));

  options.cut = BoundingBox::from_degrees(165, -5, -165, 25);
  const Ingested ingested = decode();
  EXPECT_EQ(ingested.granules[0].granule.grid.longitude_deg,
            axis(160, 10, 5));  // one cell around: 160 to 200
  EXPECT_EQ(ingested.granules[0].granule.grid.latitude_deg, axis(-10, 10, 5));
  const GriddedField east = read(ingested.granules[0], "eastward_wind");
  // The file counts 0 to 350 and so did the synthetic wind: 200 E is 200 there and here.
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(east.values[i], wind_at(-10, 160 + 10 * static_cast<double>(i), 3, true),
                packing_m_s);
  }
}

std::string coding_name(const ::testing::TestParamInfo<Coding>& info) {
  return "Edition" + std::to_string(info.param.edition) + (info.param.ccsds ? "Ccsds" : "Simple");
}
INSTANTIATE_TEST_SUITE_P(AllCodings, GribRoundTrip,
                         ::testing::Values(Coding{1, false}, Coding{2, false}, Coding{2, true}),
                         coding_name);

TEST(WriteGrib, RefusesWhatGribCannotSay) {
  const slackwater::tests::TemporaryFolder folder;
  const GribField field = wind_field("10u", parse_utc("2024-02-28T12:00:00Z"), 0);
  EXPECT_THROW(write_grib(folder / "a.grib", {&field, 1}, 1, true), Error);
  EXPECT_THROW(write_grib(folder / "a.grib", {&field, 1}, 3, false), Error);
  EXPECT_THROW(write_grib(folder / "no such folder" / "a.grib", {&field, 1}, 2, false), Error);
}

}  // namespace
}  // namespace slackwater::ingest::tests::grib_round_trip_test
