#include "twin/scenario/lay_out_agent.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "fields/base/constants.h"

#include "twin/mission/conduct.h"
#include "twin/mission/read_seconds.h"
#include "twin/mission/way_round.h"
#include "twin/mission/work_pattern.h"
#include "twin/scenario/laid_out_task.h"
#include "twin/scenario/lay_out_surface.h"
#include "twin/scenario/read_scenario.h"

namespace slackwater::twin {
namespace {

using constants::degree;

std::vector<Structure> obstacles_of(const WorkSite& site) {
  std::vector<Structure> all;
  for (const WorkTurbine& t : site.turbines)
    all.push_back(Cylinder{t.north_m, t.east_m, t.radius_m, std::min(t.hub_m, t.top_m), t.foot_m});
  return all;
}

/// What of an agent's entry in a mission is not of its conduct.
const std::set<std::string> of_the_vehicle{"model",  "state_of_charge", "navigation", "speed_m_s",
                                           "start",  "detail",          "carrier",    "swap",
                                           "swap_s", "inspection",      "intensity"};

/// One agent of a task, made into a vehicle of the scenario.
class AgentLayout {
 public:
  AgentLayout(const Config& agent, const std::optional<Config>& over, const MissionParts& parts,
              std::span<const WorkTurbine* const> turbines,
              std::span<const Triple<double>> stands_m)
      : agent_(agent),
        over_(over),
        parts_(parts),
        turbines_(turbines),
        stands_m_(stands_m),
        structures_(obstacles_of(parts.site)) {}

  ScenarioVehicle lay_out(const std::string& name, const std::vector<Assumption>& assumed,
                          bool by_sensors) {
    home_m_ = read_start();
    intensity_ = chosen_intensity();
    is_at_m_ = home_m_;
    clear_m_ = agent_.optional_number("clear_m", {0.2, 500}).value_or(2);
    start_down_m_ = home_m_.z;
    if (is_carried()) home_m_ = is_at_m_ = beside_stand(0);
    if (is_carried())
      go_by_carrier();
    else
      go_by_itself();
    vehicle_.name = name;
    if (!says("model").has("model"))
      agent_.refuse("model", "missing; name a vehicle of data/vehicles");
    vehicle_.model = says("model").text("model");
    vehicle_.start_m = to_micrometre(home_m_);
    vehicle_.heading_rad = to_micrometre(bearing_to_turbine() / degree) * degree;
    vehicle_.speed_m_s = says("speed_m_s").optional_number("speed_m_s", {0.01, 60});
    vehicle_.state_of_charge =
        says("state_of_charge").optional_number("state_of_charge", {0, 1}).value_or(1);
    vehicle_.navigates_by_sensors = read_navigation(says("navigation"), by_sensors);
    if (agent_.has("tether")) vehicle_.tether = tether();
    if (is_carried()) vehicle_.carrier = read_carrier(over_->child("carrier"));
    // A rehearsal asks for figures of a mission, in many futures.
    vehicle_.detail = vehicle_.tether && !says("detail").has("detail")
                          ? StepDetail::coarse
                          : read_detail(says("detail"));
    vehicle_.conduct = conduct(assumed);
    return std::move(vehicle_);
  }

 private:
  [[nodiscard]] bool is_carried() const { return !stands_m_.empty(); }
  /// In the water beside its carrier, at the depth of its start.
  [[nodiscard]] Triple<double> beside_stand(std::size_t turbine) const {
    return {stands_m_[turbine].x, stands_m_[turbine].y, start_down_m_};
  }

  /// The agent's entry in the mission if it has the key, else the task's.
  [[nodiscard]] const Config& says(const char* key) const {
    const bool is_own = agent_.has(key);  // read, whoever is heard
    return over_ && (over_->has(key) || !is_own) ? *over_ : agent_;
  }
  /// Of the mission, thinned as the caller wants it.
  [[nodiscard]] Intensity chosen_intensity() const {
    const auto said = over_ ? over_->optional_child("intensity") : std::nullopt;
    return thinned(said ? read_intensity(*said) : Intensity{}, parts_.thinned_by);
  }
  double bearing_to_turbine() const {
    const WorkTurbine& first = *turbines_.front();
    return std::atan2(first.east_m - home_m_.y, first.north_m - home_m_.x);
  }

