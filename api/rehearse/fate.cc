#include "api/rehearse/fate.h"

#include <algorithm>
#include <cmath>

#include "api/rehearse/scenario_run.h"
#include "api/report/html_page.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using twin::Halt;
using twin::Milestones;

constexpr double radian_deg = 57.29577951308232;

std::string halt_text(const twin::Agent& agent, const twin::AgentState& state) {
  const bool flies = agent.vehicle->kind == twin::VehicleKind::uav;
  switch (state.halt) {
    case Halt::none:
      return "";
    case Halt::diverged:
      return "diverged";
    case Halt::outside_area:
      return "left the area of the forecast";
    case Halt::outside_time:
      return "left the time of the forecast";
    case Halt::aground:
      return "ran aground";
    case Halt::no_data:
      return "met no data of the forecast";
    case Halt::struck:
      return flies && state.vehicle.body.position_m.z > 0 ? "struck the sea" : "struck a structure";
    case Halt::capsized:
      return "capsized";
    case Halt::no_headway:
      return flies ? "made no headway against the wind" : "made no headway against the water";
  }
  return "stopped";
}

std::string cell(double value) {
  return std::isfinite(value) ? formatted("{:.2f}", value) : std::string("-");
}

}  // namespace

std::vector<FateEvent> fate_of(const twin::Agent& agent, const twin::AgentState& state) {
  const Milestones& m = state.milestones;
  const bool flies = agent.vehicle->kind == twin::VehicleKind::uav;
  const bool lost_power = !std::isnan(m.power_lost_s);
  std::vector<FateEvent> events;
  if (lost_power)
    events.push_back({m.is_empty > 0 ? "battery empty" : "battery cut off at its least voltage",
                      m.power_lost_s});
  if (!std::isnan(m.line_parted_s)) events.push_back({"its tether parted", m.line_parted_s});
  // One that falls tumbles, which is told by its falling; of one that floats its halt tells.
  const bool fell_first = flies && lost_power && m.capsized_s >= m.power_lost_s;
  if (!std::isnan(m.capsized_s) && state.halt != Halt::capsized && !fell_first)
    events.push_back({"turned over", m.capsized_s});
  std::stable_sort(events.begin(), events.end(),
                   [](const FateEvent& a, const FateEvent& b) { return a.at_s < b.at_s; });
  if (flies && !events.empty() && (lost_power || state.halt == Halt::struck))
    events.push_back({"fell", Milestones::never});
  if (const std::string what = halt_text(agent, state); !what.empty())
    events.push_back({what, state.halted_at_s});
  return events;
}

std::string fate_text(const std::vector<FateEvent>& events, UtcTime start) {
  std::string text;
  for (const FateEvent& event : events) {
    text += (text.empty() ? "" : " \u2192 ") + event.what;
    if (std::isnan(event.at_s)) continue;
    const auto passed = Duration(static_cast<Duration::rep>(std::floor(event.at_s)) * 1000);
    constexpr std::size_t date = 11;  // 2025-06-01T
    text += " at " + format_utc(start + passed).substr(date);
  }
  return text;
}

TrackQuality track_quality(const twin::RunLog& log, std::size_t vehicle) {
  const auto x = log.column(vehicle, "x"), y = log.column(vehicle, "y"),
             z = log.column(vehicle, "z"), across = log.column(vehicle, "across_track"),
             below = log.column(vehicle, "below_track"), halt = log.column(vehicle, "halt");
  TrackQuality q;
  double across2 = 0, below2 = 0;
  std::size_t rows = 0;
  const std::size_t first = log.first_time(vehicle);
  for (std::size_t i = first; i < x.size(); ++i) {
    across2 += across[i] * across[i];
    below2 += below[i] * below[i];
    q.largest_depth_error_m = std::max(q.largest_depth_error_m, std::abs(below[i]));
    if (i > first) q.sailed_m += std::hypot(x[i] - x[i - 1], y[i] - y[i - 1], z[i] - z[i - 1]);
    ++rows;
    if (halt[i] != 0) break;
  }
  if (rows == 0) return q;
  q.rms_across_m = std::sqrt(across2 / static_cast<double>(rows));
  q.rms_depth_error_m = std::sqrt(below2 / static_cast<double>(rows));
  return q;
}

