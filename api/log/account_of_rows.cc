#include "api/log/account_of_rows.h"

#include <algorithm>
#include <cmath>

#include "api/log/account_log.h"
#include "api/log/account_tables.h"
#include "api/log/inspection_log.h"
#include "api/log/table_reader.h"
#include "api/log/traffic_tables.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/run/set_up.h"
#include "twin/scene/structure.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using twin::Approach;
using twin::Fate;
using twin::Halt;
using twin::RunAccount;
using twin::VehicleAccount;

/// The rows of a log of one vehicle until it halted.
class Rows {
 public:
  Rows(const TrajectoryFile& log, std::size_t vehicle)
      : rows_(rows_of(log, vehicle)), count_(log.t_s.size()) {
    const std::span<const double> halt = rows_.column("halt");
    for (std::size_t t = 0; t < std::min(count_, halt.size()); ++t)
      if (halt[t] > 0) count_ = t + 1;
  }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// No number where the log has no such variable.
  [[nodiscard]] double at(std::string_view name, std::size_t row) const {
    const std::span<const double> values = rows_.column(name);
    return values.empty() ? constants::nan : values[row];
  }
  [[nodiscard]] double last(std::string_view name) const { return at(name, count_ - 1); }
  [[nodiscard]] double t_s(std::size_t row) const { return rows_.t_s[row]; }
  /// NED.
  [[nodiscard]] twin::Triple<double> place_m(std::size_t row) const {
    return {at("y", row), at("x", row), -at("z", row)};
  }

 private:
  twin::VehicleRows rows_;
  std::size_t count_;
};

Halt halt_numbered(double number) {
  constexpr int last = static_cast<int>(Halt::no_headway);
  if (!(number > 0)) return Halt::none;
  if (number <= last && number == std::floor(number)) return static_cast<Halt>(number);
  throw Error(ErrorKind::invalid_input,
              formatted("the log has {:g} as halt, expected 0 to {}; read it with the version that "
                        "wrote it",
                        number, last));
}

/// @param is_in_air  just before
Fate fate_of(Halt halt, bool is_in_air) {
  switch (halt) {
    case Halt::outside_area:
      return Fate::left_area;
    case Halt::outside_time:
      return Fate::forecast_ended;
    case Halt::aground:
      return Fate::aground;
    case Halt::no_data:
      return Fate::no_data;
    case Halt::struck:
      return Fate::struck_structure;
    case Halt::capsized:
      return Fate::capsized;
    case Halt::no_headway:
      return is_in_air ? Fate::slower_than_wind : Fate::slower_than_water;
    default:
      return Fate::diverged;
  }
}

void read_fate(const Rows& rows, VehicleAccount& vehicle) {
  for (std::size_t t = 0; t < rows.count(); ++t) {
    if (!(rows.at("battery_off", t) > 0)) continue;
    const bool is_empty = rows.at("state_of_charge", t) < 1e-9;
    vehicle.fate.push_back({is_empty ? Fate::battery_empty : Fate::battery_cut_off, rows.t_s(t)});
    break;
  }
  vehicle.halt = halt_numbered(rows.last("halt"));
  if (vehicle.halt == Halt::none) return;
  constexpr double afloat_m = 2;  // above it nothing swims
  const double up_m = rows.at("z", rows.count() > 1 ? rows.count() - 2 : 0);
  vehicle.halted_at_s = rows.t_s(rows.count() - 1);
  vehicle.fate.push_back({fate_of(vehicle.halt, up_m > afloat_m), vehicle.halted_at_s});
}

void read_energy(const Rows& rows, VehicleAccount& vehicle) {
  const double delivered_j = rows.last("energy_delivered");
  const double drawn_j = rows.last("electrical_energy");
  const double fuel_kg = rows.last("fuel_burnt"), charge = rows.last("state_of_charge");
  vehicle.makeup.has_battery = delivered_j > 0;
  vehicle.makeup.burns_fuel = fuel_kg > 0;
  vehicle.makeup.is_electric = std::isfinite(drawn_j) || delivered_j > 0;
  if (std::isfinite(drawn_j) || std::isfinite(delivered_j))
    vehicle.in_all.drawn_j = std::isfinite(drawn_j) ? drawn_j : delivered_j;
  if (std::isfinite(fuel_kg)) vehicle.in_all.fuel_kg = fuel_kg;
  if (std::isfinite(charge)) vehicle.in_all.charge = charge;
  vehicle.on_mission = vehicle.in_all;
}

void read_tasks(const Rows& rows, const twin::Scenario* scenario, VehicleAccount& vehicle) {
  if (const double task = rows.last("task"); task >= 0)
    vehicle.tasks_done = static_cast<std::size_t>(task);
  if (scenario == nullptr) return;
  for (const twin::ScenarioVehicle& entry : scenario->vehicles)
    if (entry.name == vehicle.name) vehicle.tasks = entry.tasks.size();
}

/// Along the straight ways between the rows; to a face.
Approach nearest_structure(const Rows& rows, const twin::Scenario& scenario) {
  Approach nearest;
  for (const twin::ScenarioStructure& structure : scenario.structures) {
    const twin::Structure shape = twin::shape_of(structure);
    for (std::size_t t = 0; t < rows.count(); ++t) {
      const double distance_m =
          twin::least_distance_m(shape, rows.place_m(t == 0 ? 0 : t - 1), rows.place_m(t));
      if (distance_m < nearest.distance_m)
        nearest = Approach{distance_m, rows.t_s(t), structure.name, 0};
    }
  }
  return nearest;
}

