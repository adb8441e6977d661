#include "api/show/rehearse/rehearsal_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "api/ask/rehearse/risks.h"
#include "api/ask/rehearse/unchecked.h"
#include "api/json/plot_json.h"
#include "api/program/version.h"
#include "api/show/rehearse/advice_report.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/coverage_over_flights.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/limit_bounds.h"
#include "api/show/rehearse/rehearsal_json.h"
#include "api/show/rehearse/risk_report.h"
#include "api/show/rehearse/run_page_traffic.h"
#include "api/show/report/assets.h"
#include "api/show/report/html_page.h"
#include "fields/base/numbers/quantile.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::Flight;
using twin::FlightSample;

constexpr std::size_t most_tracks = 12;

/// P10, P50 and P90 over the flights, a sample after the other. @param of  of a sample
template <typename Of>
json bands_json(const StartOutcome& start, std::size_t vehicle, std::size_t times, Of&& of) {
  json bands = {{"p10", json::array()}, {"p50", json::array()}, {"p90", json::array()}};
  for (std::size_t t = 0; t < times; ++t) {
    std::vector<double> values;
    for (const Flight& flight : start.flights) {
      const auto& samples = flight.samples[vehicle];
      if (t < samples.size()) values.push_back(of(samples[t]));
    }
    for (const auto& [name, share] : {std::pair{"p10", 0.1}, {"p50", 0.5}, {"p90", 0.9}}) {
      const auto value = quantile_of(values, share);
      bands[name].push_back(value ? number(*value) : json(nullptr));
    }
  }
  return bands;
}

/// What one vehicle does in a flight, stretch by stretch: [from, to, phase, doing] in samples.
json stretches_json(const std::vector<FlightSample>& samples) {
  json out = json::array();
  for (std::size_t from = 0; from < samples.size();) {
    std::size_t to = from + 1;
    while (to < samples.size() && samples[to].phase == samples[from].phase &&
           samples[to].doing == samples[from].doing)
      ++to;
    out.push_back({from, to, samples[from].phase, samples[from].doing});
    from = to;
  }
  return out;
}

json tracks_json(const StartOutcome& start, std::size_t vehicle) {
  json tracks = json::array();
  const std::size_t every = std::max<std::size_t>(1, start.flights.size() / most_tracks);
  for (std::size_t f = 0; f < start.flights.size(); f += every) {
    json x = json::array(), y = json::array();
    for (const FlightSample& sample : start.flights[f].samples[vehicle]) {
      x.push_back(number(sample.east_m));
      y.push_back(number(sample.north_m));
    }
    tracks.push_back({{"x", x}, {"y", y}, {"done", start.flights[f].is_done}});
  }
  return tracks;
}

/// Where the top of its line is, east and north of the origin; null: it has none.
json tether_json(const twin::ScenarioVehicle& vehicle) {
  if (!vehicle.tether || !vehicle.tether->top_m) return nullptr;
  return {number(vehicle.tether->top_m->y), number(vehicle.tether->top_m->x)};
}

json vehicle_json(const StartOutcome& start, std::size_t v, const twin::Scenario& scenario) {
  std::size_t times = 0;
  for (const Flight& flight : start.flights) times = std::max(times, flight.samples[v].size());
  const auto band = [&](auto&& of) { return bands_json(start, v, times, of); };
  json flights = json::array();
  for (const Flight& flight : start.flights)
    flights.push_back({{"member", flight.flown.member},
                       {"done", flight.vehicles[v].is_done},
                       {"stopped_by", flight.vehicles[v].stopped_by},
                       {"stretches", stretches_json(flight.samples[v])}});
  return {{"name", start.flights.front().vehicles[v].name},
          {"times", times},
          {"tracks", tracks_json(start, v)},
          {"flights", flights},
          {"tether", tether_json(scenario.vehicles[v])},
          {"bounds", limit_bounds_json(scenario.vehicles[v])},
          {"covered", covered_against_flow_json(start, v)},
          {"charge", band([](const FlightSample& s) { return 100.0 * double{s.charge}; })},
          {"needed", band([](const FlightSample& s) { return 100.0 * double{s.needed}; })},
          {"current", band([](const FlightSample& s) { return double{s.current_m_s}; })},
          {"wind", band([](const FlightSample& s) { return double{s.wind_m_s}; })},
          {"waves", band([](const FlightSample& s) { return double{s.wave_height_m}; })}};
}

json start_json(const StartOutcome& start, const twin::Scenario& scenario) {
  json vehicles = json::array();
  for (std::size_t v = 0; v < start.flights.front().vehicles.size(); ++v)
    vehicles.push_back(vehicle_json(start, v, scenario));
  return {{"label", format_utc(start.start).substr(0, 16) + "Z"},
          {"epoch",
           std::chrono::duration_cast<std::chrono::milliseconds>(start.start.time_since_epoch())
               .count()},
          {"verdict", verdict_of(start)},
          {"vehicles", vehicles}};
}