ingest::TrajectoryTable fate_table(const std::vector<VehicleSummary>& vehicles) {
  ingest::TrajectoryTable table;
  table.name = "fate";
  std::vector<double> sailed, energy, fuel, across, depth, deepest, roll, pitch;
  std::vector<std::string> texts;
  constexpr double none = Milestones::never;
  for (const VehicleSummary& s : vehicles) {
    sailed.push_back(s.sailed_m);
    energy.push_back(s.is_electric ? 3600 * s.energy_wh : none);
    fuel.push_back(s.burns_fuel ? s.fuel_kg : none);
    across.push_back(s.rms_across_track_m);
    depth.push_back(s.floats ? none : s.rms_depth_error_m);
    deepest.push_back(s.floats ? none : s.largest_depth_error_m);
    roll.push_back(s.largest_roll_deg / radian_deg);
    pitch.push_back(s.largest_pitch_deg / radian_deg);
    texts.push_back(s.fate.empty() ? "-" : s.fate);
  }
  table.columns = {{"sailed", "m", "over ground, until it halted", sailed},
                   {"electrical_energy", "J", "drawn in all", energy},
                   {"fuel_burnt", "kg", "in all", fuel},
                   {"rms_across_track", "m", "root mean square over the times of the log", across},
                   {"rms_depth_error", "m", "off the depth or height of its way, likewise", depth},
                   {"largest_depth_error", "m", "the largest of them", deepest},
                   {"largest_roll", "rad", "of its size, over all steps", roll},
                   {"largest_pitch", "rad", "of its size, over all steps", pitch}};
  table.texts = {{"events", "what befell it, causes first; - for a normal run", texts}};
  return table;
}

std::string fate_in(const ingest::TrajectoryFile& log, std::size_t vehicle) {
  const ingest::TrajectoryTable* fate = log.find_table("fate");
  const std::vector<std::string>* events = fate == nullptr ? nullptr : fate->text("events");
  if (events == nullptr || vehicle >= events->size() || (*events)[vehicle] == "-") return {};
  return (*events)[vehicle];
}

std::string fates_in(const ingest::TrajectoryFile& log) {
  std::string text;
  for (std::size_t i = 0; i < log.names.size(); ++i) {
    if (const std::string fate = fate_in(log, i); !fate.empty())
      text += (text.empty() ? "" : "; ") + log.names[i] + ": " + fate;
  }
  return text;
}

std::string fate_html(const ingest::TrajectoryFile& log) {
  const ingest::TrajectoryTable* fate = log.find_table("fate");
  if (fate == nullptr) return {};
  ReportTable table;
  table.title = "How each fared";
  table.note =
      "Off the track and off the depth until it halted; largest roll and pitch over all steps.";
  table.columns = {"Vehicle",           "What befell it",    "Sailed m",        "Energy Wh",
                   "Fuel kg",           "Off track m rms",   "Off depth m rms", "Off depth m most",
                   "Roll deg, largest", "Pitch deg, largest"};
  const std::vector<std::string>* events = fate->text("events");
  const auto at = [&](const char* name, std::size_t i) {
    const std::vector<double>* column = fate->column(name);
    return column == nullptr || i >= column->size() ? Milestones::never : (*column)[i];
  };
  for (std::size_t i = 0; i < fate->rows() && i < log.names.size(); ++i) {
    table.rows.push_back(
        {log.names[i], events != nullptr && i < events->size() ? (*events)[i] : "-",
         cell(at("sailed", i)), cell(at("electrical_energy", i) / 3600), cell(at("fuel_burnt", i)),
         cell(at("rms_across_track", i)), cell(at("rms_depth_error", i)),
         cell(at("largest_depth_error", i)), cell(radian_deg * at("largest_roll", i)),
         cell(radian_deg * at("largest_pitch", i))});
  }
  return table_html(table);
}

}  // namespace slackwater::api
