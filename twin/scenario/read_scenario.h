#pragma once
#include <optional>
#include <string>

#include "fields/base/config.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

// Parts of a scenario that a mission has too. All throw Error(invalid_input) with file and line.

/// All but what stands and goes there: name, seed, times, place, water, waves, wind, traffic, log.
/// @param otherwise  the water of one that names none; absent: that is an error
[[nodiscard]] Scenario read_setting(const Config& config,
                                    const std::optional<ForecastWater>& otherwise);
/// An entry of `vehicles`. @param by_sensors  how it navigates where it does not say
[[nodiscard]] ScenarioVehicle read_vehicle(const Config& config, bool by_sensors);
/// What autopilots go by, `truth` or `sensors`: whether by these.
/// @param otherwise  where the file does not say
[[nodiscard]] bool read_navigation(const Config& config, bool otherwise);
[[nodiscard]] StepDetail read_detail(const Config& config);
[[nodiscard]] ScenarioVehicle::Carrier read_carrier(const Config& carrier);

/// What parts of a scenario cannot be beside one another.
struct ScenarioFault {
  std::optional<std::size_t> vehicle;  ///< absent: it is of none
  std::string key;
  std::string why;
};
/// The first that is found. Of a scenario that was read there is none.
[[nodiscard]] std::optional<ScenarioFault> fault_of(const Scenario& scenario);

}  // namespace slackwater::twin
