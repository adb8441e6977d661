#include "api/door/desk/site_list.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/ask/morning/morning.h"
#include "api/ask/plan/plan_file.h"
#include "api/ask/rehearse/mission_file.h"
#include "api/door/desk/report_page.h"
#include "api/pipeline/snapshot_json.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {
namespace {

using nlohmann::json;

template <typename T>
json or_null(const std::optional<T>& value) {
  return value ? json(*value) : json(nullptr);
}

json place_json(const GeoPoint& point) {
  return {{"longitude_deg", point.longitude_deg()}, {"latitude_deg", point.latitude_deg()}};
}

json route_json(const std::vector<GeoPoint>& points) {
  json route = json::array();
  for (const GeoPoint& point : points)
    route.push_back(json::array({point.longitude_deg(), point.latitude_deg()}));
  return route;
}

json forecast_json(const SiteState& state) {
  const store::ForecastRow& row = state.forecast.row;
  return {{"instance", state.forecast.instance},
          {"day", format_day(row.day)},
          {"issued", format_utc(row.issued)},
          {"valid_from", format_utc(row.valid_from)},
          {"valid_to", format_utc(row.valid_to)},
          {"age_s", std::chrono::duration<double>(state.age).count()},
          {"degraded", row.degraded},
          {"headline", row.headline}};
}

const ForecastCatalogue::SiteForecast* served(const ForecastCatalogue& catalogue,
                                              const std::string& id) {
  const auto found = std::find_if(catalogue.sites.begin(), catalogue.sites.end(),
                                  [&](const auto& site) { return site.site_id == id; });
  return found == catalogue.sites.end() ? nullptr : &*found;
}

/// What the store or the program describes of a site: a forecast answers without it.
struct Description {
  std::shared_ptr<const Site> site;
  std::string trouble;  ///< why it cannot be read; empty where it can, or there is none
};

Description description_of(const std::string& id, KeptSites& kept) {
  Description found;
  const auto failure = attempt([&] { found.site = kept.site(id); });
  if (failure && failure->kind != ErrorKind::not_found)
    found.trouble = "Its description cannot be read: " + failure->why + ".";
  return found;
}

std::string beside(const std::string& words, const std::string& trouble) {
  return trouble.empty() ? words : words + " " + trouble;
}

json site_line(const SiteState& state, const ForecastCatalogue& catalogue,
               const Freshness& freshness, KeptSites& kept) {
  const auto [site, trouble] = description_of(state.site_id, kept);
  json place = nullptr;
  if (site) {
    place = place_json(site->point);
  } else if (const auto* forecast = served(catalogue, state.site_id)) {
    place = place_json(forecast->field->snapshot().columns.front().point);
  }
  return {{"id", state.site_id},
          {"name", state.site_name},
          {"place", std::move(place)},
          {"time_zone", site && site->time_zone ? json(site->time_zone->name()) : json(nullptr)},
          {"status", name_of(state.condition)},
          {"in_words", beside(in_words(state, freshness), trouble)},
          {"forecast", forecast_json(state)},
          {"report", "/sites/" + state.site_id + "/report"},
          {"report_page", report_page_of(state.site_id, kept.store_folder(), freshness.now())
                              ? json("/sites/" + state.site_id + "/report.html")
                              : json(nullptr)}};
}

/// Of a site that the store describes, and has no forecast of.
json unforecast_line(const Site& site) {
  return {{"id", site.id},
          {"name", site.name},
          {"place", place_json(site.point)},
          {"time_zone", site.time_zone ? json(site.time_zone->name()) : json(nullptr)},
          {"status", "no_forecast"},
          {"in_words",
           "No forecast yet. Ingest product files, then run: slackwater forecast "
           "--site " +
               site.id},
          {"forecast", nullptr},
          {"report", nullptr},
          {"report_page", nullptr}};
}

json unreadable_line(const std::string& id, const std::string& trouble) {
  return {{"id", id},
          {"name", id},
          {"place", nullptr},
          {"time_zone", nullptr},
          {"status", "no_forecast"},
          {"in_words", trouble},
          {"forecast", nullptr},
          {"report", nullptr},
          {"report_page", nullptr}};
}

json turbine_json(const TurbinePlace& turbine) {
  json out = place_json(turbine.point);
  out["id"] = turbine.id;
  out["hub_height_m"] = or_null(turbine.hub_height_m);
  out["rotor_m"] = or_null(turbine.rotor_diameter_m);
  out["landing_deg"] = or_null(turbine.landing_deg);
  out["foundation"] = turbine.foundation ? json(name_of(turbine.foundation->kind)) : json(nullptr);
  json moorings = json::array();
  for (const Mooring& line : turbine.moorings)
    moorings.push_back({{"id", line.id},
                        {"bearing_deg", line.bearing_deg},
                        {"anchor_distance_m", line.anchor_distance_m}});
  out["moorings"] = std::move(moorings);
  return out;
}

json area_json(const ConstraintArea& area, UtcTime now) {
  return {{"id", area.id},
          {"kind", area.kind == AreaKind::exclusion ? "exclusion" : "traffic_lane"},
          {"reason", area.reason},
          {"ring", route_json(area.corners)},
          {"in_force_now", area.is_in_force(now)},
          {"below_height_m", or_null(area.below_height_m)},
          {"to_direction_deg", or_null(area.direction_deg)}};
}

json tasks_json(const Site& site) {
  json tasks = json::array();
  for (const std::string& task : site.tasks) {
    json name = task;
    static_cast<void>(
        attempt([&] { name = load_task(task, std::filesystem::current_path()).text("name"); }));
    tasks.push_back({{"id", task}, {"name", std::move(name)}});
  }
  return tasks;
}

/// Ports of the vessels of its plan, each once; a plan that cannot be read has none.
json ports_json(const Site& site, const std::filesystem::path& store) {
  json ports = json::array();
  static_cast<void>(attempt([&] {
    const std::filesystem::path file = plan_of_site(site.id, store);
    if (file.empty()) return;
    for (const PlanFile::Vessel& vessel : load_plan_file(file, store).vessels) {
      if (!vessel.port) continue;
      json port = place_json(vessel.port->point);
      port["name"] = vessel.port->name;
      if (std::find(ports.begin(), ports.end(), port) == ports.end())
        ports.push_back(std::move(port));
    }
  }));
  return ports;
}

void add_description(const Site& site, UtcTime now, const std::filesystem::path& store, json& out) {
  out["name"] = site.name;
  out["place"] = place_json(site.point);
  out["time_zone"] = site.time_zone ? json(site.time_zone->name()) : json(nullptr);
  out["shift"] = site.shift.empty() ? json(nullptr) : json(site.shift);
  out["water_depth_m"] = or_null(site.water_depth_m);
  out["chart_datum"] = chart_datum_json(site.chart_datum);
  json turbines = json::array(), cables = json::array(), areas = json::array();
  for (const TurbinePlace& turbine : site.turbines) turbines.push_back(turbine_json(turbine));
  for (const CableRoute& cable : site.cables)
    cables.push_back({{"id", cable.id},
                      {"points", route_json(cable.route)},
                      {"burial_depth_m", or_null(cable.burial_depth_m)}});
  for (const ConstraintArea& area : site.areas) areas.push_back(area_json(area, now));
  out["turbines"] = std::move(turbines);
  out["cables"] = std::move(cables);
  out["areas"] = std::move(areas);
  out["ports"] = ports_json(site, store);
  out["tasks"] = tasks_json(site);
  out["hub_height_m"] = or_null(site.hub_height_m);
}

void add_reach(const Snapshot& forecast, json& out) {
  json columns = json::array();
  for (std::size_t i = 0; i < forecast.columns.size(); ++i) {
    json column = place_json(forecast.columns[i].point);
    column["location"] = i == 0 ? forecast.site_id : forecast.site_id + "." + std::to_string(i);
    column["bed_m"] = forecast.columns[i].water_depth_m;
    columns.push_back(std::move(column));
  }
  out["columns"] = std::move(columns);
  out["levels_m"] = forecast.depth_m;
  out["times"] = {{"from", format_utc(forecast.time.front())},
                  {"to", format_utc(forecast.time.back())}};
  out["has_waves"] = has_waves(forecast);
}

}  // namespace

