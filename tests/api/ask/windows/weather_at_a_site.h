#pragma once
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "api/made_up/synthetic/product_files.h"
#include "api/pipeline/daily_job.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "api/program/paths.h"
#include "fields/base/numbers/random.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/grib/grib_writer.h"
#include "tests/support/product_files_for_tests.h"

// A store of daily forecasts whose weather, and the errors of its forecasts, are the caller's: the
// same over the whole area. Currents are those of the synthetic ocean.

namespace slackwater::tests {

/// What blows and rolls at a site.
struct Weather {
  std::function<Horizontal(UtcTime)> wind_m_s;  ///< 10 m, towards
  std::function<SeaState(UtcTime)> sea;
};

/// A model run that brings the weather too early or too late, and too much or too little of it, the
/// more the longer ahead: no noise that is added, which is what the synthetic products have.
class ShiftedRun {
 public:
  ShiftedRun(const Weather& truth, UtcTime issued, std::uint64_t seed)
      : truth_(truth), issued_(issued) {
    Rng random(seed, "shifted_run/" + format_utc(issued));
    late_h_a_day_ = 1.5 * random.normal();
    wind_a_day_ = 0.10 * random.normal();
    // A wind that is too strong raises too much of a sea, but not that alone.
    height_a_day_ = 1.2 * wind_a_day_ + 0.06 * random.normal();
  }
  [[nodiscard]] Horizontal wind_m_s(UtcTime time) const {
    return amplified(wind_a_day_, time) * truth_.wind_m_s(shifted(time));
  }
  [[nodiscard]] SeaState sea(UtcTime time) const {
    SeaState sea = truth_.sea(shifted(time));
    sea.significant_height_m *= amplified(height_a_day_, time);
    return sea;
  }

 private:
  [[nodiscard]] double days_ahead(UtcTime time) const {
    return std::max(0.0, hours_between(issued_, time) / 24);
  }
  [[nodiscard]] double amplified(double a_day, UtcTime time) const {
    return std::max(0.4, 1 + a_day * days_ahead(time));
  }
  [[nodiscard]] UtcTime shifted(UtcTime time) const {
    const double late_h = late_h_a_day_ * days_ahead(time);
    return time - std::chrono::round<Duration>(std::chrono::duration<double>(3600 * late_h));
  }

  const Weather& truth_;
  UtcTime issued_;
  double late_h_a_day_ = 0;
  double wind_a_day_ = 0;
  double height_a_day_ = 0;
};

/// Product files of one day at the site of the synthetic ocean.
class WeatherFiles {
 public:
  explicit WeatherFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  template <typename At>
  [[nodiscard]] std::filesystem::path wind(UtcTime run, int first_h, int last_h,
                                           const At& at) const {
    std::vector<ingest::GribField> fields;
    for (int step = first_h; step <= last_h; ++step) {
      // An analysis is a run of no length at each of its hours.
      const bool is_analysis = first_h == last_h - 23;
      ingest::GribField east{.short_name = "10u",
                             .reference_time = is_analysis ? run + std::chrono::hours(step) : run,
                             .step_hours = is_analysis ? 0 : step,
                             .member = std::nullopt,
                             .latitude_deg = {48.6, 48.7, 48.8, 48.9, 49.0, 49.1},
                             .longitude_deg = {-2.9, -2.8, -2.7, -2.6, -2.5, -2.4, -2.3, -2.2},
                             .values = {}};
      ingest::GribField north = east;
      north.short_name = "10v";
      const Horizontal wind = at(run + std::chrono::hours(step));
      east.values.assign(48, wind.real());
      north.values.assign(48, wind.imag());
      fields.push_back(std::move(east));
      fields.push_back(std::move(north));
    }
    const auto file = folder_ / ("wind_" + name_of(run, last_h) + ".grib2");
    ingest::write_grib(file, fields, 2, true);
    return file;
  }

  template <typename At>
  [[nodiscard]] std::filesystem::path waves(UtcTime run, int first_h, int last_h, bool is_forecast,
                                            const At& at) const {
    ProductForTests product = wave_product(day_of(run));
    product.latitude_deg = {48.80, 48.83, 48.86, 48.89};
    product.longitude_deg = {-2.60, -2.57, -2.54, -2.51};
    product.time.clear();
    for (int h = first_h; h <= last_h; ++h) product.time.push_back(run + std::chrono::hours(h));
    if (is_forecast) product.reference_time = run;
    product.quantity("VHM0").value = [at](const ProductCell& cell) {
      return at(cell.time).significant_height_m;
    };
    product.quantity("VTPK").value = [at](const ProductCell& cell) {
      return at(cell.time).peak_period_s;
    };
    product.quantity("VMDR").value = [at](const ProductCell& cell) {
      return at(cell.time).from_direction_deg;
    };
    return write_product(folder_ / ("waves_" + name_of(run, last_h) + ".nc"), product);
  }

 private:
  [[nodiscard]] static std::string name_of(UtcTime run, int last_h) {
    return format_day(day_of(run)) + "_" + std::to_string(last_h);
  }
  std::filesystem::path folder_;
};

/// A site whose forecasts were issued each morning at 05:00 for some weeks.
struct ForecastMornings {
  std::filesystem::path store;
  Site site;
};

/// Four days of history, then a forecast for each day, from runs that are shifted.
inline ForecastMornings forecast_mornings(const std::filesystem::path& folder,
                                          const api::SyntheticOcean& ocean, const Weather& weather,
                                          int days, std::uint64_t seed) {
  using std::chrono::hours;
  const auto products = ingest::ProductCatalogue::load(api::data_folder() / "products");
  std::filesystem::create_directories(folder / "products");
  ForecastMornings made{folder / "store", {}};
  store::Store store = store::Store::open(made.store, store::OpenMode::create_or_write);
  made.site = find_site(api::write_site_yaml(ocean, made.store / "sites").string(), {});
  const UtcDay first = ocean.settings().first_day;
  const WeatherFiles files(folder / "products");
  const auto take = [&](const std::filesystem::path& file, UtcTime now) {
    (void)api::ingest_file(store, products, file, {}, now, {});
  };
  take(api::write_bathymetry(ocean, folder / "products"), UtcTime(first));
  for (int i = 0; i < 4 + days; ++i) {
    const UtcDay day = first + std::chrono::days(i);
    const UtcTime midnight = UtcTime(day) + hours(24);
    const UtcTime morning = midnight + hours(5);
    for (const auto& file : api::write_current_product(ocean, day, day, folder / "products"))
      take(file, morning);
    take(files.wind(UtcTime(day), 0, 23, weather.wind_m_s), morning);
    take(files.waves(UtcTime(day), 0, 23, false, weather.sea), morning);
    if (i < 4) continue;
    const ShiftedRun run(weather, midnight, seed);
    take(files.wind(midnight, 0, 72, [&](UtcTime t) { return run.wind_m_s(t); }), morning);
    take(files.waves(midnight, 0, 72, true, [&](UtcTime t) { return run.sea(t); }), morning);
    calibration::ForecastOptions options;
    options.issued = morning;
    options.threads = 2;
    (void)api::publish(store,
                       api::daily_job(api::load_site_data(store, made.site, options), options),
                       ForecastOrigin::forecast);
  }
  return made;
}

}  // namespace slackwater::tests
