#pragma once
#include "tests/support/shared_data.h"
#include "twin/thruster/thruster.h"

namespace slackwater::tests {

[[nodiscard]] inline twin::Thruster thruster_from(const std::string& yaml) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  twin::Thruster thruster = twin::read_thruster(config, source_folder() / "data");
  config.expect_all_read();
  return thruster;
}

[[nodiscard]] inline twin::Thruster t200() { return thruster_from("model: t200"); }

/// The LRAUV's: 12 W at 1 m/s against its drag of 6.2282 N.
[[nodiscard]] inline twin::Thruster slow_propeller() {
  return thruster_from(R"(kind: propeller
propeller_diameter_m: 0.2
thrust_coefficient_per_rad2: 0.004312328425753156
efficiency: 0.565
most_shaft_rad_s: 35
rise_time_constant_s: 0.5
fall_time_constant_s: 0.5
full_speed_voltage_v: 11
)");
}

/// Of the REMUS 100 (Allen, Vorus & Prestero 2000; Fossen's fit): straight lines over J. With
/// `more` lines what else there is to say.
[[nodiscard]] inline twin::Thruster remus_propeller(const std::string& more = "") {
  return thruster_from(R"(kind: propeller
propeller_diameter_m: 0.14
open_water: {K_T: [0.4566, -0.41737], K_Q: [0.07, -0.0585], most_J: 1.09}
wake_fraction: 0.056
most_shaft_rad_s: 200
rise_time_constant_s: 1
fall_time_constant_s: 1
motor_efficiency: 0.8
)" + more);
}

/// The X500's.
[[nodiscard]] inline twin::Thruster quadrotor_rotor() {
  return thruster_from(R"(kind: rotor
propeller_diameter_m: 0.254
thrust_n_s2: 8.54858e-06
torque_arm_m: 0.016
drag_n_s2_m: 8.06428e-05
efficiency: 0.59
most_shaft_rad_s: 1000
full_speed_voltage_v: 14.8
rise_time_constant_s: 0.0125
fall_time_constant_s: 0.025
)");
}

/// An electric outboard of 250 N, and with `more` lines what else there is to say.
[[nodiscard]] inline twin::Thruster outboard(const std::string& more = "") {
  return thruster_from(R"(kind: drive
propeller_diameter_m: 0.2
efficiency: 0.677
most_thrust_n: 250
least_thrust_n: -100
rise_time_constant_s: 0.3
fall_time_constant_s: 0.3
)" + more);
}

}  // namespace slackwater::tests
