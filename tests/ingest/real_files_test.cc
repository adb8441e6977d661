// Every gridded NetCDF row of the real data's INDEX: read, or refused for the reason it gives. The
// expected values are those of xarray (netCDF4 engine), which decodes independently of our code:
//   python -c "import xarray as xr; d = xr.open_dataset(FILE); print(repr(float(d[V].isel(...))),
//              int(d[V].notnull().sum()), repr(float(d[V].astype('f8').mean())))"
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/ingest.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::real_files_test {
namespace {

class RealFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto shared = slackwater::tests::shared_folder();
    if (!shared) GTEST_SKIP() << "no real data: set SLACKWATER_SHARED to their folder";
    data_ = *shared / "data";
  }
  [[nodiscard]] Ingested read(const std::string& file, const IngestOptions& options = {}) const {
    return decode_file(data_ / file, products(), options, folder_.path());
  }
  [[nodiscard]] std::string refusal(const std::string& file) const {
    try {
      (void)read(file);
    } catch (const Error& error) {
      return std::string(name_of(error.kind())) + ": " + error.message();
    }
    return "nothing was thrown";
  }
  static const ProductCatalogue& products() {
    static const ProductCatalogue catalogue =
        ProductCatalogue::load(slackwater::tests::source_folder() / "data" / "products");
    return catalogue;
  }
  std::filesystem::path data_;
  slackwater::tests::TemporaryFolder folder_;
};

/// The whole field of one quantity, from whichever granule holds it.
GriddedField field_of(const Ingested& ingested, const std::string& standard_name) {
  for (const DecodedGranule& decoded : ingested.granules) {
    for (const GranuleVariable& variable : decoded.granule.variables) {
      if (variable.standard_name != standard_name) continue;
      const GranuleFile file = GranuleFile::open(decoded.content_file);
      const Grid& grid = file.granule().grid;
      return file.read(standard_name, 0, grid.times(), 0, grid.rows(), 0, grid.columns());
    }
  }
  throw Error(ErrorKind::not_found, "no granule holds " + standard_name);
}

struct Summary {
  std::size_t finite = 0;
  double mean = 0;
};

Summary summary_of(const GriddedField& field) {
  Summary summary;
  for (const float value : field.values) {
    if (std::isnan(value)) continue;
    ++summary.finite;
    summary.mean += static_cast<double>(value);
  }
  summary.mean /= static_cast<double>(std::max<std::size_t>(summary.finite, 1));
  return summary;
}

float at(const GriddedField& field, std::size_t t, std::size_t k, std::size_t j, std::size_t i) {
  return field.values[field.grid.offset(t, k, j, i)];
}

TimeCell cell(const char* start, const char* end) { return {parse_utc(start), parse_utc(end)}; }

// A float holds a value to 6e-8 of it; means of float values to the same.
constexpr double relative = 2e-7;

TEST_F(RealFiles, OtrantoCurrentsAreHourlyMeansAnalysed) {
  const Ingested u = read("otranto_2021-10/currents/211012_U.nc");
  const Ingested v = read("otranto_2021-10/currents/211012_V.nc");
  const Granule& granule = u.granules.at(0).granule;
  EXPECT_EQ(granule.product_id, "MEDSEA_ANALYSISFORECAST_PHY_006_013");
  EXPECT_EQ(granule.status, DataStatus::analysis);
  EXPECT_EQ(granule.grid.time.front(), cell("2021-10-12T00:00:00Z", "2021-10-12T01:00:00Z"));
  EXPECT_EQ(granule.grid.time.back(), cell("2021-10-12T23:00:00Z", "2021-10-13T00:00:00Z"));
  EXPECT_EQ(granule.grid, v.granules.at(0).granule.grid);
  const GriddedField east = field_of(u, "eastward_sea_water_velocity");
  EXPECT_FLOAT_EQ(at(east, 5, 2, 40, 50), 0.12210944294929504F);
  EXPECT_EQ(summary_of(east).finite, 408192U);
  EXPECT_NEAR(summary_of(east).mean, -0.015117359645288063, relative);
  EXPECT_FLOAT_EQ(at(field_of(v, "northward_sea_water_velocity"), 5, 2, 40, 50),
                  -0.004882798530161381F);
}

