// made_up_downloads FOLDER: what somebody might have downloaded this morning for a site off
// Saint-Brieuc: seven whole days of currents, waves and wind up to yesterday, the night's
// forecasts, and the water depth. Of a synthetic ocean.
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "api/made_up/synthetic/product_files.h"

namespace {

using namespace slackwater;
using std::chrono::days;

void write_all(const std::filesystem::path& folder) {
  constexpr int whole_days = 7;
  const UtcDay today = std::chrono::floor<days>(std::chrono::system_clock::now());
  api::SyntheticOceanSettings settings;
  settings.first_day = today - days(whole_days);
  settings.days = whole_days + 4;
  const api::SyntheticOcean ocean(settings);
  std::filesystem::create_directories(folder);
  const UtcDay yesterday = today - days(1);
  static_cast<void>(api::write_current_product(ocean, settings.first_day, yesterday, folder));
  static_cast<void>(api::write_wave_product(ocean, settings.first_day, yesterday, folder));
  static_cast<void>(api::write_wind_analysis(ocean, settings.first_day, yesterday, folder));
  static_cast<void>(api::write_wind_forecast(ocean, UtcTime(today), 72, folder));
  static_cast<void>(api::write_wave_forecast(ocean, UtcTime(today), 72, folder));
  static_cast<void>(api::write_bathymetry(ocean, folder));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::invalid_argument("usage: made_up_downloads FOLDER");
    write_all(argv[1]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "made_up_downloads: %s\n", problem.what());
    return 1;
  }
  return 0;
}