json structures_json(const twin::Scenario& scenario) {
  json structures = json::array();
  for (const twin::ScenarioStructure& s : scenario.structures)
    structures.push_back({{"name", s.name},
                          {"x", number(s.centre_m.y)},
                          {"y", number(s.centre_m.x)},
                          {"width", number(s.diameter_m)}});
  return structures;
}

std::string share_cell(const FlightCount& count) {
  return formatted("{} of {}", count.flights, count.of);
}
std::string bounds_cell(const FlightCount& count) {
  return formatted("{:.0f} to {:.0f} %", 100 * count.low, 100 * count.high);
}

std::string cause_cell(const StartOutcome& start, const std::string& causes) {
  if (!start.forbidden.empty()) return start.forbidden;
  return causes.empty() ? "-" : causes;
}

std::string starts_html(const Rehearsal& rehearsal) {
  ReportTable table;
  table.title = "Starts";
  table.note =
      "Done: the work was done in time, and all came home. Seen: the inspection covered what is "
      "asked of it; a flight that is done may have seen nothing. P: bounds that hold at 95 % "
      "however many futures were flown. Limits: what they say of the central forecast alone, as a "
      "planner reads them.";
  table.columns = {"Start (UTC)", "Done",    "P(done)",    "Seen",
                   "P(seen)",     "Why not", "Left (P10)", "Limits"};
  std::size_t row = 0;
  double best = -1;
  for (const StartOutcome& start : rehearsal.starts) {
    std::string causes;
    for (const StoppedBy& cause : start.stopped_by)
      causes += (causes.empty() ? "" : "; ") + cause.cause + formatted(" ({})", cause.flights);
    for (const StoppedBy& cause : start.unseen_by)
      causes += (causes.empty() ? "not seen: " : "; not seen: ") + cause.cause +
                formatted(" ({})", cause.flights);
    std::vector<double> left;
    for (const Flight& flight : start.flights)
      for (const twin::VehicleAccount& vehicle : flight.vehicles)
        if (vehicle.on_mission.drawn_j > 0) left.push_back(100 * vehicle.least_charge);
    const auto least = quantile_of(left, 0.1);
    const twin::LimitsSay& limits = start.by_the_limits;
    table.rows.push_back({format_utc(start.start).substr(0, 16), share_cell(start.done),
                          bounds_cell(start.done), start.seen ? share_cell(*start.seen) : "-",
                          start.seen ? bounds_cell(*start.seen) : "-", cause_cell(start, causes),
                          least ? formatted("{:.0f} %", *least) : "-",
                          (limits.allows ? "allow" : "forbid") +
                              (limits.binding.empty() ? std::string() : ": " + limits.binding)});
    if (start.success.share() > best) {
      best = start.success.share();
      table.highlighted_row = row;
    }
    ++row;
  }
  return table_html(table);
}

std::string risks_html(const LoadedMission& mission, const StartOutcome& start) {
  return risk_table_html("Risks of a start at " + format_utc(start.start).substr(0, 16) + "Z",
                         risks_of(start, mission.consequences));
}

std::string words_html(const Rehearsal& rehearsal, const Unchecked& unchecked) {
  std::string html;
  const auto say = [&](const std::string& text) { html += "<p>" + escaped_html(text) + "</p>"; };
  for (const StartOutcome& start : rehearsal.starts)
    if (const std::string why = disagreement_of(start); !why.empty())
      say(format_utc(start.start).substr(0, 16) + "Z: " + why);
  for (const StartOutcome& start : rehearsal.starts)
    for (const std::string& cleaned : cleaning_texts(start))
      say(format_utc(start.start).substr(0, 16) + "Z: " + cleaned + ".");
  for (const StartOutcome& start : rehearsal.starts)
    for (const std::string& seen : inspection_texts(start))
      say(format_utc(start.start).substr(0, 16) + "Z: " + seen + ".");
  for (const std::string& limit : unchecked.not_checked) say("Not checked: " + limit + ".");
  for (const std::string& value : unchecked.assumed) say("Assumed, not forecast: " + value + ".");
  return html.empty() ? html : "<section class=\"words\">" + html + "</section>\n";
}

std::string choice_html(const char* id, const char* label) {
  return std::string("<label for=\"") + id + "\">" + label + "</label> <select id=\"" + id +
         "\"></select> ";
}