TEST_F(RealFiles, OtrantoWindIsInstantsAt10Metres) {
  const Ingested wind = read("otranto_2021-10/wind/20211012.nc");
  const Granule& granule = wind.granules.at(0).granule;
  EXPECT_EQ(granule.grid.vertical, VerticalKind::height_m);
  EXPECT_EQ(granule.grid.levels_m, std::vector<double>{10.0});
  EXPECT_EQ(granule.grid.time.front(), TimeCell::instant(parse_utc("2021-10-12T01:00:00Z")));
  // Latitudes fall in the file: row 2 of the file is row 14 of 17 here.
  EXPECT_FLOAT_EQ(at(field_of(wind, "eastward_wind"), 3, 0, 14, 5), -2.5289756157057948F);
}

TEST_F(RealFiles, ElbaIsOneForecastRunUnlessTheOperatorSaysAnalysis) {
  const std::string file = "elba_2014-05/currents/Sea_Med_slice_20140517_Elba.nc";
  const Ingested currents = read(file);
  const Granule& granule = currents.granules.at(0).granule;
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, parse_utc("2014-05-16T00:00:00Z"));
  EXPECT_EQ(granule.grid.levels_m, (std::vector<double>{0, 10, 30, 120}));
  EXPECT_EQ(granule.grid.time.front(), cell("2014-05-16T12:00:00Z", "2014-05-16T13:00:00Z"));
  const GriddedField east = field_of(currents, "eastward_sea_water_velocity");
  EXPECT_FLOAT_EQ(at(east, 7, 1, 3, 4), -0.02761520817875862F);
  EXPECT_EQ(summary_of(east).finite, 22392U);
  const GriddedField temperature = field_of(currents, "sea_water_potential_temperature");
  EXPECT_FLOAT_EQ(at(temperature, 7, 1, 3, 4), static_cast<float>(17.593849182128906 + 273.15));
  IngestOptions options;
  options.as = DataStatus::analysis;
  EXPECT_EQ(read(file, options).granules.at(0).granule.status, DataStatus::analysis);
}

TEST_F(RealFiles, ElbaWindSaysJulianAndIsGregorian) {
  const Ingested wind = read("elba_2014-05/wind/Wind_Med_slice_17_Elba.nc");
  const Granule& granule = wind.granules.at(0).granule;
  EXPECT_EQ(granule.grid.time.front(), TimeCell::instant(parse_utc("2014-05-16T23:00:00Z")));
  EXPECT_EQ(granule.status, DataStatus::forecast);
  EXPECT_EQ(granule.reference_time, parse_utc("2014-05-16T12:00:00Z"));
  ASSERT_EQ(wind.warnings.size(), 1U);
  EXPECT_NE(wind.warnings[0].find("julian"), std::string::npos);
}

TEST_F(RealFiles, OtrantoDailyMeansAreIntervals) {
  const Ingested currents = read("otranto_2023-08/currents/CMEMS_med_2023815_raw.nc");
  const Granule& granule = currents.granules.at(0).granule;
  EXPECT_EQ(granule.grid.time.front(), cell("2023-08-14T00:00:00Z", "2023-08-15T00:00:00Z"));
  EXPECT_EQ(granule.grid.time.size(), 5U);
  EXPECT_EQ(granule.grid.levels(), 28U);
  EXPECT_EQ(granule.status, DataStatus::analysis);
  const GriddedField east = field_of(currents, "eastward_sea_water_velocity");
  EXPECT_FLOAT_EQ(at(east, 2, 10, 12, 20), 0.07742681354284286F);
  EXPECT_EQ(summary_of(east).finite, 70095U);
  const GriddedField north_wind =
      field_of(read("otranto_2023-08/wind/era5_winds10_20230814.nc"), "northward_wind");
  EXPECT_FLOAT_EQ(at(north_wind, 7, 0, 6, 5), -3.0956835423479543F);  // packed short, rows turned
  EXPECT_NEAR(summary_of(north_wind).mean, -3.2720901290060644, 3.3 * relative);
}

TEST_F(RealFiles, FrenchCoastKeepsItsMaskAndStaysSmall) {
  const Ingested currents = read("french_coast_2025-02/dataset_french_coast.nc");
  const DecodedGranule& decoded = currents.granules.at(0);
  EXPECT_EQ(decoded.granule.product_id, "GLOBAL_ANALYSISFORECAST_PHY_001_024");
  EXPECT_EQ(decoded.granule.grid.time.front(),
            cell("2025-02-06T00:00:00Z", "2025-02-07T00:00:00Z"));
  EXPECT_EQ(decoded.granule.status, DataStatus::analysis);
  const Summary east = summary_of(field_of(currents, "eastward_sea_water_velocity"));
  EXPECT_EQ(east.finite, 148086U);
  EXPECT_NEAR(east.mean, -0.03529327867727756, relative);
  EXPECT_NEAR(summary_of(field_of(currents, "northward_sea_water_velocity")).mean,
              0.01168752730450782, relative);
  // 34.8 MB of floats, 3.4 % of them water.
  EXPECT_LT(std::filesystem::file_size(decoded.content_file), 12U << 20);
}

