#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/mission/work_site.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// The vehicles that a mission has beside the agents of its tasks, and those of them that carry an
/// agent from turbine to turbine:
///
///     agents:
///       surveyor: {carrier: {name: tender, forward_m: -4, starboard_m: 6, up_m: 2}}
///     vehicles:
///       - {name: tender, model: ctv24, speed_m_s: 4, stands: {bearing_deg: 180, distance_m: 25}}
///
/// A carrier stands by at each turbine, at a bearing and distance from the face of its foundation
/// (absent: where the agent's task has the top of its tether, else its start), and goes from one to
/// the next round what stands there. With a `start` it comes from there and goes back; without one
/// it begins at its first place and stays at its last.
class Tenders {
 public:
  Tenders(const Config& mission, const WorkSite& site,
          std::span<const WorkTurbine* const> turbines);

  /// Where the carrier of an agent stands by, turbine by turbine; nothing for one without.
  /// @throws Error(invalid_input) for a carrier that the mission does not have, or that has tasks
  ///         of its own, and for a tether without a carrier at several turbines
  const std::vector<Triple<double>>& taken_by(const std::string& role, const Config& agent,
                                              const std::optional<Config>& over);

  /// All of the vehicles, in the order of the mission. @param by_sensors  see `read_vehicle`
  [[nodiscard]] std::vector<ScenarioVehicle> vehicles(bool by_sensors) const;

 private:
  [[nodiscard]] std::vector<Triple<double>> stands_at(const Config& place) const;
  /// Its way from place to place.
  void lay_out(const std::vector<Triple<double>>& stands_m, ScenarioVehicle& carrier) const;

  const Config& mission_;
  const WorkSite& site_;
  std::span<const WorkTurbine* const> turbines_;
  std::vector<Config> vehicles_;
  std::map<std::string, std::vector<Triple<double>>> stands_m_;  ///< of those that carry
};

}  // namespace slackwater::twin
