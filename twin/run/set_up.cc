#include "twin/run/set_up.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/follow_tracks.h"
#include "twin/agent/keep_lookout.h"
#include "twin/body/frame.h"
#include "twin/environment/sea_of_run.h"
#include "twin/handling/handling_findings.h"
#include "twin/run/expect_places.h"
#include "twin/run/expect_speeds.h"
#include "twin/run/ready_company.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {
namespace {

UtcTime start_of(const Scenario& scenario, const Field& field) {
  const ValidRange& range = field.range();
  const UtcTime start = scenario.start.value_or(range.from);
  const UtcTime end =
      start + Duration(static_cast<Duration::rep>(std::ceil(scenario.duration_s * 1000)));
  if (start < range.from || end > range.to) {
    refuse("start: the run lasts from " + format_utc(start) + " to " + format_utc(end) +
           ", and the forecast holds from " + format_utc(range.from) + " to " +
           format_utc(range.to) + "; move the start, shorten the run or take a later forecast");
  }
  return start;
}

std::shared_ptr<const FarmFlow> wakes_of(const Scenario& scenario, const Surround& surround,
                                         const GeoPoint& origin, UtcTime start) {
  if (!scenario.has_wakes) return nullptr;
  if (!surround.turbine || surround.turbines_m.empty())
    refuse("wakes: the site has no turbines; leave `wakes` out, or give the site a layout");
  const Place at_hub{origin.longitude_deg(), origin.latitude_deg(), surround.turbine->hub_height_m,
                     start};
  WindSample wind;
  surround.field->sample_wind({&at_hub, 1}, {&wind, 1}, scenario.member);
  if (!has_value(wind.status)) refuse("wakes: the forecast has no wind there");
  return std::make_shared<FarmFlow>(*surround.turbine, surround.turbines_m, wind.velocity_m_s,
                                    FarmSettings{});
}

/// Those of the logs and those made up, each number once.
std::vector<TrafficVessel> vessels_of(const Scenario& scenario, const Surround& surround) {
  std::vector<TrafficVessel> vessels = surround.vessels;
  for (const MadeUpVessel& made_up : scenario.traffic.vessels) {
    for (const TrafficVessel& heard : surround.vessels)
      if (heard.id == made_up.mmsi)
        refuse("traffic: vessel " + std::to_string(made_up.mmsi) +
               " is in a log of AIS too; give the made-up one another mmsi");
    vessels.push_back(vessel_of(made_up, scenario.duration_s));
  }
  return vessels;
}

/// A pattern that comes along over ground comes to what stands there.
bool has_drifting_task(const ScenarioVehicle& entry) {
  return std::any_of(entry.tasks.begin(), entry.tasks.end(),
                     [](const ScenarioTask& task) { return task.drifts; });
}

/// The place of a vehicle's carrier in the run.
std::size_t carrier_of(const Scenario& scenario, const ScenarioVehicle& entry) {
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i)
    if (const ScenarioVehicle& other = scenario.vehicles[i];
        other.name == entry.carrier->name && other.name != entry.name && !other.carrier)
      return i;
  refuse("vehicle " + entry.name + ": carrier: found " + entry.carrier->name +
         ", expected the name of another vehicle that nobody carries");
}

/// Put there first, where it is missing.
const std::shared_ptr<const Vehicle>& taken_from(VehicleShelf& shelf,
                                                 const std::filesystem::path& file,
                                                 const std::filesystem::path& data_folder) {
  auto& vehicle = shelf[file];
  if (!vehicle) vehicle = std::make_shared<const Vehicle>(read_handled_vehicle(file, data_folder));
  return vehicle;
}

/// The place of the vehicle whose work the watch of another one hears.
std::size_t noisy_of(const Scenario& scenario, const ScenarioVehicle& watch) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const ScenarioVehicle& other = scenario.vehicles[i];
    const bool works =
        other.conduct && std::any_of(other.tasks.begin(), other.tasks.end(),
                                     [](const auto& task) { return task.phase == Phase::work; });
    if (!works || other.name == watch.name) continue;
    if (other.name == watch.conduct->mammals->noise_by) return i;
    others.push_back(other.name);
  }
  refuse("vehicle " + watch.name + ": noise_by: found " + watch.conduct->mammals->noise_by +
         ", expected another vehicle that conducts itself and has work to do" +
         (others.empty() ? std::string(", of which there is none") : ": " + joined(others, ", ")));
}

