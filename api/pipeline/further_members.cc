#include "api/pipeline/further_members.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/issued/in_force.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/snapshot_difference.h"
#include "api/program/version.h"
#include "calibration/day/daily_forecast.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/site/site.h"
#include "ingest/cf/forecast/forecast_file.h"

namespace slackwater::api {
namespace {

using calibration::ForecastOptions;
using nlohmann::json;
using std::chrono::days;

/// "forecast 12 of site S, issued T, holds 25 members and cannot be given 61: WHY; …".
[[noreturn]] void refuse(const store::ForecastRow& row, std::size_t held, std::size_t wanted,
                         const std::string& why) {
  const std::string version = code_version();
  std::string cause = "the store must still hold the same data";
  if (row.code_version != version)
    cause += ", and the program must be the same version: " + row.code_version +
             " made it, this is " + version;
  throw Error(ErrorKind::unavailable,
              "forecast " + std::to_string(row.id) + " of site " + row.site_id + ", issued " +
                  format_utc(row.issued) + ", holds " + std::to_string(held) +
                  " members and cannot be given " + std::to_string(wanted) +
                  ": making it again from the store gives another forecast (" + why + "). " +
                  "For more members " + cause + "; ask for at most " + std::to_string(held) +
                  " members, or issue a forecast now (`slackwater forecast --site " + row.site_id +
                  "`)");
}

/// The row with its summary, which lists of forecasts leave out.
store::ForecastRow whole_row(store::Store& store, const store::ForecastRow& row) {
  store::ForecastQuery query;
  query.site_id = row.site_id;
  query.from_day = query.to_day = row.day;
  for (store::ForecastRow& found : store.find_forecasts(query))
    if (found.id == row.id) return std::move(found);
  throw Error(ErrorKind::not_found, "found no forecast " + std::to_string(row.id) + " of site " +
                                        row.site_id + " in the store; it was pruned meanwhile");
}

/// How a forecast was asked for, as far as its summary tells.
struct Asked {
  Site site;
  ForecastOptions options;
  UtcDay wanted{};  ///< the day D that was asked for, or found
};

Asked asked_for(const store::ForecastRow& row, const Snapshot& issued) {
  const json summary = json::parse(row.summary_json);
  Asked asked;
  asked.site = parse_site(summary.at("site_yaml").get<std::string>(), row.site_id);
  ForecastOptions& options = asked.options;
  options.issued = row.issued;
  options.wind = row.wind_policy;
  options.horizon = std::chrono::round<Duration>(
      std::chrono::duration<double, std::ratio<3600>>(summary.at("horizon_h").get<double>()));
  options.hindsight = issued.hindsight;
  options.simulate_wind = issued.simulated_wind;
  options.seed = issued.seed;
  options.code_version = row.code_version;
  asked.wanted = day_of(row.valid_to - options.horizon) - days(1);
  return asked;
}

/// The summary does not say whether day D was named, nor whether later editions were looked at: the
/// daily job finds its day and looks at what was there by the issue time, a past day is named, and
/// a hindcast takes the store as an archive.
std::vector<ForecastOptions> ways_to_ask(const Asked& asked, const store::ForecastRow& row) {
  ForecastOptions found = asked.options;
  found.seen_by = row.issued;
  ForecastOptions named = found;
  named.day = asked.wanted;
  ForecastOptions of_archive = named;
  of_archive.seen_by = UtcTime::max();
  if (row.origin == ForecastOrigin::forecast) return {found, named};
  return {of_archive, named, found};
}

/// Adds to the values issued what was made beyond them, as a file would hold it.
void extend(std::vector<Horizontal>& issued, const std::vector<Horizontal>& made, double step_m_s) {
  issued.reserve(made.size());
  for (std::size_t i = issued.size(); i < made.size(); ++i)
    issued.push_back(ingest::as_filed(made[i], step_m_s));
}

Snapshot extended(Snapshot issued, const Snapshot& made) {
  for (std::size_t i = 0; i < issued.columns.size(); ++i) {
    ForecastColumn& column = issued.columns[i];
    const ForecastColumn& more = made.columns[i];
    extend(column.member_m_s, more.member_m_s, ingest::member_step_m_s);
    extend(column.wind_member_m_s, more.wind_member_m_s, ingest::wind_member_step_m_s);
    column.wind_member_number = more.wind_member_number;
  }
  issued.members = made.members;
  issued.wind_ensemble = made.wind_ensemble;
  return issued;
}

}  // namespace

Snapshot with_further_members(store::Store& store, const store::ForecastRow& row,
                              std::size_t members, int threads) {
  if (const auto damage = damage_of(store, row)) throw Error(ErrorKind::invalid_input, *damage);
  Snapshot issued = ingest::read_forecast(store.content_path(row.content_sha256));
  if (members <= issued.members) return issued;
  const store::ForecastRow whole = whole_row(store, row);
  Asked asked;
  if (attempt([&] { asked = asked_for(whole, issued); }))
    refuse(whole, issued.members, members, "its summary does not say how it was made");
  std::string why;
  for (ForecastOptions options : ways_to_ask(asked, whole)) {
    options.members = static_cast<int>(members) - 1;
    options.threads = threads;
    Snapshot made;
    std::string differs;
    const auto failure = attempt([&] {
      const SiteData data = load_site_data(store, asked.site, options);
      made = calibration::make_forecast(data, options).snapshot;
      differs = difference_of(issued, made);
    });
    if (failure) differs = failure->why;
    if (differs.empty() && made.members < members)
      differs = "no column has members, since no current was calibrated";
    if (differs.empty()) return extended(std::move(issued), made);
    if (why.empty()) why = differs;
  }
  refuse(whole, issued.members, members, why);
}

}  // namespace slackwater::api
