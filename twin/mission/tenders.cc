#include "twin/mission/tenders.h"

#include <algorithm>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/mission/scenario_text.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

using constants::degree;
/// Off foundations on its way: an estimate, as of the crew vessel's task.
constexpr double vessel_clear_m = 15;

std::string way_text(const Triple<double>& from_m, const Triple<double>& to_m,
                     const WorkSite& site) {
  std::vector<Structure> piles;
  for (const WorkTurbine& t : site.turbines)
    piles.push_back(Cylinder{t.north_m, t.east_m, t.radius_m, t.top_m, t.foot_m});
  return route_text(way_round(from_m, to_m, piles, vessel_clear_m), Phase::transit);
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
  (void)carrier->keys();  // read with the scenario
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

std::string Tenders::text_of(const Config& vehicle,
                             const std::vector<Triple<double>>& stands_m) const {
  std::string text = "  - name: " + vehicle.flow_yaml("name") + "\n";
  for (const std::string& key : vehicle.keys())
    if (key != "name" && key != "stands")
      text += "    " + key + ": " + vehicle.flow_yaml(key) + "\n";
  Triple<double> is_at_m = stands_m.front();
  const auto start = vehicle.optional_child("start");
  if (start) {
    constexpr Range distance{-50e3, 50e3};
    (void)start->keys();
    is_at_m = {start->number("north_m", distance), start->number("east_m", distance), 0};
  } else {
    text += "    start: {" + place_text(is_at_m) + "}\n";
  }
  const Triple<double> start_m = is_at_m;
  if (!vehicle.has("conduct")) text += "    conduct: {}\n";
  text += "    tasks:\n";
  for (const Triple<double>& stand_m : stands_m) {
    if (length_of(stand_m - is_at_m) > 0.1) text += way_text(is_at_m, stand_m, site_);
    text += stand_by_text();
    is_at_m = stand_m;
  }
  if (start) text += way_text(is_at_m, start_m, site_);
  return text;
}

std::string Tenders::text() const {
  std::string text;
  for (const Config& vehicle : vehicles_) {
    const auto carries = stands_m_.find(vehicle.has("name") ? vehicle.text("name") : "");
    text += carries == stands_m_.end() ? "  - " + merged(vehicle, std::nullopt) + "\n"
                                       : text_of(vehicle, carries->second);
  }
  return text;
}

}  // namespace slackwater::twin