  Triple<double> place_at(const Config& place, const WorkTurbine& turbine) const {
    const auto bearing = place.optional_number("bearing_deg", {-360, 360});
    return turbine.around(bearing ? *bearing * degree : turbine.landing_rad,
                          turbine.radius_m + place.number("distance_m", {0.2, 20e3}),
                          read_level(place, turbine));
  }
  Triple<double> read_start() const { return place_at(agent_.child("start"), *turbines_.front()); }

  [[nodiscard]] ScenarioVehicle::TetherStart tether() const {
    const Config tether = agent_.child("tether");
    const Config top = tether.child("top");
    ScenarioVehicle::TetherStart start;
    start.length_m = to_micrometre(tether.number("length_m", {10, 10000}));
    if (is_carried())
      (void)top.keys();
    else
      start.top_m = to_micrometre(place_at(top, *turbines_.front()));
    return start;
  }

  [[nodiscard]] Conduct conduct(const std::vector<Assumption>& assumed) const {
    const Config base = agent_.has("conduct") ? agent_.child("conduct") : nothing();
    // Said wrong in the task, it is refused where it stands.
    (void)read_conduct(base);
    base.expect_all_read();
    const Config said = over_ ? over_->merged_over(base, of_the_vehicle) : base;
    Conduct conduct = read_conduct(said);
    said.expect_all_read();
    if (!conduct.home_m) conduct.home_m = to_micrometre(home_m_);
    if (!said.has("clear_m")) conduct.clear_m = to_micrometre(clear_m_);
    if (!assumed.empty()) {
      if (said.has("assume")) said.refuse("assume", "found beside the mission's; keep one");
      conduct.assumed = assumed;
    }
    if (auto plan = inspection()) {
      if (conduct.inspection) said.refuse("inspection", "found beside the agent's own; keep one");
      conduct.inspection = std::move(plan);
    }
    return conduct;
  }

  /// What it inspects, laid out at each turbine.
  [[nodiscard]] std::optional<InspectionPlan> inspection() const {
    const auto base = agent_.optional_child("inspection");
    const auto over = over_ ? over_->optional_child("inspection") : std::nullopt;
    if (!base && !over) return std::nullopt;
    const Config& stated = over && (over->has("surfaces") || !base) ? *over : *base;
    std::vector<PlannedSurface> surfaces;
    for (const WorkTurbine* turbine : turbines_)
      for (const Config& entry : stated.children("surfaces")) {
        PlannedSurface surface = lay_out_surface(entry, parts_.site, *turbine);
        if (std::find(surfaces.begin(), surfaces.end(), surface) == surfaces.end())
          surfaces.push_back(std::move(surface));
      }
    const Config rest =
        (over ? *over : *base).merged_over(over && base ? *base : nothing(), {"surfaces"});
    InspectionPlan plan = read_inspection(rest, std::move(surfaces));
    rest.expect_all_read();
    return plan;
  }
  /// Of an entry that is not there.
  [[nodiscard]] Config nothing() const { return Config::of({}, agent_.name()); }

  void put(ScenarioTask task) { vehicle_.tasks.push_back(std::move(task)); }
  void go_to(const Triple<double>& to_m, Phase phase) {
    if (length_of(to_m - is_at_m_) < 0.1) return;
    put(route_task(way_round(is_at_m_, to_m, near(is_at_m_, to_m), clear_m_), phase));
    is_at_m_ = to_m;
  }

  /// What stands by the way; the rest would only cost.
  std::vector<Structure> near(const Triple<double>& from_m, const Triple<double>& to_m) const {
    std::vector<Structure> some;
    for (const Structure& structure : structures_)
      if (least_distance_m(structure, from_m, to_m) < 2 * clear_m_) some.push_back(structure);
    return some;
  }

  /// Of launch, recovery and swap; absent: at once.
  [[nodiscard]] double time_s(const char* key) const {
    const Config& said = over_ && has_seconds(*over_, key) ? *over_ : agent_;
    return has_seconds(said, key) ? read_seconds(said, key, {0, 86400}) : 0;
  }
  [[nodiscard]] bool gets_batteries() const {
    return has_seconds(agent_, "swap") || (over_ && has_seconds(*over_, "swap"));
  }
  [[nodiscard]] std::vector<Config> works() const {
    std::vector<Config> works = agent_.children("work");
    if (works.empty())
      agent_.refuse("work", "missing; a task has work, each entry a pattern (work_pattern.h)");
    return works;
  }

