#include "api/made_up/demo/demo_run.h"

#include <cmath>

#include "api/made_up/synthetic/product_files.h"
#include "api/pipeline/daily_job.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/verify.h"
#include "api/program/paths.h"
#include "calibration/day/given/known_currents.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/record/slice.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {
namespace {

/// By day, out of Saint-Malo: 24 nautical miles at 20 knots.
constexpr const char* operation_yaml =
    "shift: 06:00-18:00\n"
    "access: {vessel: crew_transfer_vessel, passage: 75min}\n";

using std::chrono::days;
using std::chrono::hours;

/// Days of history before the first job: enough for the tide (three days are the least,
/// fields/docs/conventions.md).
constexpr int history_days = 4;
using constants::normal_p90;

/// One day's arrival: yesterday's analyses and the night's weather forecasts.
void deliver(store::Store& store, const ingest::ProductCatalogue& products,
             const SyntheticOcean& ocean, UtcDay day, bool with_forecasts,
             const std::filesystem::path& folder) {
  const UtcTime midnight = UtcTime(day) + days(1);
  std::vector<std::filesystem::path> files = write_current_product(ocean, day, day, folder);
  files.push_back(write_wave_product(ocean, day, day, folder));
  files.push_back(write_wind_analysis(ocean, day, day, folder));
  if (with_forecasts) {
    files.push_back(write_wind_forecast(ocean, midnight, 72, folder));
    files.push_back(write_wave_forecast(ocean, midnight, 72, folder));
  }
  for (const auto& file : files) {
    static_cast<void>(ingest_file(store, products, file, {}, midnight + hours(5), {}));
  }
}

/// Root mean square over times and levels of a forecast of the true current.
class TruthScore {
 public:
  void add(Horizontal forecast, Horizontal truth) {
    sum_ += std::norm(forecast - truth);
    n_ += 1;
  }
  [[nodiscard]] double rmse() const { return std::sqrt(sum_ / std::max(1.0, n_)); }

 private:
  double sum_ = 0;
  double n_ = 0;
};

/// The analysed current of the site nearest to a time: what the baselines know.
std::optional<Horizontal> analysed(const VectorColumn& column, UtcTime time, std::size_t k) {
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].centre() == time && column.has(t, k))
      return column.value[column.offset(t, k)];
  }
  return std::nullopt;
}

DemoDay score_against_truth(const SyntheticOcean& ocean, const SiteData& data,
                            const calibration::DailyForecast& forecast) {
  const Snapshot& s = forecast.snapshot;
  DemoDay result;
  result.day = s.day;
  const VectorColumn known =
      slice(calibration::known_currents(data.columns.front(), forecast.plan).record.column,
            UtcTime(s.day), forecast.plan.end_of_day());
  TruthScore ours;
  TruthScore persistence;
  TruthScore day_mean;
  TruthScore same_hour;
  double inside = 0;
  double components = 0;
  const ForecastColumn& column = s.columns.front();
  for (std::size_t k = 0; k < s.depth_m.size(); ++k) {
    Horizontal mean{};
    double n = 0;
    Horizontal last{};
    for (std::size_t t = 0; t < known.times(); ++t) {
      if (!known.has(t, k)) continue;
      last = known.value[known.offset(t, k)];
      mean += last;
      n += 1;
    }
    if (n == 0) continue;
    mean /= n;
    for (std::size_t t = 1;
         t < s.time.size() && s.time[t] <= forecast.plan.end_of_day() + hours(24); ++t) {
      const auto truth = ocean.current_truth(column.point, s.depth_m[k], s.time[t]);
      const std::size_t o = t * s.depth_m.size() + k;
      if (!truth || !has_value(column.current_status[o])) continue;
      ours.add(column.current_m_s[o], *truth);
      persistence.add(last, *truth);
      day_mean.add(mean, *truth);
      if (const auto before = analysed(known, s.time[t] - hours(24), k))
        same_hour.add(*before, *truth);
      const Horizontal miss = column.current_m_s[o] - *truth;
      const double band = normal_p90 * column.current_sigma_m_s[o];
      inside += (std::abs(miss.real()) <= band ? 1 : 0) + (std::abs(miss.imag()) <= band ? 1 : 0);
      components += 2;
    }
  }
  result.forecast_rmse_m_s = ours.rmse();
  result.persistence_rmse_m_s = persistence.rmse();
  result.day_mean_rmse_m_s = day_mean.rmse();
  result.same_hour_rmse_m_s = same_hour.rmse();
  result.coverage_80 = components > 0 ? inside / components : 0;
  return result;
}

}  // namespace

DemoResult run_demo(const DemoOptions& options,
                    const std::function<void(double, const std::string&)>& say) {
  SyntheticOceanSettings settings;
  settings.seed = options.seed;
  settings.days = history_days + options.days + 4;
  const auto total = static_cast<double>(history_days + options.days + 1);
  say(0, "making an ocean");
  DemoResult result{SyntheticOcean(settings), {}, {}, {}, {}, {}, {}};
  const SyntheticOcean& ocean = result.ocean;
  const std::filesystem::path files = options.folder / "products";
  std::filesystem::create_directories(files);
  const auto products = ingest::ProductCatalogue::load(data_folder() / "products");
  store::Store store =
      store::Store::open(options.folder / "store", store::OpenMode::create_or_write);
  const std::filesystem::path site_file =
      write_site_yaml(ocean, options.folder / "store" / "sites", operation_yaml);
  result.site = find_site(site_file.string(), {});
  static_cast<void>(ingest_file(store, products, write_bathymetry(ocean, files), {},
                                UtcTime(settings.first_day), {}));

  for (int i = 0; i < history_days + options.days; ++i) {
    const UtcDay day = settings.first_day + days(i);
    const bool is_run = i >= history_days;
    say((i + 1) / total, "day " + format_day(day));
    deliver(store, products, ocean, day, is_run, files);
    if (!is_run) continue;
    calibration::ForecastOptions options_of_day;
    options_of_day.issued = demo_issue_time(day);
    options_of_day.threads = 2;
    const SiteData data = load_site_data(
        store, result.site, UtcTime(day) - calibration::history_wanted, UtcTime(day) + days(4));
    const DailyJob job = daily_job(data, options_of_day);
    result.last_sha256 = publish(store, job, ForecastOrigin::forecast).content_sha256;
    result.days.push_back(score_against_truth(ocean, data, job.forecast));
    result.last = job.forecast.snapshot;
    result.last_making = calibration::making_of(job.forecast);
  }
  say(1, "verifying");
  result.skill = verify(store, result.site, {}).entries;
  return result;
}

}  // namespace slackwater::api
