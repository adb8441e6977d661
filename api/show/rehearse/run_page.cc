#include "api/show/rehearse/run_page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/log/account_log.h"
#include "api/show/coverage/page.h"
#include "api/show/rehearse/account_text.h"
#include "api/show/rehearse/detections_report.h"
#include "api/show/rehearse/limit_bounds.h"
#include "api/show/rehearse/run_page_traffic.h"
#include "api/show/report/assets.h"
#include "api/show/report/html_page.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using nlohmann::json;

/// A page draws no more points of a line than a screen has pixels.
constexpr std::size_t most_points = 1500;

struct Rows {
  std::size_t times = 0;
  std::size_t every = 1;
  [[nodiscard]] std::vector<std::size_t> drawn() const {
    std::vector<std::size_t> rows;
    for (std::size_t t = 0; t < times; t += every) rows.push_back(t);
    if (times > 0 && rows.back() != times - 1) rows.push_back(times - 1);
    return rows;
  }
};

/// Part `k` of a variable of one vehicle, at the rows that are drawn.
json line_of(const TrajectoryFile& log, const Rows& rows, std::size_t vehicle, const char* name,
             std::size_t k = 0, double scale = 1) {
  json out = json::array();
  const TrajectoryFile::Variable* v = log.find(name);
  for (const std::size_t t : rows.drawn())
    out.push_back(v == nullptr || k >= v->per
                      ? json(nullptr)
                      : number(scale * v->values[(vehicle * rows.times + t) * v->per + k]));
  return out;
}

bool is_ever(const TrajectoryFile& log, const Rows& rows, std::size_t vehicle, const char* name,
             std::size_t k) {
  const TrajectoryFile::Variable* v = log.find(name);
  if (v == nullptr || k >= v->per) return false;
  for (std::size_t t = 0; t < rows.times; ++t)
    if (std::abs(v->values[(vehicle * rows.times + t) * v->per + k]) > 0) return true;
  return false;
}

json vehicle_json(const TrajectoryFile& log, const Rows& rows, std::size_t i) {
  constexpr double degrees_a_radian = 1 / constants::degree;
  const auto line = [&](const char* name, std::size_t k = 0, double scale = 1) {
    return line_of(log, rows, i, name, k, scale);
  };
  json thrust = json::array();
  const TrajectoryFile::Variable* t = log.find("thrust");
  for (std::size_t k = 0; t != nullptr && k < t->per; ++k)
    if (is_ever(log, rows, i, "thrust", k)) thrust.push_back(line("thrust", k));
  return {{"name", log.names[i]},
          {"x", line("x")},
          {"y", line("y")},
          {"z", line("z")},
          {"roll", line("roll", 0, degrees_a_radian)},
          {"pitch", line("pitch", 0, degrees_a_radian)},
          {"yaw", line("yaw", 0, degrees_a_radian)},
          {"thrust", thrust},
          {"power", line("electrical_power")},
          {"charge", line("state_of_charge", 0, 100)},
          {"voltage", line("bus_voltage")},
          {"across", line("across_track")},
          {"water", {line("water_velocity", 0), line("water_velocity", 1)}},
          {"wind", {line("wind_velocity", 0), line("wind_velocity", 1)}}};
}