/// Centre to centre, at the rows of both.
Approach nearest_vehicle(const std::vector<Rows>& all, const std::vector<std::string>& names,
                         std::size_t i) {
  Approach nearest;
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (j == i) continue;
    for (std::size_t t = 0; t < std::min(all[i].count(), all[j].count()); ++t) {
      const double distance_m = length_of(all[i].place_m(t) - all[j].place_m(t));
      if (distance_m < nearest.distance_m)
        nearest = Approach{distance_m, all[i].t_s(t), names[j], 0};
    }
  }
  return nearest;
}

/// In the plane, at the rows; the traffic where its track is known.
Approach nearest_vessel(const Rows& rows, std::span<const twin::TrafficVessel> vessels) {
  Approach nearest;
  for (const twin::TrafficVessel& vessel : vessels)
    for (std::size_t t = 0; t < rows.count(); ++t) {
      const twin::TrackState there = vessel.track.at(rows.t_s(t));
      if (!there.is_known()) continue;
      const auto apart = rows.place_m(t) - there.position_m;
      const double distance_m = std::hypot(apart.x, apart.y);
      if (distance_m < nearest.distance_m)
        nearest = {distance_m, rows.t_s(t), vessel.name, vessel.id};
    }
  return nearest;
}

std::optional<Approach> found(Approach approach) {
  return std::isfinite(approach.distance_m) ? std::optional(std::move(approach)) : std::nullopt;
}

void read_mission_end(double ran_s, VehicleAccount& vehicle) {
  vehicle.ended_s = vehicle.halt != Halt::none ? vehicle.halted_at_s : ran_s;
  vehicle.makeup.has_conduct = !vehicle.mission.empty();
  if (vehicle.halt != Halt::none)
    vehicle.stopped_by = words_of(vehicle.fate.back().what);
  else if (twin::are_out(vehicle.mission))
    vehicle.fate.push_back({Fate::not_recovered, ran_s});
  if (const auto end = twin::mission_end_of(vehicle.mission, ran_s)) {
    vehicle.ended_s = end->t_s;
    if (vehicle.stopped_by.empty()) vehicle.stopped_by = end->why;
  }
  vehicle.is_done = vehicle.stopped_by.empty();
}

}  // namespace

void read_events(const TrajectoryFile& log, RunAccount& account) {
  const TableReader mission(log, "mission"), approach(log, "approach"), clearance(log, "clearance");
  const ingest::TrajectoryTable* missions = log.find_table("mission");
  const bool has_values = missions != nullptr && missions->column("value") != nullptr;
  const auto finite = [](double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  mission.for_each([&](std::size_t vehicle, std::size_t row) {
    account.vehicles[vehicle].mission.push_back(
        {mission.number("time", row), mission.named("kind", row, twin::ConductEventKind::found),
         mission.named("cause", row, twin::Cause::no_watch), mission.text("text", row),
         has_values ? finite(mission.number("value", row)) : std::nullopt});
  });
  approach.for_each([&](std::size_t vehicle, std::size_t row) {
    for (const ApproachKind& kind : approach_kinds())
      if (approach.text("kind", row) == kind.name)
        account.vehicles[vehicle].closest.*kind.of = Approach{
            approach.number("distance", row), approach.number("time", row),
            approach.text("to", row), static_cast<std::uint32_t>(approach.whole("mmsi", row))};
  });
  clearance.for_each([&](std::size_t vehicle, std::size_t row) {
    twin::ClearanceAccount& own = account.vehicles[vehicle].clearance.emplace();
    own.changed_s = clearance.number("changed", row);
    for (std::size_t c = 0; c < twin::alarm_causes; ++c)
      own.alarms_from[c] =
          clearance.number(column_of(static_cast<twin::AlarmCause>(c)).c_str(), row);
  });
}

void read_bands(const TrajectoryFile& log, RunAccount& account) {
  const TableReader table(log, "cleaning");
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    auto& cleaning = account.vehicles[vehicle].cleaning;
    if (!cleaning) cleaning.emplace();
    cleaning->bands.push_back({table.number("upper_depth", row), table.number("lower_depth", row),
                               table.number("area", row), table.number("cleaned_area", row),
                               table.number("growth_removed", row),
                               table.number("growth_left", row)});
  });
}

void read_off_rows(const TrajectoryFile& log, const twin::Scenario* scenario, RunAccount& account) {
  constexpr int first_with_approaches = 3;
  std::vector<Rows> all;
  for (std::size_t i = 0; i < log.names.size(); ++i) all.emplace_back(log, i);
  const bool has_approaches = log_format_of(log) >= first_with_approaches;
  const auto vessels = has_approaches ? std::vector<twin::TrafficVessel>() : vessels_in(log);
  for (std::size_t i = 0; i < all.size(); ++i) {
    VehicleAccount& vehicle = account.vehicles[i];
    read_fate(all[i], vehicle);
    read_energy(all[i], vehicle);
    read_tasks(all[i], scenario, vehicle);
    read_mission_end(account.ran_s, vehicle);
    if (has_approaches) continue;
    if (scenario != nullptr)
      vehicle.closest.structure = found(nearest_structure(all[i], *scenario));
    vehicle.closest.vehicle = found(nearest_vehicle(all, log.names, i));
    vehicle.closest.vessel = found(nearest_vessel(all[i], vessels));
  }
  read_inspections(log, account);
}

}  // namespace slackwater::api
