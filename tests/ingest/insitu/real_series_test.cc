#include "tests/ingest/insitu/series_fixture.h"

namespace slackwater::ingest::tests::real_series_test {
namespace {

// Expected figures were read with netCDF4-python from the same files.
class RealSeries : public SeriesTest {
 protected:
  static std::filesystem::path one_in(const std::filesystem::path& folder,
                                      const std::string& beginning) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().filename().string().starts_with(beginning)) return entry.path();
    }
    throw Error(ErrorKind::not_found, "no " + beginning + " in " + folder.string());
  }
};

TEST_F(RealSeries, ASpanishBuoyGivesItsCurrentWindAndWaves) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(shared / "data" / "insitu" / "IR_201511_TS_MO_61198.nc");
  const DecodedGranule& current = holding(ingested, "eastward_sea_water_velocity");
  EXPECT_EQ(current.granule.station, "61198");
  EXPECT_EQ(current.granule.status, DataStatus::observation);
  EXPECT_TRUE(current.granule.is_point_series);
  EXPECT_EQ(current.granule.grid.vertical, VerticalKind::depth_m);
  EXPECT_EQ(current.granule.grid.levels_m, std::vector<double>{3.0});
  EXPECT_NEAR(current.granule.grid.latitude_deg[0], 36.5723, 1e-4);
  EXPECT_NEAR(current.granule.grid.longitude_deg[0], -2.3413, 1e-4);
  EXPECT_EQ(current.granule.grid.times(), 674U);
  EXPECT_EQ(count(read(current, "sea_water_speed"), SampleStatus::ok), 604U);
  EXPECT_EQ(count(read(current, "eastward_sea_water_velocity"), SampleStatus::ok),
            603U);  // one has no direction
  const DecodedGranule& wind = holding(ingested, "eastward_wind");
  EXPECT_EQ(wind.granule.grid.vertical, VerticalKind::height_m);
  EXPECT_EQ(wind.granule.grid.levels_m, std::vector<double>{3.0});
  EXPECT_EQ(count(read(wind, "eastward_wind"), SampleStatus::ok), 634U);
  EXPECT_EQ(count(read(holding(ingested, "sea_surface_wave_significant_height"),
                       "sea_surface_wave_significant_height"),
                  SampleStatus::ok),
            668U);
  EXPECT_NE(all_of(ingested.warnings).find("moves up to 707 m"), std::string::npos)
      << all_of(ingested.warnings);
}

TEST_F(RealSeries, Fino1KeepsItsInterleavedStampsApart) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(shared / "data" / "insitu" / "NO_TS_MO_FINO1_202209.nc");
  const DecodedGranule& spectral = holding(ingested, "sea_surface_wave_significant_height");
  const DecodedGranule& highest = holding(ingested, "sea_surface_wave_maximum_height");
  EXPECT_EQ(spectral.granule.grid.times(), 1439U);
  EXPECT_EQ(highest.granule.grid.times(), 1440U);
  EXPECT_EQ(spectral.granule.grid.time[0], TimeCell::instant(parse_utc("2022-09-01T00:02:00Z")));
  EXPECT_EQ(highest.granule.grid.time[0], TimeCell::instant(parse_utc("2022-09-01T00:00:00Z")));
  const GriddedField heights = read(spectral, "sea_surface_wave_significant_height");
  EXPECT_EQ(count(heights, SampleStatus::ok), 1438U);
  EXPECT_EQ(count(heights, SampleStatus::suspect), 1U);  // QC flag 4
  const DecodedGranule& water = holding(ingested, "sea_water_temperature");
  EXPECT_EQ(water.granule.grid.levels_m,
            std::vector<double>{0.5});  // the other six depths hold fill
  EXPECT_EQ(count(read(water, "sea_water_temperature"), SampleStatus::ok), 1439U);
}

