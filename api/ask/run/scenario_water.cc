#include <algorithm>

#include "api/ask/run/scenario_run.h"
#include "api/issued/in_force.h"
#include "api/pipeline/further_members.h"
#include "api/program/paths.h"
#include "data/store/store.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/base/text.h"
#include "fields/geo/local_frame.h"
#include "fields/site/site.h"
#include "ingest/apart/read_forecast_apart.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "twin/environment/made_up_field.h"

namespace slackwater::api {
namespace {

using twin::ForecastWater;
using twin::Scenario;

/// Where nobody says when, as good a time as any.
const UtcTime no_time = parse_utc("2000-01-01T00:00:00Z");

ScenarioWater made_up(const Scenario& scenario) {
  ScenarioWater water;
  const UtcTime start = scenario.start.value_or(no_time);
  const auto length = Duration(static_cast<Duration::rep>(scenario.duration_s * 1000) + 1000);
  water.surround.site = scenario.origin;
  water.surround.field = twin::made_up_field(std::get<twin::MadeUpWater>(scenario.water),
                                             scenario.origin, start, start + length);
  water.forecast_name = "made-up water";
  return water;
}

/// Of a file that somebody names.
ScenarioWater of_file(const std::filesystem::path& file) {
  return water_of(std::make_shared<const Snapshot>(ingest::read_forecast_apart(file)),
                  sha256_of_file(file));
}

ScenarioWater of_store(const store::Store& store, const std::string& content_sha256) {
  return water_of(
      std::make_shared<const Snapshot>(ingest::read_forecast(store.proven_content(content_sha256))),
      content_sha256);
}

/// Cables, moorings and turbines of the site about the scenario's origin, and the curve they share:
/// what they make is told also where the scenario has no wakes.
void add_farm(const Scenario& scenario, const Site& site, ScenarioWater& water) {
  water.surround.site = site.point;
  const LocalFrame frame(twin::origin_of(scenario, site.point));
  water.lines = twin::site_lines_of(site, frame);
  if (site.turbines.empty()) return;
  for (const TurbinePlace& turbine : site.turbines) {
    water.surround.turbines_m.push_back(horizontal_of(frame.to_local(turbine.point)));
  }
  water.surround.turbine =
      std::make_shared<Turbine>(Turbine::load(data_folder() / "turbines" / "nrel_5mw.yaml"));
}

/// Of the store, whose content is that of the forecast.
store::ForecastRow row_of(store::Store& store, const ScenarioWater& water, std::size_t members) {
  for (store::ForecastRow& row : store.list_forecasts())
    if (row.content_sha256 == water.forecast_sha256) return std::move(row);
  throw Error(ErrorKind::unavailable,
              formatted("the forecast {} was issued with {} members, and {} were asked for: this "
                        "store does not hold the forecast; ask for at most those issued, or name "
                        "the store that issued it (--store)",
                        water.forecast_name, water.members_issued, members));
}

/// The members that a scenario names, beyond those that were issued if need be.
void hold_member_of(const Scenario& scenario, const std::filesystem::path& store_folder,
                    ScenarioWater& water) {
  hold_members(water, scenario.member + 1, store_folder, 1);
}

}  // namespace

void hold_members(ScenarioWater& water, std::size_t members,
                  const std::filesystem::path& store_folder, int threads) {
  if (water.forecast_sha256.empty() || members <= water.surround.field->snapshot().members) return;
  store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
  const store::ForecastRow row = row_of(store, water, members);
  water.surround.field = std::make_shared<Field>(
      std::make_shared<Snapshot>(with_further_members(store, row, members, threads)));
}

ScenarioWater water_of(std::shared_ptr<const Snapshot> forecast, const std::string& sha256) {
  ScenarioWater water;
  water.forecast_sha256 = sha256;
  water.forecast_name = forecast->site_id + " " + format_day(forecast->day) + ", issued " +
                        format_utc(forecast->issued);
  water.members_issued = forecast->members;
  water.surround.site = forecast->columns.front().point;
  water.surround.field = std::make_shared<Field>(std::move(forecast));
  water.surround.data_folder = data_folder();
  return water;
}

ScenarioWater water_of(const Scenario& scenario, const std::filesystem::path& store_folder,
                       const std::filesystem::path& scenario_folder) {
  ScenarioWater water;
  if (std::holds_alternative<twin::MadeUpWater>(scenario.water)) {
    water = made_up(scenario);
  } else {
    const auto& wanted = std::get<ForecastWater>(scenario.water);
    if (!wanted.file.empty()) {
      const std::filesystem::path file = wanted.file;
      water = of_file(file.is_absolute() ? file : scenario_folder / file);
    } else {
      store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
      const Site site = find_site(wanted.site, site_folders(store_folder));
      const InForce in_force = forecast_in_force(store, {site.id, wanted.day, scenario.start});
      for (const std::string& damage : in_force.passed_over)
        log_event(LogLevel::warning, "forecast passed over", {{"problem", damage}});
      water = of_store(store, in_force.row.content_sha256);
      add_farm(scenario, site, water);
    }
  }
  hold_member_of(scenario, store_folder, water);
  water.surround.data_folder = data_folder();
  return water;
}

ScenarioWater water_of_log(const Scenario& scenario, const std::string& forecast_sha256,
                           const std::filesystem::path& store_folder,
                           const std::optional<std::filesystem::path>& file) {
  if (forecast_sha256.empty()) return water_of(scenario, store_folder, {});
  ScenarioWater water;
  if (file) {
    water = of_file(*file);
    if (water.forecast_sha256 != forecast_sha256) {
      throw Error(ErrorKind::invalid_input,
                  file->string() + ": is not the forecast of this log (checksum " +
                      water.forecast_sha256 + ", expected " + forecast_sha256 + ")");
    }
  } else {
    store::Store store = store::Store::open(store_folder, store::OpenMode::read_only);
    const std::filesystem::path content = store.content_path(forecast_sha256);
    if (!std::filesystem::exists(content)) {
      throw Error(ErrorKind::not_found,
                  "the forecast that the log ran in (checksum " + forecast_sha256 +
                      ") is not in the store " + store_folder.string() +
                      "; give the store with --store, or the file with --forecast");
    }
    water = of_store(store, forecast_sha256);
  }
  if (const auto* wanted = std::get_if<ForecastWater>(&scenario.water);
      wanted != nullptr && !wanted->site.empty())
    add_farm(scenario, find_site(wanted->site, site_folders(store_folder)), water);
  hold_member_of(scenario, store_folder, water);
  water.surround.data_folder = data_folder();
  return water;
}

}  // namespace slackwater::api
