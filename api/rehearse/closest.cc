#include "api/rehearse/closest.h"

#include <array>
#include <cmath>
#include <numeric>

#include "api/rehearse/scenario_run.h"
#include "api/rehearse/traffic_tables.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;

/// Members of `Closest` by the words of the log.
struct Kind {
  const char* name;
  std::optional<Approach> Closest::*of;
};
constexpr std::array kinds{Kind{"vehicle", &Closest::vehicle},
                           Kind{"structure", &Closest::structure}, Kind{"vessel", &Closest::vessel},
                           Kind{"tether", &Closest::tether}};

/// The words of an alarm's cause, for people.
std::string words_of(twin::AlarmCause cause) {
  switch (cause) {
    case twin::AlarmCause::no_warning:
      return "vessel without warning";
    case twin::AlarmCause::crowded:
      return "too much around";
    default:
      return twin::name_of(cause);
  }
}

std::string column_of(twin::AlarmCause cause) {
  return std::string("from_") + twin::name_of(cause);
}

bool has_tables(const TrajectoryFile& log) {
  constexpr int first_format = 3;
  const std::string format = log.attribute("log_format");
  return !format.empty() && std::atoi(format.c_str()) >= first_format;
}

Closest tabled(const TrajectoryFile& log, std::size_t i) {
  Closest closest;
  const TrajectoryTable* table = log.find_table("approach");
  if (table == nullptr) return closest;
  const auto *vehicle = table->column("vehicle"), *distance = table->column("distance"),
             *time = table->column("time"), *mmsi = table->column("mmsi");
  const auto *kind = table->text("kind"), *to = table->text("to");
  if (vehicle == nullptr || distance == nullptr || time == nullptr || mmsi == nullptr ||
      kind == nullptr || to == nullptr)
    return closest;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    if ((*vehicle)[row] != static_cast<double>(i)) continue;
    const double id = (*mmsi)[row];
    for (const Kind& k : kinds)
      if ((*kind)[row] == k.name)
        closest.*k.of = Approach{(*distance)[row], (*time)[row], (*to)[row],
                                 id > 0 && id < 4e9 ? static_cast<std::uint32_t>(id) : 0U};
  }
  return closest;
}

/// In the plane, at the rows; the traffic where its track is known.
Approach nearest_vessel(const TrajectoryFile& log, const VehicleLog& vehicle,
                        std::span<const twin::TrafficVessel> vessels) {
  Approach nearest;
  for (const twin::TrafficVessel& vessel : vessels)
    for (std::size_t t = 0; t < vehicle.rows(); ++t) {
      const twin::TrackState there = vessel.track.at(log.t_s[t]);
      if (!there.is_known()) continue;
      const auto apart = vehicle.place_m(t) - there.position_m;
      const double distance_m = std::hypot(apart.x, apart.y);
      if (distance_m < nearest.distance_m)
        nearest = {distance_m, log.t_s[t], vessel.name, vessel.id};
    }
  return nearest;
}

std::optional<Approach> found(Approach approach) {
  return std::isfinite(approach.distance_m) ? std::optional(std::move(approach)) : std::nullopt;
}

}  // namespace

Closest closest_of(const twin::NearestPasses& nearest, std::span<const twin::Agent> agents,
                   const twin::Scenario& scenario, std::span<const twin::TrafficVessel> vessels) {
  const auto named = [](const twin::NearestPass& pass, const auto& name_of) {
    std::optional<Approach> approach;
    if (pass.is_any())
      approach =
          Approach{pass.distance_m, pass.t_s, name_of(static_cast<std::size_t>(pass.whom)), 0};
    return approach;
  };
  const auto of_vehicle = [&](std::size_t i) { return agents[i].name; };
  Closest closest;
  closest.vehicle = named(nearest.vehicle, of_vehicle);
  closest.tether = named(nearest.line, of_vehicle);
  closest.structure =
      named(nearest.structure, [&](std::size_t i) { return scenario.structures.at(i).name; });
  closest.vessel = named(nearest.vessel, [&](std::size_t mmsi) {
    return name_of_vessel(vessels, static_cast<std::uint32_t>(mmsi));
  });
  if (closest.vessel) closest.vessel->mmsi = static_cast<std::uint32_t>(nearest.vessel.whom);
  return closest;
}