/// Whose work is noisy waits for the word of all who watch for that.
void tie_watches(const Scenario& scenario, std::vector<Agent>& agents) {
  std::string tied, loose;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i) {
    const ScenarioVehicle& watch = scenario.vehicles[i];
    if (!watch.conduct || !watch.conduct->mammals) continue;
    const MammalDuty& duty = *watch.conduct->mammals;
    (duty.noise_by.empty() ? loose : tied) = watch.name;
    if (duty.noise_by.empty()) continue;
    auto& zone = agents[noisy_of(scenario, watch)].zone;
    if (!zone) zone.emplace();
    zone->watchers.push_back(i);
    zone->rule.clear_for_s = std::max(zone->rule.clear_for_s, duty.noise.watch_s);
    zone->rule.again_after_s =
        std::max(zone->rule.again_after_s, duty.again_after_s.value_or(duty.noise.watch_s));
  }
  if (!tied.empty() && !loose.empty())
    refuse("vehicle " + loose + ": watches for mammals without noise_by, and " + tied +
           " with it; give noise_by at both, or at neither");
}

/// By what an autopilot is worked out from.
using Autopilots =
    std::map<std::tuple<const Vehicle*, FollowerChoice, double>, std::shared_ptr<const Autopilot>>;

/// A thousand vehicles that each go by an autopilot of their own do not fit in the cache.
void share_autopilot(Autopilots& autopilots, const ScenarioVehicle& entry, Agent& agent) {
  auto& first = autopilots[{agent.vehicle.get(), entry.follower, entry.held_voltage_v}];
  if (!first) first = agent.autopilot;
  agent.autopilot = first;
}

}  // namespace

Structure shape_of(const ScenarioStructure& s) {
  if (s.kind == ScenarioStructure::Kind::cylinder)
    return Cylinder{s.centre_m.x, s.centre_m.y, 0.5 * s.diameter_m, s.top_m, s.bottom_m};
  const Triple<double> centre_m{s.centre_m.x, s.centre_m.y, 0.5 * (s.top_m + s.bottom_m)};
  return box_of(centre_m, {0.5 * s.size_m.x, 0.5 * s.size_m.y, 0.5 * (s.bottom_m - s.top_m)}, 0);
}

std::filesystem::path vehicle_file(const std::string& model,
                                   const std::filesystem::path& data_folder) {
  std::filesystem::path named = data_folder / "vehicles" / (model + ".yaml");
  if (model.find('/') == std::string::npos && std::filesystem::exists(named)) return named;
  if (std::filesystem::exists(model)) return model;
  refuse("model: found " + model + ", expected one of " + joined(catalogue(data_folder), ", ") +
         ", or the path of a file");
}