  /// Turbine by turbine from the deck of a vessel. It gets its batteries while it is carried, and
  /// where its task says so between the parts of its work.
  void go_by_carrier() {
    const bool is_swapped = gets_batteries();
    const double swap_s = time_s("swap"), launch_s = time_s("launch"),
                 recovery_s = time_s("recovery");
    const std::vector<Config> works = this->works();
    for (std::size_t i = 0; i < turbines_.size(); ++i) {
      const bool is_first = i == 0;
      put(carried_task(is_first ? 0 : swap_s, !is_first && is_swapped));
      put(aboard_task(launch_s, false, Phase::launch));
      home_m_ = is_at_m_ = beside_stand(i);
      for (std::size_t w = 0; w < works.size(); ++w) {
        if (w > 0 && has_seconds(agent_, "swap")) {
          go_to(home_m_, Phase::return_home);
          put(aboard_task(swap_s, true, Phase::recovery));
        }
        work_on(twin::lay_out(works[w], parts_.site, *turbines_[i], intensity_));
      }
      go_to(home_m_, Phase::return_home);
      put(aboard_task(recovery_s, false, Phase::recovery));
    }
    home_m_ = beside_stand(0);
  }

  void go_by_itself() {
    const bool stands_aboard = gets_batteries();
    const double swap_s = time_s("swap"), launch_s = time_s("launch"),
                 recovery_s = time_s("recovery");
    const std::vector<Config> works = this->works();
    if (stands_aboard)
      put(aboard_task(launch_s, false, Phase::launch));
    else if (launch_s > 0)
      put(hold_task(launch_s, Phase::launch));
    bool is_first = true;
    for (const WorkTurbine* turbine : turbines_) {
      for (const Config& work : works) {
        if (!is_first && stands_aboard) {
          go_to(home_m_, Phase::return_home);
          put(aboard_task(swap_s, true, Phase::recovery));
        }
        is_first = false;
        work_on(twin::lay_out(work, parts_.site, *turbine, intensity_));
      }
    }
    go_to(home_m_, Phase::return_home);
    if (stands_aboard)
      put(aboard_task(recovery_s, false, Phase::recovery));
    else if (recovery_s > 0)
      put(hold_task(recovery_s, Phase::recovery));
  }

  void work_on(const std::vector<WorkLeg>& legs) {
    bool is_first = true;
    for (const WorkLeg& leg : legs) {
      if (is_first) go_to(leg.waypoints.front().position_m, Phase::transit);
      is_first = false;
      put(route_task(clear_of_piles(leg.waypoints), Phase::work, leg.drifts));
      is_at_m_ = leg.waypoints.back().position_m;
      if (leg.stay_s > 0) put(hold_task(leg.stay_s, Phase::work));
    }
  }

  /// Legs that would lead through something that stands there go round it.
  std::vector<Waypoint> clear_of_piles(const std::vector<Waypoint>& leg) const {
    std::vector<Waypoint> way;
    for (const Waypoint& at : leg) {
      std::vector<Structure> crossed;
      if (!way.empty())
        for (const Structure& structure : structures_)
          if (least_distance_m(structure, way.back().position_m, at.position_m) < 0)
            crossed.push_back(structure);
      if (crossed.empty()) {
        way.push_back(at);
        continue;
      }
      const Triple<double> from_m = way.back().position_m;
      for (const Waypoint& round :
           way_round(from_m, at.position_m, crossed, clear_m_, at.speed_m_s))
        way.push_back(round);
    }
    return way;
  }

  const Config& agent_;
  const std::optional<Config>& over_;
  const MissionParts& parts_;
  std::span<const WorkTurbine* const> turbines_;
  std::span<const Triple<double>> stands_m_;
  std::vector<Structure> structures_;
  Triple<double> home_m_;
  Triple<double> is_at_m_;
  Intensity intensity_;
  double start_down_m_ = 0;
  double clear_m_ = 2;
  ScenarioVehicle vehicle_;
};

}  // namespace

ScenarioVehicle lay_out_agent(const std::string& name, const Config& agent,
                              const std::optional<Config>& over, const MissionParts& parts,
                              std::span<const WorkTurbine* const> turbines,
                              std::span<const Triple<double>> stands_m,
                              const std::vector<Assumption>& assumed, bool by_sensors) {
  return AgentLayout(agent, over, parts, turbines, stands_m).lay_out(name, assumed, by_sensors);
}

}  // namespace slackwater::twin
