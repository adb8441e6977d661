#pragma once
#include <nlohmann/json.hpp>

#include "api/door/people/action.h"
#include "api/door/people/farm_output.h"
#include "api/door/people/helms.h"
#include "api/door/people/vehicle_now.h"
#include "api/log/action_json.h"

namespace slackwater::people {

// What stations are told in JSON; api/docs/session_wire.md has its table.

[[nodiscard]] nlohmann::json place_json(const twin::Triple<double>& ned_m);
[[nodiscard]] nlohmann::json seat_json(const Seat& seat);
[[nodiscard]] nlohmann::json vehicle_json(const twin::Agent& agent, std::size_t place,
                                          const VehicleNow& now);
[[nodiscard]] nlohmann::json structure_json(const twin::Structure& structure, std::size_t place);
using api::action_json;

/// The waves of a run: [a m, k east, k north rad/m, omega rad/s, phase rad] each, so that a station
/// has the surface as the vehicles do. Null: a calm sea.
[[nodiscard]] nlohmann::json sea_json(const SeaRealisation* sea);
/// What wind, waves and current of a run are of: {forecast}, its name; null where they are made up.
[[nodiscard]] nlohmann::json water_json(const api::ScenarioWater& water);
/// Where the turbines of a site stand. Null: it has none.
[[nodiscard]] nlohmann::json turbines_json(const std::optional<twin::StandingTurbines>& turbines);
/// Power against wind of a turbine, [[wind m/s, power W]], from calm to beyond cut-out.
[[nodiscard]] nlohmann::json curve_json(const Turbine& kind);
/// A tether as it hangs: [east, north, up m] each node.
[[nodiscard]] nlohmann::json line_json(std::size_t vehicle, const VehicleNow& now);
/// What its thrusters do.
[[nodiscard]] nlohmann::json thrust_json(std::size_t vehicle, const VehicleNow& now);
/// The same in brief: [vehicle, share, ...], shares in hundredths.
[[nodiscard]] nlohmann::json thrust_row_json(std::size_t vehicle, const VehicleNow& now);
[[nodiscard]] nlohmann::json traffic_json(const Surroundings& around);
/// @param led_by  who leads it; empty: nobody
[[nodiscard]] nlohmann::json weather_json(const Surroundings& around, double time_s,
                                          const std::optional<FarmNow>& farm,
                                          const std::string& led_by);

/// A helm as it is shown: the same until something of it changes.
struct ShownHelm {
  HelmNow helm;
  twin::HelmMode mode{};
  twin::HelmCause cause{};
  std::optional<Milliseconds> home_at;
  bool operator==(const ShownHelm&) const = default;
};
[[nodiscard]] nlohmann::json helm_json(std::size_t vehicle, const ShownHelm& shown);

/// Whether two statuses differ in what is told at once; the reserve waits for its second.
[[nodiscard]] nlohmann::json status_json(std::size_t vehicle, const VehicleNow& now);

/// What of a status changes each second: [vehicle, reserve, margin_s].
[[nodiscard]] nlohmann::json reserve_json(std::size_t vehicle, const VehicleNow& now);

/// Compact; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string text_of(const nlohmann::json& json);

}  // namespace slackwater::people
