#include "api/made_up/synthetic/product_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/config.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/ingest.h"
#include "ingest/netcdf/file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::product_files_test {
namespace {

using ingest::netcdf::File;

const SyntheticOcean& ocean() {
  static const SyntheticOcean one({.days = 6});
  return one;
}

UtcDay first_day() { return ocean().settings().first_day; }

TEST(SyntheticProducts, CurrentsAreTheTruthWithTheStatedErrorAndMasksWhereThereIsNoWater) {
  const tests::TemporaryFolder folder;
  const auto files = write_current_product(ocean(), first_day(), first_day(), folder.path());
  ASSERT_EQ(files.size(), 4U);
  const File file = File::open(files[0]);
  const auto* uo = file.find("uo");
  const auto* vo = file.find("vo");
  ASSERT_TRUE(uo && vo);
  EXPECT_EQ(uo->dimensions, (std::vector<std::string>{"time", "depth", "latitude", "longitude"}));
  EXPECT_EQ(uo->shape, (std::vector<std::size_t>{24, 12, 24, 24}));
  const double fill = uo->number("_FillValue").value();
  EXPECT_NEAR(fill, 9.96921e36, 1e31);
  const std::vector<double> east = file.read_all(*uo);
  const std::vector<double> north = file.read_all(*vo);
  const std::vector<double> time = file.read_all(*file.find("time"));
  const std::vector<double> depth = file.read_all(*file.find("depth"));
  const std::vector<double> latitude = file.read_all(*file.find("latitude"));
  const std::vector<double> longitude = file.read_all(*file.find("longitude"));
  EXPECT_EQ(UtcTime(std::chrono::seconds{static_cast<long>(time[0])}), UtcTime(first_day()));

  double squares = 0;
  std::size_t wet = 0;
  std::size_t dry = 0;
  for (std::size_t t = 0; t < time.size(); t += 5) {
    for (std::size_t k = 0; k < depth.size(); ++k) {
      for (std::size_t j = 0; j < latitude.size(); j += 3) {
        for (std::size_t i = 0; i < longitude.size(); i += 3) {
          const std::size_t at =
              ((t * depth.size() + k) * latitude.size() + j) * longitude.size() + i;
          const auto truth =
              ocean().current_truth(GeoPoint::from_degrees(latitude[j], longitude[i]), depth[k],
                                    UtcTime(std::chrono::seconds{static_cast<long>(time[t])}));
          ASSERT_EQ(truth.has_value(), east[at] < 1e30);
          if (!truth) {
            ++dry;
            continue;
          }
          squares += std::norm(*truth - Horizontal{east[at], north[at]});
          ++wet;
        }
      }
    }
  }
  EXPECT_GT(dry, wet / 10);
  const double component_rms = std::sqrt(squares / static_cast<double>(wet) / 2);
  EXPECT_GT(component_rms, 0.004);  // the white noise alone
  EXPECT_LT(component_rms, 0.025);  // 1.2 cm/s of smooth error and its chance
}

TEST(SyntheticProducts, SameSeedSameBytesOfValues) {
  const tests::TemporaryFolder one;
  const tests::TemporaryFolder two;
  const auto a = write_wave_forecast(ocean(), UtcTime(first_day()), 24, one.path());
  const auto b = write_wave_forecast(ocean(), UtcTime(first_day()), 24, two.path());
  const File first = File::open(a);
  const File second = File::open(b);
  for (const char* name : {"VHM0", "VTPK", "VTM02", "VMDR", "VSDX", "VSDY"}) {
    EXPECT_EQ(first.read_all(*first.find(name)), second.read_all(*second.find(name))) << name;
  }
}

TEST(SyntheticProducts, WavesArePackedAndNearTheTruth) {
  const tests::TemporaryFolder folder;
  const File file =
      File::open(write_wave_product(ocean(), first_day(), first_day(), folder.path()));
  const auto* height = file.find("VHM0");
  const auto* from = file.find("VMDR");
  ASSERT_TRUE(height && from);
  const double scale = height->number("scale_factor").value();
  const std::size_t site = (6 * 24 + 12) * 24 + 12;  // 06:00, the middle cell
  const SyntheticSea truth =
      *ocean().sea_truth(ocean().settings().site, UtcTime(first_day()) + std::chrono::hours{6});
  EXPECT_NEAR(scale * file.read_all(*height)[site], truth.significant_height_m,
              0.12 * truth.significant_height_m);
  const double from_deg = from->number("scale_factor").value() * file.read_all(*from)[site] +
                          from->number("add_offset").value();
  EXPECT_LT(std::abs(std::remainder(from_deg - truth.from_direction_deg, 360.0)), 12);
}

TEST(SyntheticProducts, ForecastsSayWhenTheyWereIssuedAndAnalysesDoNot) {
  const tests::TemporaryFolder folder;
  const UtcTime issued = UtcTime(first_day()) + std::chrono::hours{24};
  const File forecast = File::open(write_current_forecast(ocean(), issued, 6, folder.path()));
  const auto* reference = forecast.find("forecast_reference_time");
  ASSERT_TRUE(reference);
  EXPECT_EQ(reference->text("standard_name"), "forecast_reference_time");
  EXPECT_EQ(UtcTime(std::chrono::seconds{static_cast<long>(forecast.read_all(*reference)[0])}),
            issued);
  EXPECT_EQ(forecast.find("time")->size(), 7U);
  const File analysis =
      File::open(write_current_product(ocean(), first_day(), first_day(), folder.path())[0]);
  EXPECT_EQ(analysis.find("forecast_reference_time"), nullptr);
}

TEST(SyntheticProducts, BathymetryHoldsTheDepthOfTheSiteAndNoDepthOnLand) {
  const tests::TemporaryFolder folder;
  const File file = File::open(write_bathymetry(ocean(), folder.path()));
  const std::vector<double> depth = file.read_all(*file.find("deptho"));
  EXPECT_NEAR(depth[12 * 24 + 12], 35, 1e-3);
  EXPECT_GT(depth[0], 1e30);  // the south-west corner is land
  EXPECT_EQ(file.find("mask")->shape, (std::vector<std::size_t>{12, 24, 24}));
}

TEST(SyntheticProducts, WindIsGribAndTheSiteIsAStrictYaml) {
  const tests::TemporaryFolder folder;
  for (const auto& path : {write_wind_analysis(ocean(), first_day(), first_day(), folder.path()),
                           write_wind_forecast(ocean(), UtcTime(first_day()), 72, folder.path())}) {
    std::ifstream in(path, std::ios::binary);
    std::string magic(8, '\0');
    in.read(magic.data(), 8);
    EXPECT_EQ(magic.substr(0, 4), "GRIB");
    EXPECT_EQ(magic[7], 2);
    EXPECT_LT(std::filesystem::file_size(path), 2U << 20);
  }
  const Config site = Config::load(write_site_yaml(ocean(), folder.path()));
  EXPECT_EQ(site.text("id"), "synthetic");
  EXPECT_DOUBLE_EQ(site.number("water_depth_m", {1, 100}), 35);
  EXPECT_DOUBLE_EQ(site.number("latitude_deg", {-90, 90}), 48.85);
}

/// Standard name of the first variable, status, number of times: what ingest makes of a file's
/// granules.
std::vector<std::string> ingested(const std::filesystem::path& file,
                                  const std::filesystem::path& staging) {
  static const auto products =
      ingest::ProductCatalogue::load(tests::source_folder() / "data/products");
  std::vector<std::string> out;
  for (const auto& decoded : ingest::decode_file(file, products, {}, staging).granules) {
    const Granule& granule = decoded.granule;
    out.push_back(granule.variables.at(0).standard_name + " " +
                  std::string(name_of(granule.status)) + " " +
                  std::to_string(granule.grid.times()));
  }
  return out;
}

TEST(SyntheticProducts, IngestReadsThemAsTheProductsTheyImitate) {
  const tests::TemporaryFolder folder;
  const tests::TemporaryFolder staging;
  const UtcTime issued(first_day());
  using Expected = std::vector<std::string>;
  const auto current = write_current_product(ocean(), first_day(), first_day(), folder.path());
  EXPECT_EQ(ingested(current[0], staging.path()),
            (Expected{"eastward_sea_water_velocity analysis 24"}));
  EXPECT_EQ(ingested(current[1], staging.path()),
            (Expected{"sea_water_potential_temperature analysis 24"}));
  EXPECT_EQ(ingested(write_wave_product(ocean(), first_day(), first_day(), folder.path()),
                     staging.path()),
            (Expected{"sea_surface_wave_significant_height analysis 24"}));
  // A run's first instant is no forecast: its reference time is not before its valid time.
  EXPECT_EQ(ingested(write_current_forecast(ocean(), issued, 6, folder.path()), staging.path()),
            (Expected{"eastward_sea_water_velocity analysis 1",
                      "eastward_sea_water_velocity forecast 6"}));
  EXPECT_EQ(ingested(write_wind_analysis(ocean(), first_day(), first_day(), folder.path()),
                     staging.path()),
            (Expected{"eastward_wind analysis 24"}));
  const auto wind =
      ingested(write_wind_forecast(ocean(), issued, 6, folder.path()), staging.path());
  ASSERT_FALSE(wind.empty());
  EXPECT_EQ(wind.back().substr(0, 22), "eastward_wind forecast");
}

}  // namespace
}  // namespace slackwater::api::product_files_test