TEST_F(RealFiles, ArkonaHoldsCurrentWaveAndWindOnThreeGrids) {
  const Ingested sea = read("arkona_2023-07/reduced_testdata_weather.nc");
  ASSERT_EQ(sea.granules.size(), 3U);
  const GriddedField east = field_of(sea, "eastward_sea_water_velocity");
  EXPECT_EQ(east.grid.levels_m.size(), 1U);
  EXPECT_NEAR(east.grid.levels_m[0], 0.494025, 1e-6);
  EXPECT_FLOAT_EQ(at(east, 4, 0, 8, 6), 0.029918916005261635F);
  EXPECT_EQ(summary_of(east).finite, 960U);
  const GriddedField wind = field_of(sea, "eastward_wind");
  EXPECT_EQ(wind.grid.levels_m.front(), 10.0);
  EXPECT_EQ(wind.grid.levels_m.back(), 100.0);
  EXPECT_FLOAT_EQ(at(wind, 4, 3, 8, 6), 9.334518316332394F);
  EXPECT_FLOAT_EQ(at(field_of(sea, "sea_surface_wave_significant_height"), 4, 0, 8, 6),
                  0.6665897550665398F);
  for (const DecodedGranule& decoded : sea.granules) {
    EXPECT_EQ(decoded.granule.grid.time.front(),
              TimeCell::instant(parse_utc("2023-07-20T10:00:00Z")));
    for (const GranuleVariable& variable : decoded.granule.variables) {
      EXPECT_EQ(variable.contains_stokes,
                variable.source_name == "utotal" || variable.source_name == "vtotal");
    }
  }
}

TEST_F(RealFiles, HeightsOfAReliefBecomeDepths) {
  const GriddedField depth =
      field_of(read("arkona_2023-07/reduced_testdata_depth.nc"), "sea_floor_depth_below_geoid");
  EXPECT_FLOAT_EQ(at(depth, 0, 0, 100, 60), 37.853458404541016F);
  EXPECT_EQ(summary_of(depth).finite, 27401U);  // the cells below zero
}

TEST_F(RealFiles, DutchCoastWavesReadFromBothProviders) {
  const Ingested copernicus = read("dutch_coast_2017-10/CMEMS_DutchCoast_2017-10-28.nc");
  EXPECT_EQ(copernicus.granules.at(0).granule.product_id, "GLOBAL_MULTIYEAR_WAV_001_032");
  EXPECT_EQ(copernicus.granules.at(0).granule.variables.size(), 7U);
  const GriddedField direction = field_of(copernicus, "sea_surface_wave_from_direction");
  EXPECT_EQ(direction.unit, "degree");
  EXPECT_FLOAT_EQ(at(direction, 3, 0, 14, 20), 307.3F);
  EXPECT_EQ(summary_of(direction).finite, 5720U);
  const Ingested era5 = read("dutch_coast_2017-10/ERA5_DutchCoast.nc");
  const GriddedField height = field_of(era5, "sea_surface_wave_significant_height");
  EXPECT_FLOAT_EQ(at(height, 30, 0, 5, 9), 2.372879707079199F);  // row 5 of 11 is its own mirror
  EXPECT_EQ(summary_of(height).finite, 7571U);
  EXPECT_FLOAT_EQ(at(field_of(era5, "sea_surface_wave_from_direction"), 30, 0, 5, 9),
                  303.43176874202686F);
}

