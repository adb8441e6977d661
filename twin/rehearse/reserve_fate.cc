#include "twin/rehearse/reserve_fate.h"

#include <algorithm>

namespace slackwater::twin {
namespace {

bool has_event(const VehicleAccount& vehicle, ConductEventKind kind) {
  return std::any_of(vehicle.mission.begin(), vehicle.mission.end(),
                     [&](const MissionEvent& event) { return event.kind == kind; });
}

bool was_called_home(const VehicleAccount& vehicle) {
  return std::any_of(vehicle.mission.begin(), vehicle.mission.end(), [](const MissionEvent& event) {
    return event.kind == ConductEventKind::turned_for_home && event.cause == Cause::reserve;
  });
}

}  // namespace

const char* name_of(ReserveFate fate) noexcept {
  switch (fate) {
    case ReserveFate::kept:
      return "kept";
    case ReserveFate::called_home:
      return "called_home";
    case ReserveFate::broken:
      return "broken";
    case ReserveFate::not_home:
      break;
  }
  return "not_home";
}

ReserveFate reserve_fate(const VehicleAccount& vehicle, double reserve_share) {
  const bool is_energy = vehicle.risks().has(RiskCause::energy);
  const bool is_home = has_event(vehicle, ConductEventKind::finished) ||
                       has_event(vehicle, ConductEventKind::gave_up);
  if (!is_home)
    return is_energy && vehicle.least_charge < reserve_share ? ReserveFate::broken
                                                             : ReserveFate::not_home;
  if (!is_energy) return ReserveFate::kept;
  return was_called_home(vehicle) && vehicle.on_mission.charge >= reserve_share
             ? ReserveFate::called_home
             : ReserveFate::broken;
}

bool counts(const ScenarioVehicle& vehicle, const FlightSettings& settings) {
  if (settings.workers.empty()) return vehicle.conduct.has_value();
  return std::find(settings.workers.begin(), settings.workers.end(), vehicle.name) !=
         settings.workers.end();
}

ReserveFate reserve_fate(const Flight& flight, const Scenario& mission,
                         const FlightSettings& settings) {
  ReserveFate worst = ReserveFate::kept;
  for (std::size_t v = 0; v < flight.vehicles.size(); ++v) {
    const ScenarioVehicle& vehicle = mission.vehicles[v];
    if (!counts(vehicle, settings) || !vehicle.conduct) continue;
    worst = std::max(worst, reserve_fate(flight.vehicles[v], vehicle.conduct->reserve.share));
  }
  return worst;
}

}  // namespace slackwater::twin
