#include "twin/mission/agent_text.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/text.h"

#include "twin/mission/conduct.h"
#include "twin/mission/read_seconds.h"
#include "twin/mission/scenario_text.h"
#include "twin/mission/surface_text.h"
#include "twin/mission/way_round.h"
#include "twin/mission/work_pattern.h"

namespace slackwater::twin {
namespace {

using constants::degree;

std::vector<Structure> structures_of(const WorkSite& site) {
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
class AgentWriter {
 public:
  AgentWriter(const Config& agent, const std::optional<Config>& over, const MissionParts& parts,
              std::span<const WorkTurbine* const> turbines,
              std::span<const Triple<double>> stands_m)
      : agent_(agent),
        over_(over),
        parts_(parts),
        turbines_(turbines),
        stands_m_(stands_m),
        structures_(structures_of(parts.site)) {}

  /// @param assumed  as YAML on one line; empty: nothing is
  std::string write(const std::string& name, const std::string& assumed) {
    home_m_ = read_start();
    intensity_ = chosen_intensity();
    is_at_m_ = home_m_;
    clear_m_ = agent_.optional_number("clear_m", {0.2, 500}).value_or(2);
    has_tether_ = agent_.has("tether");
    start_down_m_ = home_m_.z;
    if (is_carried()) home_m_ = is_at_m_ = beside_stand(0);
    const std::string tasks = is_carried() ? write_carried_tasks() : write_tasks();
    std::string text = "  - name: " + quoted_yaml(name) + "\n    model: " + model() +
                       "\n    start: {" + place_text(home_m_) +
                       ", heading_deg: " + number_text(bearing_to_turbine() / degree) + "}\n";
    for (const char* key : {"speed_m_s", "state_of_charge", "navigation"})
      if (const auto value = chosen(key)) text += "    " + std::string(key) + ": " + *value + "\n";
    if (has_tether_) text += write_tether();
    if (is_carried()) text += "    carrier: " + over_->flow_yaml("carrier") + "\n";
    // A rehearsal asks for figures of a mission, in many futures.
    if (const auto detail = chosen("detail"); detail || has_tether_)
      text += "    detail: " + detail.value_or("coarse") + "\n";
    text += "    conduct: " + write_conduct(assumed) + "\n    tasks:\n" + tasks;
    return text;
  }

 private:
  [[nodiscard]] bool is_carried() const { return !stands_m_.empty(); }
  /// In the water beside its carrier, at the depth of its start.
  [[nodiscard]] Triple<double> beside_stand(std::size_t turbine) const {
    return {stands_m_[turbine].x, stands_m_[turbine].y, start_down_m_};
  }

  /// A value of the agent's entry in the mission, else of the task's, as YAML on one line.
  std::optional<std::string> chosen(const char* key) const {
    std::optional<std::string> value;
    if (agent_.has(key)) value = agent_.flow_yaml(key);
    if (over_ && over_->has(key)) value = over_->flow_yaml(key);
    return value;
  }
  /// Of the mission, thinned as the caller wants it.
  [[nodiscard]] Intensity chosen_intensity() const {
    const auto said = over_ ? over_->optional_child("intensity") : std::nullopt;
    return thinned(said ? read_intensity(*said) : Intensity{}, parts_.thinned_by);
  }
  std::string model() const {
    const auto value = chosen("model");
    if (!value) agent_.refuse("model", "missing; name a vehicle of data/vehicles");
    return *value;
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

  std::string write_tether() const {
    const Config tether = agent_.child("tether");
    if (is_carried()) {
      (void)tether.child("top").keys();
      return "    tether: {length_m: " + number_text(tether.number("length_m", {10, 10000})) +
             "}\n";
    }
    const Triple<double> top_m = place_at(tether.child("top"), *turbines_.front());
    return "    tether: {top: {" + place_text(top_m) +
           "}, length_m: " + number_text(tether.number("length_m", {10, 10000})) + "}\n";
  }

  std::string write_conduct(const std::string& assumed) const {
    const auto base = agent_.optional_child("conduct");
    // Said wrong in the task, it is refused where it stands.
    if (base) {
      (void)read_conduct(*base);
      base->expect_all_read();
    }
    const std::string conduct = merged(base, over_, of_the_vehicle);
    std::string text = conduct.substr(0, conduct.size() - 1) + (conduct.size() > 2 ? ", " : "");
    if (conduct.find("home: ") == std::string::npos)
      text += "home: {" + place_text(home_m_) + "}, ";
    if (conduct.find("clear_m: ") == std::string::npos)
      text += "clear_m: " + number_text(clear_m_) + ", ";
    if (!assumed.empty()) text += "assume: " + assumed + ", ";
    if (const std::string inspection = write_inspection(); !inspection.empty())
      text += "inspection: " + inspection + ", ";
    return text.substr(0, text.size() - 2) + "}";
  }

  /// What it inspects, laid out at each turbine; empty: nothing.
  std::string write_inspection() const {
    const auto base = agent_.optional_child("inspection");
    const auto over = over_ ? over_->optional_child("inspection") : std::nullopt;
    if (!base && !over) return "";
    const Config& stated = over && (over->has("surfaces") || !base) ? *over : *base;
    std::vector<std::string> surfaces;
    for (const WorkTurbine* turbine : turbines_)
      for (const Config& entry : stated.children("surfaces")) {
        std::string text = surface_text(entry, parts_.site, *turbine);
        if (std::find(surfaces.begin(), surfaces.end(), text) == surfaces.end())
          surfaces.push_back(std::move(text));
      }
    if (base && base->has("surfaces")) (void)base->flow_yaml("surfaces");
    const std::string rest = merged(base, over, {"surfaces"});
    return "{surfaces: [" + joined(surfaces, ", ") + "]" +
           (rest.size() > 2 ? ", " + rest.substr(1) : "}");
  }

  void go_to(const Triple<double>& to_m, Phase phase, std::string& text) {
    if (length_of(to_m - is_at_m_) < 0.1) return;
    text += route_text(way_round(is_at_m_, to_m, near(is_at_m_, to_m), clear_m_), phase);
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
  std::string write_carried_tasks() {
    const bool is_swapped = gets_batteries();
    const double swap_s = time_s("swap"), launch_s = time_s("launch"),
                 recovery_s = time_s("recovery");
    const std::vector<Config> works = this->works();
    std::string text;
    for (std::size_t i = 0; i < turbines_.size(); ++i) {
      const bool is_first = i == 0;
      text += carried_text(is_first ? 0 : swap_s, !is_first && is_swapped) +
              aboard_text(launch_s, false, Phase::launch);
      home_m_ = is_at_m_ = beside_stand(i);
      for (std::size_t w = 0; w < works.size(); ++w) {
        if (w > 0 && has_seconds(agent_, "swap")) {
          go_to(home_m_, Phase::return_home, text);
          text += aboard_text(swap_s, true, Phase::recovery);
        }
        write_work(lay_out(works[w], parts_.site, *turbines_[i], intensity_), text);
      }
      go_to(home_m_, Phase::return_home, text);
      text += aboard_text(recovery_s, false, Phase::recovery);
    }
    home_m_ = beside_stand(0);
    return text;
  }

  std::string write_tasks() {
    const bool stands_aboard = gets_batteries();
    const double swap_s = time_s("swap"), launch_s = time_s("launch"),
                 recovery_s = time_s("recovery");
    const std::vector<Config> works = this->works();
    std::string text;
    if (stands_aboard)
      text += aboard_text(launch_s, false, Phase::launch);
    else if (launch_s > 0)
      text += hold_text(launch_s, Phase::launch);
    bool is_first = true;
    for (const WorkTurbine* turbine : turbines_) {
      for (const Config& work : works) {
        if (!is_first && stands_aboard) {
          go_to(home_m_, Phase::return_home, text);
          text += aboard_text(swap_s, true, Phase::recovery);
        }
        is_first = false;
        write_work(lay_out(work, parts_.site, *turbine, intensity_), text);
      }
    }
    go_to(home_m_, Phase::return_home, text);
    if (stands_aboard)
      text += aboard_text(recovery_s, false, Phase::recovery);
    else if (recovery_s > 0)
      text += hold_text(recovery_s, Phase::recovery);
    return text;
  }

  void write_work(const std::vector<WorkLeg>& legs, std::string& text) {
    bool is_first = true;
    for (const WorkLeg& leg : legs) {
      if (is_first) go_to(leg.waypoints.front().position_m, Phase::transit, text);
      is_first = false;
      text += route_text(clear_of_piles(leg.waypoints), Phase::work, leg.drifts);
      is_at_m_ = leg.waypoints.back().position_m;
      if (leg.stay_s > 0) text += hold_text(leg.stay_s, Phase::work);
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
  bool has_tether_ = false;
};

}  // namespace

std::string agent_text(const std::string& name, const Config& agent,
                       const std::optional<Config>& over, const MissionParts& parts,
                       std::span<const WorkTurbine* const> turbines,
                       std::span<const Triple<double>> stands_m, const std::string& assumed) {
  return AgentWriter(agent, over, parts, turbines, stands_m).write(name, assumed);
}

}  // namespace slackwater::twin