TEST_F(RealSeries, TheRottnestProfilerLooksUpAndNineteenBinsPass) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(one_in(shared / "data" / "adcp", "IMOS"));
  const DecodedGranule& current = holding(ingested, "eastward_sea_water_velocity");
  const Grid& grid = current.granule.grid;
  ASSERT_EQ(grid.levels(), 19U);
  // Median of DEPTH(t) is 43.451 m; the bins that pass are 3.1 to 39.1 m above the sensor.
  EXPECT_NEAR(grid.levels_m.front(), 43.451 - 39.1, 0.001);
  EXPECT_NEAR(grid.levels_m.back(), 43.451 - 3.1, 0.001);
  EXPECT_LT(grid.latitude_deg[0], -32.0);
  EXPECT_EQ(current.granule.water_depth_m, 48.0);
  EXPECT_EQ(grid.time[0],
            (TimeCell{parse_utc("2018-08-16T08:00:00Z"), parse_utc("2018-08-16T08:30:00Z")}));
  const GriddedField east = read(current, "eastward_sea_water_velocity");
  EXPECT_EQ(count(east, SampleStatus::ok), 17U * 284U + 280U + 270U);
  EXPECT_EQ(count(east, SampleStatus::suspect), 18U);
  EXPECT_EQ(current.granule.variables.size(), 2U);
}

TEST_F(RealSeries, GarbageEnsemblesOfTheWashingtonProfilerAreRejectedAndCounted) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(one_in(shared / "data" / "adcp", "eh2"));
  const std::string warnings = all_of(ingested.warnings);
  EXPECT_NE(warnings.find("rejected 23 ensembles"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find(
                "rejected 5 ensembles of 'LCEWAP01, LCNSAP01' whole: every bin is exactly zero"),
            std::string::npos)
      << warnings;
  EXPECT_NE(warnings.find("read as looking down"), std::string::npos);
  EXPECT_NE(warnings.find("2005-05-30"), std::string::npos);
  const DecodedGranule& current = holding(ingested, "eastward_sea_water_velocity");
  const Grid& grid = current.granule.grid;
  ASSERT_EQ(grid.levels(), 14U);
  EXPECT_NEAR(grid.levels_m.front(), 6.94 + 4.2, 1e-5);
  EXPECT_NEAR(grid.levels_m.back(), 6.94 + 30.2, 1e-5);
  EXPECT_EQ(current.granule.water_depth_m, 45.5);
  const GriddedField east = read(current, "eastward_sea_water_velocity");
  const GriddedField north = read(current, "northward_sea_water_velocity");
  EXPECT_EQ(count(east, SampleStatus::ok), 0U);  // QC flag 0: nobody has looked
  EXPECT_EQ(count(east, SampleStatus::not_checked), 1165U * 14U - (23U + 5U) * 14U - 9U);
  double fastest = 0;
  for (std::size_t i = 0; i < east.values.size(); ++i) {
    EXPECT_EQ(std::isnan(east.values[i]), !has_value(east.status[i]));
    if (!std::isnan(east.values[i]))
      fastest = std::max<double>(fastest, std::hypot(east.values[i], north.values[i]));
  }
  EXPECT_LT(fastest, 0.9);
}

TEST_F(RealSeries, ADutchBuoyWithBareCoordinatesIsPlaced) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Ingested ingested = decode(shared / "data" / "dutch_coast_2017-10" / "HKNA_Hm0.nc");
  ASSERT_EQ(ingested.granules.size(), 1U);
  const Granule& granule = ingested.granules[0].granule;
  EXPECT_NEAR(granule.grid.latitude_deg[0], 52.6887, 1e-4);
  EXPECT_NEAR(granule.grid.longitude_deg[0], 4.242, 1e-4);
  EXPECT_EQ(granule.station, "HKNA");
  const GriddedField height = read(ingested.granules[0], "sea_surface_wave_significant_height");
  EXPECT_EQ(count(height, SampleStatus::not_checked), 564U);
  EXPECT_NEAR(*std::max_element(height.values.begin(), height.values.end()), 5.996F, 1e-3);
}

TEST_F(RealSeries, SpectraAreRefusedByName) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto path = shared / "data" / "spectra" / "42098w9999.nc";
  EXPECT_TRUE(is_point_series(netcdf::File::open(path)));
  try {
    static_cast<void>(decode(path));
    FAIL() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("wave spectrum"), std::string::npos) << error.message();
  }
}

TEST_F(RealSeries, GriddedProductsAreNotTakenForSeries) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const char* name :
       {"brest/windows/2023-11-02_currents.nc", "dutch_coast_2017-10/ERA5_DutchCoast.nc",
        "french_coast_2025-02/dataset_french_coast.nc", "odd_formats/Nordic_subset.nc",
        "elba_2014-05/currents/Sea_Med_slice_20140517_Elba.nc"}) {
    EXPECT_FALSE(is_point_series(netcdf::File::open(shared / "data" / name))) << name;
  }
}

}  // namespace
}  // namespace slackwater::ingest::tests::real_series_test
