// made_up_store FOLDER PRODUCTS: a store with the made-up forecasts of tests/api/edr, for
// `slackwater serve`, and beside it product files and a mooring's around one of their sites, to be
// ingested.
#include "tests/api/door/edr/made_up_store.h"

#include <cstdio>
#include <exception>
#include <filesystem>

#include "tests/support/point_series_for_tests.h"
#include "tests/support/product_files_for_tests.h"

namespace {

/// In the water of the test products, moved to the farm.
slackwater::tests::ProductForTests at_the_farm(slackwater::tests::ProductForTests product) {
  product.latitude_deg = {57.15, 57.2, 57.25, 57.3};
  product.longitude_deg = {2.35, 2.4, 2.45, 2.5};
  return product;
}

slackwater::tests::PointSeriesForTests mooring_at_the_farm(slackwater::UtcDay day) {
  slackwater::tests::PointSeriesForTests series;
  series.latitude_deg = 57.21;
  series.longitude_deg = 2.45;
  series.time = slackwater::tests::stepping_times(day, 1, 10);
  series.depth_m = {5, 12.5};
  series.value = [](slackwater::UtcTime, double depth_m) {
    return slackwater::Horizontal(0.3, 0.01 * depth_m);
  };
  series.flag = [](slackwater::UtcTime, double) { return 1; };
  return series;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "give FOLDER PRODUCTS\n");
    return 2;
  }
  try {
    using namespace slackwater::tests;  // NOLINT(google-build-using-namespace)
    fill_with_made_up_forecasts(argv[1]);
    const std::filesystem::path folder = argv[2];
    std::filesystem::create_directories(folder);
    const slackwater::UtcDay day = slackwater::parse_day("2025-03-10");
    write_product(folder / "currents.nc", at_the_farm(current_product(day)));
    write_product(folder / "wind.nc", at_the_farm(wind_product(day)));
    write_product(folder / "waves.nc", at_the_farm(wave_product(day)));
    write_point_series(folder / "mooring.nc", mooring_at_the_farm(day));
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
