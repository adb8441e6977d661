#include "api/show/rehearse/account_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "api/log/account_log.h"
#include "api/log/account_tables.h"
#include "api/show/rehearse/cleaning_report.h"
#include "api/show/rehearse/inspection_report.h"
#include "api/show/rehearse/manoeuvre_report.h"
#include "api/show/rehearse/run_clock.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using twin::RunAccount;
using twin::VehicleAccount;
using Margins = std::vector<std::pair<std::string, std::string>>;

void add_energy(const VehicleAccount& vehicle, Margins& margins) {
  const bool gave = vehicle.makeup.has_battery && vehicle.in_all.drawn_j > 0;
  if (gave)
    margins.emplace_back("Battery left", formatted("{:.1f} %", 100 * vehicle.in_all.charge));
  if (vehicle.in_all.drawn_j > 0)
    margins.emplace_back("Energy used", formatted("{:.1f} Wh", vehicle.in_all.drawn_j / 3600));
  if (gave && vehicle.track.least_voltage_v)
    margins.emplace_back("Least voltage", formatted("{:.1f} V", *vehicle.track.least_voltage_v));
  if (vehicle.in_all.fuel_kg > 0)
    margins.emplace_back("Fuel burnt", formatted("{:.2f} kg", vehicle.in_all.fuel_kg));
}

void add_closest(const twin::Closest& closest, UtcTime start, Margins& margins) {
  const auto add = [&](const char* what, const std::optional<twin::Approach>& near) {
    if (near)
      margins.emplace_back(
          what, formatted("{:.1f} m, {} at {} UTC", std::max(0.0, near->distance_m), name_of(*near),
                          time_of_day(start, near->t_s)));
  };
  add("Closest to a structure", closest.structure);
  add("Closest to another vehicle", closest.vehicle);
  add("Closest to a vessel", closest.vessel);
  add("Closest to another's tether", closest.tether);
}

void add_largest(const twin::TrackAccount& track, UtcTime start, Margins& margins) {
  const auto add = [&](const char* what, const std::optional<twin::Extreme>& largest, double scale,
                       const char* unit) {
    if (!largest || largest->value == 0) return;
    const double size = scale * std::abs(largest->value);
    margins.emplace_back(what, (size < 10 ? formatted("{:.2f}", size) : formatted("{:.0f}", size)) +
                                   unit + " at " + time_of_day(start, largest->t_s) + " UTC");
  };
  add("Farthest off the track", track.across_m, 1, " m");
  add("Farthest off the depth", track.depth_error_m, 1, " m");
  add("Largest roll", track.roll_rad, 1 / constants::degree, "°");
  add("Largest pitch", track.pitch_rad, 1 / constants::degree, "°");
  add("Largest pull of the tether", track.tether_n, 1, " N");
}

std::string tasks_text(const VehicleAccount& vehicle) {
  return formatted("{} of {} {} done", std::min(vehicle.tasks_done, vehicle.tasks), vehicle.tasks,
                   vehicle.tasks == 1 ? "task" : "tasks");
}

/// Rows at which a counted quantity changes; what has just joined had 0.
template <typename Tell>
void on_change(const twin::VehicleRows& rows, const char* name, const Tell& tell) {
  double before = 0;
  const std::span<const double> values = rows.column(name);
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (!std::isfinite(values[t])) continue;
    if (values[t] != before) tell(rows.t_s[t], static_cast<std::size_t>(values[t]));
    before = values[t];
  }
}

/// When it joined the run: its first row with a place, where that is not the first of all.
std::optional<double> joined_s(const twin::VehicleRows& rows) {
  const std::span<const double> x = rows.column("x");
  const auto there = std::find_if(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  if (there == x.begin() || there == x.end()) return std::nullopt;
  return rows.t_s[static_cast<std::size_t>(there - x.begin())];
}

void add_alarms(const TrajectoryFile& log, std::vector<EventLine>& events) {
  const ingest::TrajectoryTable* alarms = log.find_table("alarm");
  if (alarms == nullptr) return;
  const std::vector<double>* vehicle = alarms->column("vehicle");
  const std::vector<double>* begin = alarms->column("begin");
  const std::vector<std::string>* name = alarms->text("name");
  if (vehicle == nullptr || begin == nullptr) return;
  for (std::size_t i = 0; i < alarms->rows(); ++i) {
    const double index = (*vehicle)[i];
    if (!(index >= 0 && index < static_cast<double>(log.names.size()))) continue;
    const std::string who = name != nullptr && i < name->size() ? (*name)[i] : "";
    events.push_back(
        {(*begin)[i], static_cast<std::size_t>(index), "alarm" + (who.empty() ? "" : ": " + who)});
  }
}

bool is_of_battery(twin::Fate fate) {
  return fate == twin::Fate::battery_empty || fate == twin::Fate::battery_cut_off;
}

}  // namespace

std::string name_of(const twin::Approach& approach) {
  return approach.to.empty() ? std::to_string(approach.mmsi) : approach.to;
}