/// What the vehicles did, a row each: `[[from_s, to_s, phase, doing], ...]`.
json timeline_json(const twin::RunAccount& account) {
  json rows = json::array();
  for (const twin::VehicleAccount& vehicle : account.vehicles) {
    json row = json::array();
    for (const twin::MissionStretch& s : twin::stretches_of(vehicle.mission, account.ran_s))
      row.push_back({number(s.from_s), number(s.to_s), s.phase, s.doing});
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Of each vehicle: the bounds of its limits and the charge that it keeps in reserve (%).
json limits_json(const TrajectoryFile& log, const twin::Scenario* scenario) {
  json all = json::array();
  for (const std::string& name : log.names) {
    json limits = json::object();
    if (scenario != nullptr)
      for (const twin::ScenarioVehicle& vehicle : scenario->vehicles) {
        if (vehicle.name != name || !vehicle.conduct) continue;
        limits = limit_bounds_json(vehicle);
        limits["reserve"] = number(100 * vehicle.conduct->reserve.share);
      }
    all.push_back(std::move(limits));
  }
  return all;
}

/// What of the scenario a map shows: where each vehicle was to go, tops of tethers, structures.
/// East and north of the origin.
json plan_json(const TrajectoryFile& log, const twin::Scenario& scenario) {
  json plans = json::array();
  for (const std::string& name : log.names) {
    json plan = {{"x", json::array()}, {"y", json::array()}, {"tether", nullptr}};
    for (const twin::ScenarioVehicle& vehicle : scenario.vehicles) {
      if (vehicle.name != name) continue;
      const auto add = [&](const twin::Triple<double>& place_m) {
        plan["x"].push_back(number(place_m.y));
        plan["y"].push_back(number(place_m.x));
      };
      if (!vehicle.starts_on_track) add(vehicle.start_m);
      for (const twin::ScenarioTask& task : vehicle.tasks)
        for (const twin::Waypoint& waypoint : task.waypoints) add(waypoint.position_m);
      if (vehicle.tether && vehicle.tether->top_m)
        plan["tether"] = {number(vehicle.tether->top_m->y), number(vehicle.tether->top_m->x)};
    }
    plans.push_back(std::move(plan));
  }
  return plans;
}

json run_structures_json(const twin::Scenario& scenario) {
  json structures = json::array();
  for (const twin::ScenarioStructure& s : scenario.structures) {
    const bool is_round = s.kind == twin::ScenarioStructure::Kind::cylinder;
    structures.push_back({{"name", s.name},
                          {"x", number(s.centre_m.y)},
                          {"y", number(s.centre_m.x)},
                          {"round", is_round},
                          {"width", number(is_round ? s.diameter_m : s.size_m.y)},
                          {"length", number(is_round ? s.diameter_m : s.size_m.x)}});
  }
  return structures;
}

std::string outcome_html(const twin::RunAccount& account, bool has_scenario) {
  std::string html = "<section class=\"outcome\"><h2>How it came out</h2><div class=\"cards\">";
  for (const twin::VehicleAccount& vehicle : account.vehicles) {
    const bool is_stopped = vehicle.halt != twin::Halt::none;
    html += std::string("<div class=\"card") + (is_stopped ? " stopped" : "") + "\"><h3>" +
            escaped_html(vehicle.name) + "</h3><p><strong>" +
            escaped_html(verdict_text(vehicle, account.start)) + "</strong></p><dl>";
    for (const auto& [what, how_much] : margins_of(vehicle, account.start))
      html += "<dt>" + escaped_html(what) + "</dt><dd>" + escaped_html(how_much) + "</dd>";
    html += "</dl></div>";
  }
  html += "</div><p class=\"note\">Extremes of the logged times";
  return html + (has_scenario ? ".</p></section>\n"
                              : "; the log holds no scenario that this version reads, so no plan "
                                "and no structures are shown.</p></section>\n");
}

std::string events_html(const twin::RunAccount& account, const std::vector<EventLine>& events) {
  if (events.empty()) return {};
  ReportTable table;
  table.title = "Events";
  table.columns = {"UTC", "Vehicle", "What"};
  for (const EventLine& event : events) {
    const auto whole = Duration(static_cast<Duration::rep>(std::floor(event.t_s)) * 1000);
    table.rows.push_back(
        {format_utc(account.start + whole), account.vehicles[event.vehicle].name, event.what});
  }
  return table_html(table);
}

json events_json(const std::vector<EventLine>& events) {
  json list = json::array();
  for (const EventLine& event : events)
    list.push_back({{"t", number(event.t_s)}, {"vehicle", event.vehicle}, {"what", event.what}});
  return list;
}

std::string cell(double value) {
  return std::isfinite(value) ? formatted("{:.2f}", value) : std::string("-");
}

std::string fate_html(const twin::RunAccount& account) {
  ReportTable table;
  table.title = "How each fared";
  table.note =
      "Off the track and off the depth until it halted; largest roll and pitch over all steps.";
  table.columns = {"Vehicle",           "What befell it",    "Sailed m",        "Energy Wh",
                   "Fuel kg",           "Off track m rms",   "Off depth m rms", "Off depth m most",
                   "Roll deg, largest", "Pitch deg, largest"};
  for (const twin::VehicleAccount& v : account.vehicles) {
    const std::string befell = v.fate_text(account.start);
    table.rows.push_back({v.name, befell.empty() ? "-" : befell, cell(v.track.sailed_m),
                          v.makeup.is_electric ? cell(v.in_all.drawn_j / 3600) : "-",
                          v.makeup.burns_fuel ? cell(v.in_all.fuel_kg) : "-",
                          cell(v.track.rms_across_m),
                          v.makeup.floats ? "-" : cell(v.track.rms_depth_error_m),
                          v.makeup.floats ? "-" : cell(magnitude_of(v.track.depth_error_m)),
                          cell(v.largest_roll_rad / constants::degree),
                          cell(v.largest_pitch_rad / constants::degree)});
  }
  return table_html(table);
}

std::string choice_html() {
  return "<p class=\"control\"><label for=\"vehicle\">Vehicle</label> <select "
         "id=\"vehicle\"></select></p>";
}

std::string run_plots(bool has_missions) {
  return (has_missions
              ? plot_html("missions", "What they did",
                          "A row a vehicle. Thin: on its way; full: at work; hollow: holding; "
                          "half as high: coming home. Marks: its events.")
              : std::string()) +
         plot_html(
             "tracks", "Tracks from above",
             "East and north of the origin (m), a metre as long one way as the other. Solid: the "
             "way taken, the ring is its start; dashed: the way planned; triangle: the top of a "
             "tether; grey shapes: structures; thin grey lines: other vessels.") +
         choice_html() +
         plot_html("charge", "Charge left",
                   "Of the battery (%); level line: what its mission keeps in reserve.") +
         plot_html(
             "felt", "Water and wind felt",
             "Speed of the water, current and waves, and of the wind at the vehicle (m/s). "
             "Level lines: its limits, which look at the forecast, without waves and gusts.") +
         "<details><summary>Signals: depth, attitude, thrust, power</summary>" +
         plot_html(
             "height", "Height and distance from the track",
             "Height above mean sea level (m, negative below) and distance from the leg under "
             "way (m, positive right of it).") +
         plot_html("attitude", "Attitude", "Roll to starboard, pitch bow up, heading (degrees).") +
         plot_html("thrust", "Thrust", "Of each thruster (N).") +
         plot_html("power", "Power and battery",
                   "Power drawn (W), state of charge (%) and voltage of the bus (V).") +
         "</details>\n";
}

/// What befell vehicles first, then how their missions ended.
void say_verdict(const twin::RunAccount& account, HtmlPage& page) {
  page.headline = fates_text(account);
  if (!page.headline.empty()) page.alarm = "Not a normal run.";
  if (!all_missions_done(account) && page.alarm.empty()) page.alarm = "Held or called home.";
  if (!all_seen(account) && page.alarm.empty()) page.alarm = "Done, and not seen.";
  const std::string missions = mission_headline(account);
  if (!page.headline.empty() && !missions.empty()) page.headline += ". ";
  page.headline += missions;
}

bool has_missions(const twin::RunAccount& account) {
  return std::any_of(account.vehicles.begin(), account.vehicles.end(),
                     [](const auto& vehicle) { return !vehicle.mission.empty(); });
}

}  // namespace

std::string run_page_html(const TrajectoryFile& log, std::string_view plotting_library,
                          const RunPageChoice& choice) {
  if (log.t_s.empty() || log.names.empty()) {
    throw Error(ErrorKind::invalid_input,
                "the log holds no vehicle or no time; give one that `slackwater simulate` wrote");
  }
  Rows rows;
  rows.times = log.t_s.size();
  rows.every = std::max<std::size_t>(1, rows.times / most_points);
  json seconds = json::array();
  for (const std::size_t t : rows.drawn()) seconds.push_back(number(log.t_s[t]));
  json vehicles = json::array();
  for (std::size_t i = 0; i < log.names.size(); ++i) vehicles.push_back(vehicle_json(log, rows, i));
  const std::optional<twin::Scenario> read = scenario_of(log);
  const twin::Scenario* scenario = read ? &*read : nullptr;
  const twin::RunAccount account = account_in(log, scenario);
  const std::vector<EventLine> events = event_lines(log, account);
  const std::vector<InspectionCoverage> coverages = coverage_in(log);
  const std::string seen = coverage_html(coverages, choice.shows_truth);
  HtmlPage page;
  page.title = log.attribute("title");
  page.site = log.attribute("forecast");
  page.facts = {{"start (UTC)", format_utc(log.epoch)},
                {"length", std::to_string(static_cast<long>(log.t_s.back())) + " s"},
                {"vehicles", log.attribute("vehicles")},
                {"origin", log.attribute("origin")},
                {"seed", log.attribute("seed")},
                {"member", log.attribute("member")}};
  say_verdict(account, page);
  const std::string outcome = outcome_html(account, scenario != nullptr);
  page.plots_html =
      outcome + seen + coverage_plots_html(coverages) + run_plots(has_missions(account));
  page.instead_of_plots_html = outcome + seen;
  page.tables_html = coverage_tables_html(coverages, log.epoch, choice.shows_truth) +
                     detections_html(detections_in(log), log.names, choice.shows_truth) +
                     events_html(account, events) + fate_html(account) + traffic_html(log);
  page.data_json = script_safe(
      {{"t", seconds},
       {"epoch", std::chrono::duration_cast<std::chrono::milliseconds>(log.epoch.time_since_epoch())
                     .count()},
       {"vehicles", vehicles},
       {"plan", scenario == nullptr ? json::array() : plan_json(log, *scenario)},
       {"structures", scenario == nullptr ? json::array() : run_structures_json(*scenario)},
       {"events", events_json(events)},
       {"timeline", timeline_json(account)},
       {"limits", limits_json(log, scenario)},
       {"coverage", coverage_json(coverages)},
       {"vessels", vessels_json(log)}});
  if (!log.attribute("attribution").empty()) page.attributions = {log.attribute("attribution")};
  page.generated = log.attribute("source");
  page.script = run_script();
  return page_html(page, plotting_library);
}

void write_run_page(const TrajectoryFile& log, const std::filesystem::path& file,
                    const RunPageChoice& choice) {
  write_page(run_page_html(log, report_plotting_library(), choice), file);
}

}  // namespace slackwater::api
