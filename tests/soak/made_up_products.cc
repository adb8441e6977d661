// made_up_products FOLDER LATITUDE LONGITUDE TIME: five product files of 72 hours from TIME on
// around a place, as five providers would write them, to be ingested: three of currents on 20
// levels, wind, waves.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "tests/support/product_files_for_tests.h"

namespace {

using slackwater::tests::ProductForTests;

constexpr int hours = 72;
constexpr int cells = 24;
constexpr int levels = 20;
constexpr double spacing_deg = 0.02;

ProductForTests around(ProductForTests product, const std::string& title, double latitude_deg,
                       double longitude_deg, slackwater::UtcTime from) {
  product.title = title;
  product.time.clear();
  for (int h = 0; h < hours; ++h) product.time.push_back(from + std::chrono::hours(h));
  product.latitude_deg.clear();
  product.longitude_deg.clear();
  for (int i = 0; i < cells; ++i) {
    const double off_deg = (i - (cells - 1) / 2.0) * spacing_deg;
    product.latitude_deg.push_back(latitude_deg + off_deg);
    product.longitude_deg.push_back(longitude_deg + off_deg);
  }
  if (!product.depth_m.empty()) {
    product.depth_m.clear();
    for (int k = 0; k < levels; ++k) product.depth_m.push_back(1.75 * k);
  }
  return product;
}

void write_all(const std::filesystem::path& folder, double latitude_deg, double longitude_deg,
               slackwater::UtcTime from) {
  using namespace slackwater::tests;  // NOLINT(google-build-using-namespace)
  std::filesystem::create_directories(folder);
  const slackwater::UtcDay day = slackwater::day_of(from);
  const auto write = [&](const char* name, const ProductForTests& product, const char* title) {
    write_product(folder / name, around(product, title, latitude_deg, longitude_deg, from));
  };
  const ProductForTests currents = current_product(day);
  write("1.nc", currents, "NWSHELF_ANALYSISFORECAST_PHY_004_013 hourly currents");
  write("2.nc", currents, "IBI_ANALYSISFORECAST_PHY_005_001 hourly currents");
  write("3.nc", currents, "GLOBAL_ANALYSISFORECAST_PHY_001_024 hourly currents");
  write("4.nc", wind_product(day), wind_product(day).title.c_str());
  write("5.nc", wave_product(day), wave_product(day).title.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "give FOLDER LATITUDE LONGITUDE TIME\n");
    return 2;
  }
  try {
    write_all(argv[1], std::stod(argv[2]), std::stod(argv[3]), slackwater::parse_utc(argv[4]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "made_up_products: %s\n", error.what());
    return 1;
  }
  return 0;
}
