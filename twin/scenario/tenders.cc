#include "twin/scenario/tenders.h"

#include <algorithm>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/mission/way_round.h"
#include "twin/scenario/laid_out_task.h"
#include "twin/scenario/read_scenario.h"

namespace slackwater::twin {
namespace {

using constants::degree;
/// Off foundations on its way: an estimate, as of the crew vessel's task.
constexpr double vessel_clear_m = 15;

ScenarioTask way_task(const Triple<double>& from_m, const Triple<double>& to_m,
                      const WorkSite& site) {
  std::vector<Structure> piles;
  for (const WorkTurbine& t : site.turbines)
    piles.push_back(Cylinder{t.north_m, t.east_m, t.radius_m, t.top_m, t.foot_m});
  return route_task(way_round(from_m, to_m, piles, vessel_clear_m), Phase::transit);
}

}  // namespace

Tenders::Tenders(const Config& mission, const WorkSite& site,
                 std::span<const WorkTurbine* const> turbines)
    : mission_(mission),
      site_(site),
      turbines_(turbines),
      vehicles_(mission.children("vehicles")) {}

std::vector<Triple<double>> Tenders::stands_at(const Config& place) const {
  const auto bearing = place.optional_number("bearing_deg", {-360, 360});
  const double distance_m = place.number("distance_m", {0.2, 20e3});
  std::vector<Triple<double>> stands_m;
  for (const WorkTurbine* t : turbines_)
    stands_m.push_back(
        t->around(bearing ? *bearing * degree : t->landing_rad, t->radius_m + distance_m, 0));
  return stands_m;
}

const std::vector<Triple<double>>& Tenders::taken_by(const std::string& role, const Config& agent,
                                                     const std::optional<Config>& over) {
  static const std::vector<Triple<double>> none;
  const auto carrier = over ? over->optional_child("carrier") : std::nullopt;
  if (!carrier) {
    if (agent.has("tether") && turbines_.size() > 1)
      mission_.refuse("turbines",
                      formatted("found {} for {}, the top of whose tether stays where it is; name "
                                "a vessel that takes it from one to the next (agents: {{{}: "
                                "{{carrier: {{name: ...}}}}}}, page on missions), or fly them one "
                                "by one",
                                turbines_.size(), role, role));
    return none;
  }
  const std::string name = carrier->text("name");
  std::vector<std::string> known;
  for (const Config& vehicle : vehicles_) known.push_back(vehicle.text("name"));
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end())
    carrier->refuse("name", "found " + name + ", expected one of the mission's vehicles" +
                                (known.empty() ? ", of which there is none; add it to `vehicles`"
                                               : ": " + joined(known, ", ")));
  const Config& vehicle = vehicles_[static_cast<std::size_t>(found - known.begin())];
  if (vehicle.has("tasks"))
    vehicle.refuse("tasks", "found at the carrier of " + role +
                                ", whose way is laid out from turbine to turbine; leave them out");
  auto& stands_m = stands_m_[name];
  if (!stands_m.empty()) return stands_m;
  if (const auto stands = vehicle.optional_child("stands"))
    stands_m = stands_at(*stands);
  else
    stands_m =
        stands_at(agent.has("tether") ? agent.child("tether").child("top") : agent.child("start"));
  return stands_m;
}

void Tenders::lay_out(const std::vector<Triple<double>>& stands_m, ScenarioVehicle& carrier) const {
  const bool comes_from_afar = !carrier.starts_on_track;
  const Triple<double> first_m = stands_m.front();
  // It sails, whatever depth its start is said to be at.
  const Triple<double> start_m =
      comes_from_afar ? Triple<double>{carrier.start_m.x, carrier.start_m.y, 0} : first_m;
  if (!comes_from_afar) carrier.start_m = to_micrometre(first_m);
  carrier.starts_on_track = false;
  if (!carrier.conduct) carrier.conduct.emplace();
  carrier.tasks.clear();
  Triple<double> is_at_m = start_m;
  for (const Triple<double>& stand_m : stands_m) {
    if (length_of(stand_m - is_at_m) > 0.1)
      carrier.tasks.push_back(way_task(is_at_m, stand_m, site_));
    carrier.tasks.push_back(stand_by_task());
    is_at_m = stand_m;
  }
  if (comes_from_afar) carrier.tasks.push_back(way_task(is_at_m, start_m, site_));
}

std::vector<ScenarioVehicle> Tenders::vehicles(bool by_sensors) const {
  std::vector<ScenarioVehicle> all;
  for (const Config& entry : vehicles_) {
    ScenarioVehicle& vehicle = all.emplace_back(read_vehicle(entry, by_sensors));
    if (const auto carries = stands_m_.find(vehicle.name); carries != stands_m_.end())
      lay_out(carries->second, vehicle);
  }
  return all;
}

}  // namespace slackwater::twin
