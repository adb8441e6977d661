#include "twin/rehearse/calm_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/account/vehicle_account.h"
#include "twin/environment/made_up_field.h"
#include "twin/rehearse/flight.h"

namespace slackwater::twin {
namespace {

/// Where nobody says when: it is calm at any time.
const UtcTime no_time = parse_utc("2000-01-01T00:00:00Z");

/// Those whose work counts, and what carries them.
std::set<std::string> needed(const Scenario& mission, std::span<const std::string> workers) {
  std::set<std::string> names(workers.begin(), workers.end());
  for (const ScenarioVehicle& vehicle : mission.vehicles)
    if (names.contains(vehicle.name) && vehicle.carrier) names.insert(vehicle.carrier->name);
  return names;
}

/// Places of vehicles at work, some metres apart: what is told of a look that sees too little.
using Places = std::vector<std::vector<Triple<double>>>;

void note_places(std::span<const AgentState> states, std::span<const Agent> agents,
                 Places& places_m) {
  constexpr double apart_m = 1;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!agents[i].inspection || states[i].conduct.phase != Phase::work) continue;
    const Triple<double>& at_m = states[i].vehicle.body.position_m;
    if (places_m[i].empty() || length_of(at_m - places_m[i].back()) >= apart_m)
      places_m[i].push_back(at_m);
  }
}

/// How the area of a line's surfaces was looked at, by the best look at each patch.
struct Seen {
  double area_m2 = 0;
  double covered_m2 = 0;
  double missed_m2 = 0;  ///< not seen at all
  double coarse_m2 = 0;
  double slant_m2 = 0;
  double few_m2 = 0;
  double least_detail_m = std::numeric_limits<double>::infinity();  ///< of what was too coarse
  std::vector<std::string> surfaces;
};

Seen seen_by(const Inspection& inspection, const InspectionState& state, std::size_t line) {
  const InspectionLine& asked = inspection.plan.lines[line];
  const double least_cosine = std::cos(asked.most_incidence_rad) - 1e-6;
  Seen seen;
  for (std::size_t i = 0; i < inspection.pairs.size(); ++i) {
    if (inspection.pairs[i].line != line) continue;
    const Surface& surface = inspection.surfaces[inspection.pairs[i].surface];
    seen.surfaces.push_back(surface.name);
    for (std::size_t p = 0; p < surface.patches.size(); ++p) {
      const BestLook& best = state.best[i][p];
      const double area_m2 = surface.patches[p].area_m2;
      seen.area_m2 += area_m2;
      if (!best.is_seen()) {
        seen.missed_m2 += area_m2;
      } else if (is_covered(asked, best)) {
        seen.covered_m2 += area_m2;
      } else if (best.detail_m > asked.detail_m) {
        seen.coarse_m2 += area_m2;
        seen.least_detail_m = std::min<double>(seen.least_detail_m, best.detail_m);
      } else if (best.incidence_cosine < least_cosine) {
        seen.slant_m2 += area_m2;
      } else {
        seen.few_m2 += area_m2;
      }
    }
  }
  return seen;
}

/// From where the vehicle passes the surfaces of a line by, at the nearest.
double nearest_m(const Inspection& inspection, std::size_t line,
                 std::span<const Triple<double>> places_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const InspectedPair& pair : inspection.pairs) {
    if (pair.line != line) continue;
    for (const Patch& patch : inspection.surfaces[pair.surface].patches)
      for (const Triple<double>& place_m : places_m)
        least_m = std::min(least_m, length_of(place_m - patch.centre_m));
  }
  return least_m;
}

/// What most of what is not covered lacks.
std::string why_not(const Inspection& inspection, std::size_t line, const Seen& seen,
                    std::span<const Triple<double>> places_m) {
  const Instrument& instrument = inspection.instruments[line];
  const InspectionLine& asked = inspection.plan.lines[line];
  const double most_m2 = std::max({seen.missed_m2, seen.coarse_m2, seen.slant_m2, seen.few_m2});
  if (most_m2 == seen.missed_m2)
    return formatted(
        "it reaches {:g} m, the path passes {:.1f} m off at the nearest, and {:.0f} % are never in "
        "its view; lay the path nearer or its legs closer together, take an instrument that "
        "reaches farther, inspect less, or ask for less (seen_at)",
        instrument.most_range_m, nearest_m(inspection, line, places_m),
        100 * seen.missed_m2 / seen.area_m2);
  if (most_m2 == seen.coarse_m2)
    return formatted(
        "{:.0f} % are seen without the detail of {:g} mm that is asked, at best with {:.1f} mm; "
        "fly nearer or slower, or ask for less detail (detail_mm) or less of it (seen_at)",
        100 * seen.coarse_m2 / seen.area_m2, 1000 * asked.detail_m, 1000 * seen.least_detail_m);
  if (most_m2 == seen.slant_m2)
    return formatted(
        "{:.0f} % are seen from more than the {:g} deg off square that are asked; lay its legs "
        "closer together, or ask for less (incidence_deg, seen_at)",
        100 * seen.slant_m2 / seen.area_m2, asked.most_incidence_rad / constants::degree);
  return formatted(
      "{:.0f} % are looked at fewer than the {} times that are asked; fly more passes, or ask for "
      "less (looks, seen_at)",
      100 * seen.few_m2 / seen.area_m2, asked.looks);
}

