#include "twin/thruster/read_propeller.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/thruster/read_open_water.h"

namespace slackwater::twin {
namespace {

constexpr Range coefficient_range{1e-5, 0.025};  ///< T/(rho D^4 w^2), w in rad/s

/// Of T/w^2 in N and rad/s.
double read_thrust_n_s2(const Config& c, std::string_view key, double unit) {
  const double thrust_n_s2 = c.number(key, {1e-9, 1e6});
  const double coefficient = thrust_n_s2 / unit;
  constexpr double least = 5e-4;  // below it stands T/w^2 of turns per minute
  if (!(coefficient >= least && coefficient <= coefficient_range.high))
    c.refuse(key, formatted("makes a thrust coefficient of {:.3g} per rad2, where propellers have "
                            "{:g} to {:g}; give T/w^2 in N and rad/s, and the diameter in metres",
                            coefficient, least, coefficient_range.high));
  return thrust_n_s2;
}

/// Where the thrust goes with the square of the shaft's speed, whatever flow it meets.
void read_square_law(const Config& c, double diameter_m, double density_kg_m3,
                     Propeller& propeller) {
  const double unit = density_kg_m3 * std::pow(diameter_m, 4);
  for (const char* key :
       {"wake_fraction", "thrust_deduction", "torque_share", "astern", "motor_efficiency"})
    if (c.has(key))
      c.refuse(key, "goes with open_water; a thrust by the square of the speed knows no flow");
  if (c.has("thrust_n_s2")) {
    propeller.thrust_n_s2 = read_thrust_n_s2(c, "thrust_n_s2", unit);
  } else {
    // Of T = Kt rho D^4 w^2 with w in rad/s: that of n in 1/s over 4 pi^2.
    propeller.thrust_n_s2 = c.number("thrust_coefficient_per_rad2", coefficient_range) *
                            density_kg_m3 * std::pow(diameter_m, 4);
  }
  if (c.has("astern_thrust_n_s2")) {
    if (c.has("astern_share"))
      c.refuse("astern_share", "astern_thrust_n_s2 says it already; leave one of the two out");
    propeller.astern_thrust_n_s2 = read_thrust_n_s2(c, "astern_thrust_n_s2", unit);
  } else {
    propeller.astern_thrust_n_s2 =
        c.optional_number("astern_share", {0.05, 1.5}).value_or(1) * propeller.thrust_n_s2;
  }
  propeller.efficiency = c.number("efficiency", efficiency_range);
}

void read_by_open_water(const Config& c, double diameter_m, double density_kg_m3,
                        Propeller& propeller) {
  propeller.open_water = read_open_water(c, diameter_m, density_kg_m3);
  const OpenWater& water = propeller.open_water;
  if (c.has("astern_thrust_n_s2"))
    c.refuse("astern_thrust_n_s2", "beside open_water give astern or astern_share");
  propeller.thrust_n_s2 = water.thrust_share * water.step.front();
  propeller.astern_thrust_n_s2 = water.thrust_share * water.step[4 * water.ahead_ratio.count];
  if (water.has_torque && c.has("efficiency"))
    c.refuse("efficiency",
             "K_Q says what the shaft takes; give motor_efficiency, that over the power drawn");
  if (!water.has_torque && c.has("motor_efficiency"))
    c.refuse("motor_efficiency",
             "without K_Q nobody knows what the shaft takes; give K_Q, or efficiency, the power of "
             "a loss-free disc over the power drawn");
  propeller.efficiency =
      c.number(water.has_torque ? "motor_efficiency" : "efficiency", efficiency_range);
}

}  // namespace

double disc_area_m2(double diameter_m) { return constants::pi * diameter_m * diameter_m / 4; }

double read_full_speed_voltage(const Config& c) {
  return c.optional_number("full_speed_voltage_v", {1, 2000}).value_or(0);
}

void read_propeller(const Config& c, Thruster& thruster) {
  Propeller& propeller = thruster.propeller;
  const double diameter_m = c.number("propeller_diameter_m", diameter_range);
  const double density = c.optional_number("fluid_density_kg_m3", {0.5, 1100})
                             .value_or(constants::sea_water_density_kg_m3);
  propeller.disc_kg_m = 2 * density * disc_area_m2(diameter_m);
  const int given = int{c.has("thrust_coefficient_per_rad2")} + int{c.has("thrust_n_s2")} +
                    int{c.has("open_water")};
  if (given != 1)
    c.refuse("kind", formatted("found {} of thrust_coefficient_per_rad2, thrust_n_s2 and "
                               "open_water; give one",
                               given == 0 ? "none" : std::to_string(given)));
  if (c.has("open_water"))
    read_by_open_water(c, diameter_m, density, propeller);
  else
    read_square_law(c, diameter_m, density, propeller);
  propeller.most_rad_s = c.number("most_shaft_rad_s", shaft_speed_range);
  propeller.most_astern_rad_s =
      c.optional_number("most_astern_shaft_rad_s", {0, 1e4}).value_or(propeller.most_rad_s);
  propeller.full_speed_voltage_v = read_full_speed_voltage(c);
  thruster.least_command = -propeller.most_astern_rad_s;
  thruster.most_command = propeller.most_rad_s;
}

}  // namespace slackwater::twin