std::string plots(bool is_inspected) {
  const std::string covered =
      is_inspected
          ? plot_html("covered", "Covered against current or wind",
                      "A point a future: the mean current felt at work (m/s), or the wind by what "
                      "works in the air, and the share of all surfaces that was covered (%). "
                      "Triangles: futures in which its work never began, at the left edge.")
          : "";
  return "<p class=\"control\">" + choice_html("start", "Start") +
         choice_html("vehicle", "Vehicle") + "</p><p id=\"start-verdict\"></p>" +
         plot_html("timeline", "What it does, future by future",
                   "A row a future of the forecast. Thin: on its way; full: at work; hollow: "
                   "holding; half as high: called home. Those not done stand at the top, with the "
                   "cause.") +
         plot_html("plan", "Plan",
                   "East and north of the origin (m). Solid: ways of futures that were done; "
                   "dotted: of others; circles: foundations; triangle: the top of a tether, thin "
                   "dashed: from there to where its vehicle came farthest; thin grey: other "
                   "vessels.") +
         plot_html("reserve", "Charge left, and what the way home takes",
                   "State of charge (%), P10 to P90 over the futures, and the charge at which it "
                   "has to turn for home: way home, its margin and the reserve.") +
         covered +
         plot_html("current", "Current felt",
                   "At the vehicle (m/s), P10 to P90; level line: its limit.") +
         plot_html("wind", "Wind felt",
                   "Mean, at the vehicle (m/s), P10 to P90; level line: its limit.") +
         plot_html("waves", "Waves",
                   "Significant wave height (m), P10 to P90; level line: its limit.");
}

std::string futures_text(const LoadedMission& mission, const RehearsalPlan& plan) {
  const std::size_t issued = mission.water.members_issued;
  std::string text = std::to_string(plan.members);
  if (issued > 0 && plan.members > issued)
    text += formatted(", {} issued and {} drawn since by its calibration", issued,
                      plan.members - issued);
  return text;
}

/// Of the starts that were flown, with the place of the one to look at first among them.
json starts_json(const LoadedMission& mission, const Rehearsal& rehearsal, std::size_t best,
                 std::size_t& best_flown) {
  json starts = json::array();
  for (std::size_t i = 0; i < rehearsal.starts.size(); ++i) {
    const StartOutcome& start = rehearsal.starts[i];
    if (start.flights.empty()) continue;
    if (i == best) best_flown = starts.size();
    starts.push_back(start_json(start, mission.scenario));
  }
  return starts;
}

}  // namespace

std::string rehearsal_page_html(const LoadedMission& mission, const RehearsalPlan& plan,
                                const Rehearsal& rehearsal, const std::vector<Advice>& advice,
                                std::string_view plotting_library) {
  HtmlPage page;
  page.title = mission.name;
  page.site = joined(mission.expanded.tasks, ", ") + " at " +
              joined(mission.expanded.turbines, ", ") + ", " + mission.site;
  page.headline = verdict_of(rehearsal);
  const std::size_t best = rehearsal.best();
  if (rehearsal.starts[best].success.share() < 0.5) page.alarm = "No-go.";
  const Unchecked unchecked = unchecked_of(mission.scenario);
  page.facts = {{"forecast", mission.water.forecast_name},
                {"futures", futures_text(mission, plan)},
                {"vehicles", joined(mission.expanded.workers, ", ")},
                {"seed", std::to_string(mission.scenario.seed)}};
  page.first_html = words_html(rehearsal, unchecked);
  const std::string tables = starts_html(rehearsal) + risks_html(mission, rehearsal.starts[best]) +
                             advice_table_html("What would change the answer", advice);
  const std::string pictures =
      rehearsed_coverage_html(rehearsal.starts[best], rehearsal.inspections);
  page.plots_html = tables + pictures + plots(!pictures.empty());
  page.instead_of_plots_html = tables + pictures;
  std::size_t best_flown = 0;
  const json starts = starts_json(mission, rehearsal, best, best_flown);
  page.data_json = script_safe(
      {{"starts", starts},
       {"best", best_flown},
       {"every_s", plan.flights.sample_every_s},
       {"structures", structures_json(mission.scenario)},
       {"vessels", vessels_json(mission.water.surround.vessels, mission.scenario.duration_s)}});
  page.attributions = mission.water.surround.field->snapshot().attributions;
  page.generated = "slackwater " + code_version();
  page.script = rehearsal_script();
  return page_html(page, plotting_library);
}

void write_rehearsal_page(const LoadedMission& mission, const RehearsalPlan& plan,
                          const Rehearsal& rehearsal, const std::vector<Advice>& advice,
                          const std::filesystem::path& file) {
  write_page(rehearsal_page_html(mission, plan, rehearsal, advice, report_plotting_library()),
             file);
}

}  // namespace slackwater::api
