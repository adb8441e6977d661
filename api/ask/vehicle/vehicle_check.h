#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "twin/account/manoeuvre_account.h"
#include "twin/handling/kept_course.h"
#include "twin/step/open_loop.h"
#include "twin/step/plane_modes.h"
#include "twin/vehicle/balance.h"
#include "twin/vehicle/level_flight.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::api {

/// A vehicle that goes straight ahead through still water, or air, at one speed.
struct AtSpeed {
  double speed_m_s = 0;
  bool is_cruise = false;
  bool is_top = false;
  double power_w = 0;  ///< with its hotel load
  // Of one with a battery: from full until it is cut off at that power.
  std::optional<double> lasts_s;
  std::optional<double> range_m;
  // Of what swims and floats.
  std::optional<twin::PlaneModes> modes;   ///< with nobody at its controls
  std::optional<twin::KeptCourse> course;  ///< under its own autopilot
  std::optional<twin::LevelFlight> level;  ///< of an AUV
};

/// A standard manoeuvre that was flown in still water, or why it was not.
struct FlownManoeuvre {
  std::string name;  ///< "turning circle", "zig-zag 10/10", ...
  std::optional<twin::ManoeuvreAccount> account;
  std::string why_not;
  std::vector<twin::ManoeuvreRow> rows;  ///< the way of it, every step of the log
};

/// What a vehicle's file makes of it.
struct VehicleCheck {
  std::filesystem::path file;
  twin::Vehicle vehicle;  ///< with its warnings
  twin::Balance balance;  ///< of what swims and floats
  double top_speed_m_s = 0;
  std::vector<AtSpeed> speeds;             ///< rising
  twin::OpenLoop open_loop;                ///< of what swims and floats
  std::vector<FlownManoeuvre> manoeuvres;  ///< of what swims and floats

  [[nodiscard]] bool flies() const noexcept { return vehicle.kind == twin::VehicleKind::uav; }
  [[nodiscard]] bool floats() const noexcept { return vehicle.body.hull.strips > 0; }
};

/// Reads a vehicle as a run does, and flies it: a turning circle with all the helm that it has,
/// zig-zags 10/10 and 20/20, and steps of speed, heading and depth, each begun at its cruise speed
/// in still water of 100 m. A craft without a rudder has a share of its yaw moment for a helm, as
/// many 35ths as degrees of the rudder of a ship, as far as the thrust of that speed leaves room.
/// @param model  of the catalogue, or a file
/// @throws Error(invalid_input) for a vehicle that no run takes, saying why
/// Cost: some seconds.
[[nodiscard]] VehicleCheck check_vehicle(const std::string& model,
                                         const std::filesystem::path& data_folder);

}  // namespace slackwater::api