void add_looks(const Agent& agent, const AgentState& state,
               std::span<const Triple<double>> places_m, std::vector<CalmLook>& looks) {
  const Inspection& inspection = *agent.inspection;
  for (std::size_t line = 0; line < inspection.plan.lines.size(); ++line) {
    const double asked = inspection.plan.lines[line].seen_at;
    if (!(asked > 0)) continue;
    const Seen seen = seen_by(inspection, state.inspection, line);
    CalmLook& look = looks.emplace_back();
    look.vehicle = agent.name;
    look.instrument = inspection.instruments[line].name;
    look.surfaces = joined(seen.surfaces, ", ");
    look.covered = seen.area_m2 > 0 ? seen.covered_m2 / seen.area_m2 : 0;
    look.asked = asked;
    if (!look.is_seen()) look.why = why_not(inspection, line, seen, places_m);
  }
}

bool all_seen(std::span<const Agent> agents, std::span<const AgentState> states) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (!agents[i].inspection) continue;
    const Inspection& inspection = *agents[i].inspection;
    for (std::size_t line = 0; line < inspection.plan.lines.size(); ++line) {
      const double asked = inspection.plan.lines[line].seen_at;
      if (!(asked > 0)) continue;
      const Seen seen = seen_by(inspection, states[i].inspection, line);
      if (seen.covered_m2 < asked * seen.area_m2) return false;
    }
  }
  return true;
}

}  // namespace

Scenario in_dead_calm(const Scenario& mission, std::span<const std::string> workers,
                      double depth_m) {
  Scenario calm = mission;
  calm.start = mission.start.value_or(no_time);
  MadeUpWater still;
  still.depth_m = depth_m;
  calm.water = still;
  calm.member = 0;
  calm.waves = {};
  calm.waves.from_forecast = false;
  calm.gusts = GustModel::none;
  calm.has_wakes = false;
  calm.traffic = {};
  calm.clearance.reset();
  calm.logs_sensors = false;
  calm.rays_per_look = std::min(mission.rays_per_look, rays_per_look_of_many);
  const std::set<std::string> names = needed(mission, workers);
  std::erase_if(calm.vehicles,
                [&](const ScenarioVehicle& vehicle) { return !names.contains(vehicle.name); });
  for (ScenarioVehicle& vehicle : calm.vehicles) {
    vehicle.navigates_by_sensors = false;
    vehicle.logs_sensors = false;
    if (!vehicle.conduct) continue;
    vehicle.conduct->limits.clear();
    vehicle.conduct->faults.clear();
    vehicle.conduct->mammals.reset();
  }
  return calm;
}

CalmFlight fly_in_calm(const Scenario& calm, Surround surround, CalmEnd until) {
  const auto length = Duration(static_cast<Duration::rep>(calm.duration_s * 1000) + 1000);
  const UtcTime start = calm.start.value_or(no_time);
  surround.site = origin_of(calm, surround.site);
  surround.field =
      made_up_field(std::get<MadeUpWater>(calm.water), surround.site, start, start + length);
  surround.vessels.clear();
  surround.turbines_m.clear();
  surround.turbine.reset();
  surround.is_only_asked = false;
  ReadyRun ready = set_up(calm, surround);
  RunSettings settings;
  settings.seed = calm.seed;
  settings.step_s = calm.step_s;
  Run run(std::move(ready.agents), std::move(ready.states), settings);
  const auto steps = static_cast<std::uint64_t>(std::llround(calm.duration_s / calm.step_s));
  const auto per_second =
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(1 / calm.step_s)));
  Places places_m(run.agents().size());
  bool is_all_seen = false;
  while (run.steps_made() < steps && !run.all_ended() && !is_all_seen) {
    if (run.steps_made() % per_second == 0) note_places(run.states(), run.agents(), places_m);
    run.step();
    constexpr std::uint64_t every_s = 20;
    if (until == CalmEnd::seen && run.steps_made() % (every_s * per_second) == 0)
      is_all_seen = all_seen(run.agents(), run.states());
  }
  CalmFlight flight;
  flight.is_flown_out = true;
  const auto states = run.states();
  const EndedRun ended{run.agents(), states, calm.structures, run.time_s()};
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Agent& agent = run.agents()[i];
    if (!agent.inspection) continue;
    flight.is_flown_out &= is_all_seen || account_of(ended, i).is_done;
    add_looks(agent, states[i], places_m[i], flight.looks);
  }
  return flight;
}

}  // namespace slackwater::twin