std::vector<std::string> catalogue(const std::filesystem::path& data_folder) {
  std::vector<std::string> ids;
  for (const auto& entry : std::filesystem::directory_iterator(data_folder / "vehicles"))
    if (entry.path().extension() == ".yaml") ids.push_back(entry.path().stem().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

VehicleShelf read_vehicles(const Scenario& scenario, const std::filesystem::path& data_folder) {
  VehicleShelf shelf;
  for (const ScenarioVehicle& entry : scenario.vehicles)
    with_context("vehicle " + entry.name, [&] {
      (void)taken_from(shelf, vehicle_file(entry.model, data_folder), data_folder);
    });
  return shelf;
}

void add_gusts(const Scenario& scenario, const ScenarioVehicle& entry, double t_s, Agent& agent) {
  const bool is_in_air =
      agent.vehicle->kind == VehicleKind::uav || agent.vehicle->body.hull.strips > 0;
  if (scenario.gusts == GustModel::none || !is_in_air) return;
  constexpr double twenty_feet_m = 6.096;
  const auto low = agent.water->wind({entry.start_m.x, entry.start_m.y, -twenty_feet_m}, t_s);
  const Triple<double> place_m = wind_place_m(*agent.vehicle, entry.start_m);
  const auto here = agent.water->wind(place_m, t_s);
  const double speed = std::hypot(here.velocity_m_s.x, here.velocity_m_s.y);
  if (!has_value(low.status) || !(speed > 0.1) || !(low.ratio > 0)) return;
  // The turbulence of the free wind: what a wake makes of it is known at each step.
  const double low_m_s = std::hypot(low.velocity_m_s.x, low.velocity_m_s.y) / low.ratio;
  agent.gusts.emplace(dryden_turbulence(height_of(place_m), low_m_s), speed, agent.plan.dt_s);
}

GeoPoint origin_of(const Scenario& scenario, const GeoPoint& site) noexcept {
  return scenario.has_origin ? scenario.origin : site;
}

namespace {

/// It turns the water that it stands in: over its top the current goes on.
StandingPile pile_of(const ScenarioStructure& s) {
  constexpr double drag_coefficient = 1.05;
  return {{s.diameter_m, drag_coefficient}, horizontal_of(s.centre_m), s.top_m, s.bottom_m};
}

/// Water without its tide is no water to rehearse in, unless that is asked for.
void expect_instants(const Scenario& scenario, const Snapshot& forecast,
                     std::vector<std::string>& warnings) {
  if (!forecast.averaged) return;
  const auto* const wanted = std::get_if<ForecastWater>(&scenario.water);
  const std::string sentence = sentence_of(*forecast.averaged);
  if (wanted == nullptr || !wanted->accept_means) {
    refuse("water: " + sentence +
           "; a mean is not the flow at any moment. Use a forecast made from hourly currents, or "
           "write `accept_means: true` beside the forecast to run in it anyway");
  }
  warnings.push_back(sentence);
}

}  // namespace

ReadyRun set_up(const Scenario& scenario, const Surround& surround) {
  const Field& field = *surround.field;
  if (scenario.member >= field.snapshot().members) {
    refuse("member: found " + std::to_string(scenario.member) + ", the forecast has 0 to " +
           std::to_string(field.snapshot().members - 1));
  }
  const std::vector<ForecastColumn>& columns = field.snapshot().columns;
  const bool is_without_currents =
      surround.is_only_asked && std::none_of(columns.begin(), columns.end(), has_currents);
  ReadyRun ready;
  expect_instants(scenario, field.snapshot(), ready.warnings);
  ready.start = start_of(scenario, field);
  ready.origin = origin_of(scenario, surround.site);
  Environment environment;
  environment.field = surround.field;
  environment.member = scenario.member;
  environment.origin = ready.origin;
  environment.epoch = ready.start;
  if (scenario.waves.regular) {
    environment.stated_sea = state_of(*scenario.waves.regular);
  } else if (!scenario.waves.from_forecast) {
    const PartitionedSea& sea = scenario.waves.made_up;
    environment.stated_sea =
        SeaState{sea.significant_height_m(), sea.peak_period_s(), sea.from_direction_deg()};
  } else if (scenario.waves.have_height_errors) {
    environment.waves =
        std::make_shared<const WaveFutures>(field.snapshot(), field.snapshot().members);
  }
  RunSea sea = sea_of_run(scenario, environment, ready.warnings);
  environment.sea = std::move(sea.waves);
  environment.sea_peak_period_s = sea.peak_period_s;
  environment.farm = wakes_of(scenario, surround, ready.origin, ready.start);
  if (surround.turbine && !surround.turbines_m.empty())
    environment.turbines = StandingTurbines{surround.turbine, surround.turbines_m};
  environment.weather = std::make_shared<WeatherInHand>();
  for (const ScenarioStructure& s : scenario.structures) {
    environment.structures.push_back(shape_of(s));
    if (s.turns_current) environment.piles.push_back(pile_of(s));
  }
  ready.environment = std::make_shared<const Environment>(std::move(environment));
  const std::shared_ptr<const EnvironmentSampler> water = sampler_of(ready.environment);
  VehicleShelf vehicles = surround.vehicles;
  std::set<const Vehicle*> named;  // whose warnings are told
  ready.vessels = vessels_of(scenario, surround);
  const auto around = std::make_shared<const std::vector<TrafficVessel>>(ready.vessels);
  Autopilots autopilots;
  for (const ScenarioVehicle& listed : scenario.vehicles) {
    ScenarioVehicle entry;
    with_context("vehicle " + listed.name, [&] {
      const std::filesystem::path file = vehicle_file(listed.model, surround.data_folder);
      const auto& vehicle = taken_from(vehicles, file, surround.data_folder);
      if (named.insert(vehicle.get()).second)
        for (const std::string& warning : vehicle->warnings)
          ready.warnings.push_back(file.filename().string() + ": " + warning);
      entry = with_tracks(listed, *vehicle, ready.vessels, scenario.duration_s);
      if (entry.conduct) load_look_outs(*entry.conduct, surround.data_folder);
      ready.agents.push_back(make_agent(vehicle, water, entry, scenario.step_s));
      share_autopilot(autopilots, entry, ready.agents.back());
      expect_speeds(entry, ready.agents.back());
    });
    Agent& agent = ready.agents.back();
    if (entry.conduct && entry.conduct->inspection)
      with_context("vehicle " + entry.name,
                   [&] { agent.inspection = inspection_of(scenario, entry, surround); });
    expect_places(scenario, entry, agent, 0, is_without_currents);
    add_gusts(scenario, entry, 0, agent);
    // Whose deck its limits may be about.
    if (entry.carrier) agent.carrier = carrier_of(scenario, entry);
    with_context("vehicle " + entry.name,
                 [&] { ready.states.push_back(first_state(agent, entry, scenario.seed)); });
    agent.vessels = around;
    agent.helm.home_after_s = scenario.home_after_s;
    if (scenario.clearance && entry.keeps_clear) {
      agent.clearance = clearance_of(agent, *scenario.clearance, entry, scenario.step_s);
    } else if (entry.keeps_clear && has_drifting_task(entry)) {
      agent.clearance = clearance_of(agent, {}, entry, scenario.step_s);
      agent.clearance->only_structures = true;
    }
    for (std::string& warning : too_fast_tracks(agent, scenario.duration_s))
      ready.warnings.push_back(std::move(warning));
  }
  ready.vehicles = std::move(vehicles);
  tie_watches(scenario, ready.agents);
  ready_company(scenario, ready.agents, ready.states);
  return ready;
}

}  // namespace slackwater::twin
