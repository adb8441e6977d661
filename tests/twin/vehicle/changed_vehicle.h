#pragma once
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"

namespace slackwater::tests {

/// Text to be found and what stands in its place.
using Changes = std::vector<std::pair<std::string, std::string>>;

inline twin::Vehicle changed_vehicle(const std::string& id, const Changes& changes) {
  std::ifstream file(source_folder() / "data/vehicles" / (id + ".yaml"));
  std::ostringstream text;
  text << file.rdbuf();
  std::string yaml = text.str();
  for (const auto& [found, instead] : changes) {
    const std::size_t at = yaml.find(found);
    EXPECT_NE(at, std::string::npos) << found;
    if (at != std::string::npos) yaml.replace(at, found.size(), instead);
  }
  const TemporaryFolder folder;
  std::ofstream(folder / "made-up.yaml") << yaml;
  return twin::read_vehicle(folder / "made-up.yaml", source_folder() / "data");
}

/// What is said against it.
inline std::string refusal_of(const std::string& id, const Changes& changes) {
  try {
    (void)changed_vehicle(id, changes);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

inline const std::string lrauv_fins = R"(fins:
  area_m2: 0.0244
  position_x_m: -1.05
  lift_slope_per_rad: 4.13
  drag_factor: 0.069
  stall_rad: 0.17
  limit_rad: 0.261799
  rate_rad_s: 0.35
)";
inline const std::string lrauv_thruster = R"(thruster:
  kind: propeller
  propeller_diameter_m: 0.2
  thrust_coefficient_per_rad2: 0.004312328425753156
  efficiency: 0.565
  most_shaft_rad_s: 31.416
  full_speed_voltage_v: 11.0
  rise_time_constant_s: 0.5
  fall_time_constant_s: 0.5
)";
inline const std::string lrauv_mount = "  - {position_m: [-1.43162, 0, 0], direction: [1, 0, 0]}\n";

/// Fins of Prestero's REMUS (2001), table of the fins.
inline const std::string prestero_rudder =
    "rudder: {Y_uu_delta_r: 9.64, N_uu_delta_r: -6.15, limit_rad: 0.237, rate_rad_s: 0.5}\n";
inline const std::string prestero_elevator =
    "elevator: {Z_uu_delta_s: -9.64, M_uu_delta_s: -6.15, limit_rad: 0.237, rate_rad_s: 0.5}\n";

/// An LRAUV with a propeller whose open water is known, tunnel thrusters beside it, and a rudder
/// and an elevator unlike each other.
inline twin::Vehicle lrauv_of_all_kinds() {
  return changed_vehicle(
      "lrauv_tethys",
      {{lrauv_thruster, R"(thrusters:
  main:
    kind: propeller
    propeller_diameter_m: 0.2
    open_water: {K_T: [0.45, -0.35, -0.05], K_Q: [0.06, -0.03, -0.02], most_J: 1.0}
    astern: {J: [0, 0.3, 0.6], K_T: [0.3, 0.25, -0.02], K_Q: [0.06, 0.05, 0.01]}
    wake_fraction: 0.06
    thrust_deduction: 0.1
    torque_share: 0.5
    motor_efficiency: 0.8
    most_shaft_rad_s: 40
    most_astern_shaft_rad_s: 30
    rise_time_constant_s: 0.5
    fall_time_constant_s: 0.4
  tunnel:
    kind: propeller
    propeller_diameter_m: 0.1
    thrust_n_s2: 0.0005
    astern_thrust_n_s2: 0.0003
    efficiency: 0.4
    most_shaft_rad_s: 100
    rise_time_constant_s: 0.1
    fall_time_constant_s: 0.2
)"},
       {lrauv_mount,
        R"(  - {thruster: main, name: propeller, position_m: [-1.43162, 0, 0], direction: [1, 0, 0]}
  - {thruster: tunnel, name: bow_tunnel, position_m: [0.9, 0, 0], direction: [0, 1, 0]}
  - {thruster: tunnel, position_m: [-0.9, 0, 0], direction: [0, 0, 1], turns: counterclockwise}
)"},
       {lrauv_fins,
        "rudder: {Y_uu_delta_r: 51, N_uu_delta_r: -54, "
        "limit_rad: 0.3, rate_rad_s: 0.5, lag_s: 0.2}\n"
        "elevator: {area_m2: 0.02, position_x_m: -0.9, "
        "lift_slope_per_rad: 3, passive_lift_slope_per_rad: "
        "4.2, drag_factor: 0.1, stall_rad: 0.2, limit_rad: "
        "0.26, rate_rad_s: 0.35, lag_s: 0.1}\n"}});
}

}  // namespace slackwater::tests
