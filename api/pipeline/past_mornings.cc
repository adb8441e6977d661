#include "api/pipeline/past_mornings.h"

#include <algorithm>

#include "api/pipeline/forecasts_to_score.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/verify/what_came.h"
#include "fields/base/attempt.h"
#include "fields/base/log.h"
#include "fields/base/parallel.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

constexpr std::chrono::days days_back{40};

ForecastsToScore mornings_before(store::Store& store, const Site& site, const Snapshot& forecast) {
  calibration::VerifyOptions options;
  options.from = forecast.day - days_back;
  options.to = forecast.day - std::chrono::days(1);
  options.issued_before = forecast.issued;
  ForecastsToScore chosen = forecasts_to_score(store, site, options);
  std::erase_if(chosen.rows, [&](const store::ForecastRow& row) {
    return row.wind_policy != *forecast.wind_policy;
  });
  return chosen;
}

std::vector<PastMorning> read_mornings(store::Store& store, const Site& site,
                                       const Snapshot& forecast, int threads) {
  const ForecastsToScore chosen = mornings_before(store, site, forecast);
  if (chosen.rows.empty()) return {};
  // An archive that was read later holds hours of the morning itself.
  const UtcTime known_by = std::min(forecast.issued, UtcTime(forecast.day) + std::chrono::days(1));
  std::vector<PastMorning> mornings;
  for (ForecastAndCame& one :
       what_came_of(store, site, chosen.rows, forecast.issued, known_by, threads)) {
    if (!one.fault.empty())
      log_event(LogLevel::warning, "past morning left out", {{"problem", one.fault}});
    if (one.came != nullptr && one.forecast->hindsight == forecast.hindsight)
      mornings.push_back(std::move(one));
  }
  return mornings;
}

}  // namespace

std::vector<PastMorning> past_mornings(const std::filesystem::path& store_folder, const Site& site,
                                       const Snapshot& forecast, int threads) {
  std::vector<PastMorning> mornings;
  if (!forecast.wind_policy || !std::filesystem::exists(store_folder / "catalogue.sqlite"))
    return mornings;
  const auto failure = attempt([&] {
    store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
    mornings = read_mornings(store, site, forecast, threads);
  });
  // Chances can be told without them, if less surely.
  if (failure) log_event(LogLevel::warning, "past mornings not read", {{"problem", failure->why}});
  return mornings;
}

std::vector<ForecastAndCame> what_came_of(store::Store& store, const Site& site,
                                          const std::vector<store::ForecastRow>& rows,
                                          UtcTime until, UtcTime known_by, int threads) {
  std::vector<ForecastAndCame> all(rows.size());
  if (rows.empty()) return all;
  UtcDay first = rows.front().day;
  for (const store::ForecastRow& row : rows) first = std::min(first, row.day);
  const SiteData data = load_site_data(store, site, UtcTime(first), until);
  std::vector<std::filesystem::path> files(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (const auto failure =
            attempt([&] { files[i] = store.proven_content(rows[i].content_sha256); }))
      all[i].fault = failure->why;
  for_all(rows.size(), threads, [&](std::size_t i) {
    if (files[i].empty()) return;
    const auto failure = attempt([&] {
      const auto said = std::make_shared<const Snapshot>(ingest::read_forecast(files[i]));
      const auto currents = currents_of_summary(rows[i].summary_json);
      const std::string& truth =
          currents.stands_in_for.empty() ? currents.dataset : currents.stands_in_for;
      all[i].came = calibration::what_came(data, *said, truth, known_by);
      all[i].forecast = said;
    });
    if (failure) all[i].fault = failure->why;
  });
  return all;
}

}  // namespace slackwater::api