TEST_F(RealFiles, BrestWindowsAreInstantsOfOneCell) {
  for (const char* day : {"2023-11-02", "2024-06-01", "2024-08-05"}) {
    const Ingested currents = read("brest/windows/" + std::string(day) + "_currents.nc");
    const Grid& grid = currents.granules.at(0).granule.grid;
    EXPECT_EQ(grid.time.size(), 9U);
    EXPECT_FALSE(grid.time.front().is_mean());
    EXPECT_FALSE(currents.granules.at(0).granule.is_point_series);
    EXPECT_EQ(currents.granules.at(0).granule.dataset_id,
              "cmems_mod_glo_phy-cur_anfc_0.083deg_PT6H-i");
    EXPECT_EQ(read("brest/windows/" + std::string(day) + "_wind.nc")
                  .granules.at(0)
                  .granule.grid.time.size(),
              49U);
  }
  EXPECT_FLOAT_EQ(
      at(field_of(read("brest/windows/2023-11-02_currents.nc"), "eastward_sea_water_velocity"), 4,
         9, 0, 0),
      -0.19335615634918213F);
  EXPECT_FLOAT_EQ(
      at(field_of(read("brest/windows/2023-11-02_wind.nc"), "eastward_wind"), 10, 0, 1, 1), 15.72F);
}

TEST_F(RealFiles, PariaReadsPackedShortsAtLowLatitude) {
  const Ingested sea = read("odd_formats/paria/oce/Sea_Med_slice_20170423_Paria.nc");
  const Granule& granule = sea.granules.at(0).granule;
  EXPECT_EQ(granule.status, DataStatus::analysis);  // its bulletin date lies after the fields
  EXPECT_EQ(granule.grid.time.at(0), cell("2017-04-23T00:00:00Z", "2017-04-24T00:00:00Z"));
  const GriddedField east = field_of(sea, "eastward_sea_water_velocity");
  EXPECT_FLOAT_EQ(at(east, 0, 2, 40, 10), -0.3082369454205036F);
  EXPECT_EQ(summary_of(east).finite, 5704U);
  EXPECT_FLOAT_EQ(at(field_of(sea, "sea_water_potential_temperature"), 0, 2, 40, 10),
                  static_cast<float>(27.784630872309208 + 273.15));
  const Ingested wind = read("odd_formats/paria/met/Wind_Med_slice_23_Paria.nc");
  EXPECT_FLOAT_EQ(at(field_of(wind, "eastward_wind"), 1, 0, 3, 3), -8.570433605418142F);
}

TEST_F(RealFiles, EveryFileOfTheGriddedFoldersReads) {
  for (const char* name :
       {"otranto_2021-10", "elba_2014-05", "otranto_2023-08", "french_coast_2025-02",
        "arkona_2023-07", "brest/windows", "odd_formats/paria"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data_ / name)) {
      if (entry.path().extension() != ".nc") continue;
      const slackwater::tests::TemporaryFolder staging;
      EXPECT_NO_THROW({
        const Ingested ingested = decode_file(entry.path(), products(), {}, staging.path());
        for (const DecodedGranule& decoded : ingested.granules) {
          const GranuleFile file = GranuleFile::open(decoded.content_file);
          EXPECT_EQ(file.granule().grid, decoded.granule.grid) << entry.path();
          EXPECT_EQ(file.granule().variables, decoded.granule.variables) << entry.path();
        }
      }) << entry.path();
    }
  }
}

TEST_F(RealFiles, OddFormatsAreRefusedForTheirReasons) {
  const std::string nordic = refusal("odd_formats/Nordic_subset.nc");
  EXPECT_NE(nordic.find("invalid_input"), std::string::npos) << nordic;
  EXPECT_NE(nordic.find("terrain-following (s) vertical coordinate"), std::string::npos) << nordic;
  const std::string salinity =
      refusal("odd_formats/cmems_mod_med_phy-sal_anfc_4.2km-3D_PT1H-m_1705916517624.nc");
  EXPECT_NE(salinity.find("no velocity, wave or wind variable; found so (sea_water_salinity)"),
            std::string::npos)
      << salinity;
}

TEST_F(RealFiles, ATruncatedCopyIsRefusedAndLeavesNothing) {
  for (const char* name :
       {"otranto_2021-10/currents/211012_U.nc", "otranto_2021-10/wind/20211012.nc"}) {
    const auto cut = folder_ / "cut.nc";
    std::filesystem::copy_file(data_ / name, cut,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::permissions(cut, std::filesystem::perms::owner_all);
    std::filesystem::resize_file(cut, std::filesystem::file_size(cut) * 9 / 10);
    const slackwater::tests::TemporaryFolder staging;
    EXPECT_THROW((void)decode_file(cut, products(), {}, staging.path()), Error) << name;
    EXPECT_TRUE(std::filesystem::is_empty(staging.path())) << name;
  }
}

}  // namespace
}  // namespace slackwater::ingest::real_files_test