TrajectoryTable approach_table(std::span<const VehicleSummary> vehicles) {
  TrajectoryTable table;
  table.name = "approach";
  std::vector<double> vehicle, distance, time, mmsi;
  std::vector<std::string> kind, to;
  for (std::size_t i = 0; i < vehicles.size(); ++i)
    for (const Kind& k : kinds) {
      const std::optional<Approach>& approach = vehicles[i].closest.*k.of;
      if (!approach) continue;
      vehicle.push_back(static_cast<double>(i));
      distance.push_back(approach->distance_m);
      time.push_back(approach->t_s);
      mmsi.push_back(approach->mmsi);
      kind.emplace_back(k.name);
      to.push_back(approach->to);
    }
  table.columns = {{"vehicle", "1", "index of the trajectory whose approach it is", vehicle},
                   {"distance", "m", "the least in the run", distance},
                   {"time", "s", "when, since the start of the run", time},
                   {"mmsi", "1", "of a vessel, else 0", mmsi}};
  table.texts = {{"kind", "what was approached: vehicle, structure, vessel or tether", kind},
                 {"to", "its name; of a tether that of whom it holds", to}};
  return table;
}

TrajectoryTable clearance_table(std::span<const VehicleSummary> vehicles) {
  TrajectoryTable table;
  table.name = "clearance";
  table.columns = {{"vehicle", "1", "index of the trajectory, of one that keeps clear", {}},
                   {"changed", "s", "time for which it was made to do otherwise", {}}};
  for (std::size_t c = 0; c < twin::alarm_causes; ++c) {
    const auto cause = static_cast<twin::AlarmCause>(c);
    table.columns.push_back({column_of(cause), "1", "alarms: " + words_of(cause), {}});
  }
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (!vehicles[i].clearance) continue;
    table.columns[0].values.push_back(static_cast<double>(i));
    table.columns[1].values.push_back(vehicles[i].clearance->changed_s);
    for (std::size_t c = 0; c < twin::alarm_causes; ++c)
      table.columns[2 + c].values.push_back(vehicles[i].clearance->alarms_from[c]);
  }
  return table;
}

Closest closest_in(const TrajectoryFile& log, const std::vector<VehicleLog>& vehicles,
                   std::size_t i, const twin::Scenario* scenario) {
  if (has_tables(log)) return tabled(log, i);
  Closest closest;
  if (scenario != nullptr)
    closest.structure = found(nearest_structure(log, vehicles[i], *scenario));
  closest.vehicle = found(nearest_vehicle(log, vehicles, i));
  closest.vessel = found(nearest_vessel(log, vehicles[i], vessels_in(log)));
  return closest;
}

std::optional<std::string> clearance_alarms_in(const TrajectoryFile& log, std::size_t vehicle) {
  const TrajectoryTable* table = log.find_table("clearance");
  const std::vector<double>* whose = table == nullptr ? nullptr : table->column("vehicle");
  if (whose == nullptr) return std::nullopt;
  for (std::size_t row = 0; row < whose->size(); ++row) {
    if ((*whose)[row] != static_cast<double>(vehicle)) continue;
    std::array<double, twin::alarm_causes> from{};
    for (std::size_t c = 0; c < twin::alarm_causes; ++c)
      if (const auto* column = table->column(column_of(static_cast<twin::AlarmCause>(c))))
        from[c] = (*column)[row];
    return clearance_alarms_text(from);
  }
  return std::nullopt;
}

std::string clearance_alarms_text(std::span<const double> from) {
  const double all = std::accumulate(from.begin(), from.end(), 0.0);
  if (!(all > 0)) return "none";
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < from.size(); ++c)
    if (from[c] > 0)
      parts.push_back(words_of(static_cast<twin::AlarmCause>(c)) + formatted(" {:.0f}", from[c]));
  return formatted("{:.0f}", all) + " (" + joined(parts, ", ") + ")";
}

}  // namespace slackwater::api
