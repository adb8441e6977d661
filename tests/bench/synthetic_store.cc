#include "tests/bench/synthetic_store.h"

#include "api/made_up/synthetic/product_files.h"
#include "tests/bench/timed_child.h"

namespace slackwater::bench {
namespace {

constexpr int days_in_store = 4;
constexpr int horizon_h = 72;

api::SyntheticOceanSettings settings() {
  api::SyntheticOceanSettings settings;
  settings.days = days_in_store + 4;
  return settings;
}

std::string at_five_after(UtcDay day) {
  return format_utc(UtcTime(day) + std::chrono::days(1) + std::chrono::hours(5));
}

}  // namespace

SyntheticStore::SyntheticStore()
    : ocean_(settings()),
      day_(ocean_.settings().first_day + std::chrono::days(days_in_store - 1)),
      site_file_(api::write_site_yaml(ocean_, folder_.path())) {
  const std::filesystem::path products = folder_ / "products";
  std::filesystem::create_directories(products);
  static_cast<void>(api::write_bathymetry(ocean_, products));
  for (UtcDay day = ocean_.settings().first_day; day <= day_; day += std::chrono::days(1)) {
    static_cast<void>(api::write_current_product(ocean_, day, day, products));
    static_cast<void>(api::write_wave_product(ocean_, day, day, products));
    static_cast<void>(api::write_wind_analysis(ocean_, day, day, products));
  }
  const UtcTime midnight = UtcTime(day_) + std::chrono::days(1);
  static_cast<void>(api::write_wind_forecast(ocean_, midnight, horizon_h, products));
  static_cast<void>(api::write_wave_forecast(ocean_, midnight, horizon_h, products));
  slackwater_or_throw(
      {"ingest", "--store", store().string(), "--at", at_five_after(day_), products.string()});
}

std::filesystem::path SyntheticStore::copy_of_store(const std::string& name) const {
  const std::filesystem::path copy = folder_ / name;
  std::filesystem::remove_all(copy);
  std::filesystem::copy(store(), copy, std::filesystem::copy_options::recursive);
  return copy;
}

std::vector<std::string> SyntheticStore::forecast_arguments(
    const std::filesystem::path& store, const std::filesystem::path& out) const {
  return {"forecast",       "--store", store.string(),      "--site", site_file_.string(), "--day",
          format_day(day_), "--at",    at_five_after(day_), "--out",  out.string()};
}

}  // namespace slackwater::bench