Site described_site(const std::string& id, const std::filesystem::path& store_folder) {
  const SiteText text = described_text(id, store_folder);
  return parse_site(text.yaml, text.file);
}

json sites_json(const IssuedFields& forecasts, const Freshness& freshness, KeptSites& kept) {
  const auto catalogue = forecasts.catalogue();
  json sites = json::array();
  std::vector<std::string> seen;
  for (const SiteState& state : site_states(*catalogue, freshness)) {
    sites.push_back(site_line(state, *catalogue, freshness, kept));
    seen.push_back(state.site_id);
  }
  for (const std::string& id : known_sites({kept.store_folder() / "sites"})) {
    if (std::find(seen.begin(), seen.end(), id) != seen.end()) continue;
    const auto [site, trouble] = description_of(id, kept);
    if (site) sites.push_back(unforecast_line(*site));
    if (!trouble.empty()) sites.push_back(unreadable_line(id, trouble));
  }
  return {{"now", format_utc(freshness.now())},
          {"stale_after_s", std::chrono::duration<double>(freshness.stale_after).count()},
          {"trouble", forecasts.trouble()},
          {"sites", std::move(sites)}};
}

json site_json(const std::string& id, const IssuedFields& forecasts, const Freshness& freshness,
               KeptSites& kept) {
  const auto catalogue = forecasts.catalogue();
  json out{{"id", id}, {"forecast", nullptr}};
  const auto* forecast = served(*catalogue, id);
  if (forecast == nullptr) {
    add_description(*kept.site(id), freshness.now(), kept.store_folder(), out);
  } else {
    out["name"] = forecast->field->snapshot().site_name;
    const auto [site, trouble] = description_of(id, kept);
    if (site) add_description(*site, freshness.now(), kept.store_folder(), out);
    out["trouble"] = trouble;
    add_reach(forecast->field->snapshot(), out);
  }
  for (const SiteState& state : site_states(*catalogue, freshness))
    if (state.site_id == id) {
      out["forecast"] = forecast_json(state);
      out["status"] = name_of(state.condition);
      out["in_words"] = in_words(state, freshness);
    }
  return out;
}

}  // namespace slackwater::api::desk