std::string alarms_text(const twin::ClearanceAccount& clearance) {
  if (!(clearance.alarms() > 0)) return "none";
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < twin::alarm_causes; ++c)
    if (clearance.alarms_from[c] > 0)
      parts.push_back(words_of(static_cast<twin::AlarmCause>(c)) +
                      formatted(" {:.0f}", clearance.alarms_from[c]));
  return formatted("{:.0f} ({})", clearance.alarms(), joined(parts, ", "));
}

std::string verdict_text(const VehicleAccount& vehicle, UtcTime start) {
  std::string text = vehicle.fate.empty() ? "ran to the end" : vehicle.fate_text(start);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  if (vehicle.tasks > 0) text += "; " + tasks_text(vehicle);
  return text + ".";
}

Margins margins_of(const VehicleAccount& vehicle, UtcTime start) {
  Margins margins;
  add_energy(vehicle, margins);
  if (vehicle.cleaning) margins.emplace_back("Cleaned", cleaned_text(*vehicle.cleaning));
  if (vehicle.inspection) margins.emplace_back("Inspected", covered_text(*vehicle.inspection));
  for (const twin::ManoeuvreAccount& one : vehicle.manoeuvres)
    margins.emplace_back(manoeuvre_name(one), manoeuvre_text(one));
  add_closest(vehicle.closest, start, margins);
  if (vehicle.clearance) margins.emplace_back("Clearance alarms", alarms_text(*vehicle.clearance));
  add_largest(vehicle.track, start, margins);
  return margins;
}

std::string fates_text(const RunAccount& account) {
  std::vector<std::string> texts;
  for (const VehicleAccount& vehicle : account.vehicles)
    if (!vehicle.fate.empty())
      texts.push_back(vehicle.name + ": " + vehicle.fate_text(account.start));
  return joined(texts, "; ");
}

bool all_missions_done(const RunAccount& account) {
  return std::all_of(account.vehicles.begin(), account.vehicles.end(), [&](const auto& vehicle) {
    const auto end = twin::mission_end_of(vehicle.mission, account.ran_s);
    return !end || end->is_done;
  });
}

bool all_seen(const RunAccount& account) {
  return std::none_of(account.vehicles.begin(), account.vehicles.end(),
                      [](const auto& vehicle) { return vehicle.is_seen() == false; });
}

std::string mission_headline(const RunAccount& account) {
  std::vector<std::string> done, not_done, seen, unseen;
  for (const VehicleAccount& vehicle : account.vehicles) {
    if (const std::optional<bool> is_seen = vehicle.is_seen())
      (*is_seen ? seen : unseen)
          .push_back(vehicle.name + (*is_seen ? "" : ": " + vehicle.inspection->left));
    const auto end = twin::mission_end_of(vehicle.mission, account.ran_s);
    // That it is still out says not why.
    const bool is_told =
        !vehicle.fate.empty() && vehicle.fate.front().what != twin::Fate::not_recovered;
    if (!end || (!end->is_done && is_told)) continue;
    const std::string when = minute_of_day(account.start, end->t_s) + " UTC";
    if (end->is_done)
      done.push_back(vehicle.name + " by " + when);
    else
      not_done.push_back(vehicle.name + ": " + end->why + " (ended " + when + ")");
  }
  std::vector<std::string> text;
  if (!not_done.empty()) text.push_back("Not done: " + joined(not_done, "; ") + ".");
  if (!done.empty()) text.push_back("Done: " + joined(done, ", ") + ".");
  // Done is not seen.
  if (!unseen.empty()) text.push_back("Not seen: " + joined(unseen, "; ") + ".");
  if (!seen.empty()) text.push_back("Seen as asked: " + joined(seen, ", ") + ".");
  return joined(text, " ");
}

std::vector<EventLine> event_lines(const TrajectoryFile& log, const RunAccount& account) {
  std::vector<EventLine> events;
  for (std::size_t i = 0; i < account.vehicles.size(); ++i) {
    const VehicleAccount& vehicle = account.vehicles[i];
    const twin::VehicleRows rows = rows_of(log, i);
    for (const twin::MissionEvent& event : vehicle.mission)
      events.push_back({event.t_s, i, event.text});
    // Its phases say more than the numbers of its tasks.
    if (vehicle.mission.empty())
      on_change(rows, "task", [&](double t_s, std::size_t task) {
        const bool is_last = vehicle.tasks > 0 && task >= vehicle.tasks;
        events.push_back(
            {t_s, i, is_last ? "all tasks done" : formatted("task {} begins", task + 1)});
      });
    if (const auto t_s = joined_s(rows)) events.push_back({*t_s, i, "joins the run"});
    on_change(rows, "battery_off", [&](double t_s, std::size_t off) {
      events.push_back({t_s, i, off != 0 ? "battery cut off" : "battery on again"});
    });
    for (const twin::FateEvent& event : vehicle.fate)
      if (event.at_s && !is_of_battery(event.what))
        events.push_back({*event.at_s, i, words_of(event.what)});
  }
  add_alarms(log, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const EventLine& a, const EventLine& b) { return a.t_s < b.t_s; });
  return events;
}

}  // namespace slackwater::api
