#include "twin/vehicle/read_fins.h"

#include <cmath>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr Range area_range{1e-5, 100};
constexpr Range position_range{-100, 100};
constexpr Range slope_range{0.1, 2 * constants::pi};
constexpr Range passive_slope_range{0, 2 * constants::pi};
constexpr Range stall_range{0.01, 0.8};
constexpr Range limit_range{0.01, 1.2};
constexpr Range drag_factor_range{0, 2};

/// The derivatives of force and moment by the deflection, SNAME, over the square of the speed.
struct DeflectionKeys {
  const char* force;
  const char* moment;
  double lever_way;  ///< x = lever_way moment/force: the moment of a lift is +x Y or -x Z
};
constexpr DeflectionKeys rudder_keys{"Y_uu_delta_r", "N_uu_delta_r", 1};
constexpr DeflectionKeys elevator_keys{"Z_uu_delta_s", "M_uu_delta_s", -1};

void read_area_and_slope(const Config& c, FinPair& fins) {
  fins.area_m2 = c.number("area_m2", area_range);
  fins.position_x_m = c.number("position_x_m", position_range);
  fins.lift_slope_per_rad = c.number("lift_slope_per_rad", slope_range);
  fins.drag_factor = c.number("drag_factor", drag_factor_range);
  fins.stall_rad = c.number("stall_rad", stall_range);
  if (const auto passive = c.optional_number("passive_lift_slope_per_rad", passive_slope_range))
    fins.passive_share = *passive / fins.lift_slope_per_rad;
}

/// Whichever way the source counts its angles: force and moment say where the fins stand, aft.
void read_derivatives_of_fins(const Config& c, const DeflectionKeys& keys, double density_kg_m3,
                              FinPair& fins) {
  for (const char* key : {"position_x_m", "lift_slope_per_rad"})
    if (c.has(key))
      c.refuse(key, formatted("{} and {} say it; leave it out", keys.force, keys.moment));
  const double force = c.number(keys.force, {-1e6, 1e6});
  const double moment = c.number(keys.moment, {-1e8, 1e8});
  if (force == 0) c.refuse(keys.force, "found 0; fins that give no force are left out");
  fins.position_x_m = keys.lever_way * moment / force;
  if (!(fins.position_x_m < 0 && fins.position_x_m >= position_range.low))
    c.refuse(
        keys.moment,
        formatted("{:g} over a force of {:g} puts the fins at x = {:g} m; expected them aft of "
                  "the origin, {} of {}. Check both signs and the units",
                  moment, force, fins.position_x_m,
                  keys.lever_way > 0 ? "the sign against that" : "with the sign", keys.force));
  const double of_pair_m2 = 2 * std::abs(force) / density_kg_m3;  // area times slope
  const auto area_m2 = c.optional_number("area_m2", area_range);
  const auto passive = c.optional_number("passive_lift_slope_per_rad", passive_slope_range);
  const auto drag_factor = c.optional_number("drag_factor", drag_factor_range);
  if (!area_m2 && (passive || drag_factor))
    c.refuse(passive ? "passive_lift_slope_per_rad" : "drag_factor",
             "is of the fins' own area; give area_m2 too");
  fins.area_m2 = area_m2.value_or(of_pair_m2);
  fins.lift_slope_per_rad = of_pair_m2 / fins.area_m2;
  if (area_m2 &&
      !(fins.lift_slope_per_rad >= slope_range.low && fins.lift_slope_per_rad <= slope_range.high))
    c.refuse("area_m2",
             formatted("makes a lift slope of {:.3g} per rad of {}; expected {:g} to "
                       "{:.3g}. Give the area of the pair in m2",
                       fins.lift_slope_per_rad, keys.force, slope_range.low, slope_range.high));
  fins.drag_factor = drag_factor.value_or(0);
  fins.passive_share = passive.value_or(0) / fins.lift_slope_per_rad;
  // Amidships they give nothing, and so have no angle but that of their deflection.
  if (fins.passive_share > 0 || c.has("stall_rad"))
    fins.stall_rad = c.number("stall_rad", stall_range);
  else
    fins.stall_rad = c.number("limit_rad", limit_range);
}

/// @param keys  of the derivatives it may have; none for two pairs in one
FinPair read_pair(const Config& c, const DeflectionKeys* keys, double density_kg_m3) {
  FinPair fins;
  if (keys != nullptr && (c.has(keys->force) || c.has(keys->moment)))
    read_derivatives_of_fins(c, *keys, density_kg_m3, fins);
  else
    read_area_and_slope(c, fins);
  fins.limit_rad = c.number("limit_rad", limit_range);
  fins.rate_rad_s = c.number("rate_rad_s", {0.001, 20});
  fins.lag_s = c.optional_number("lag_s", {0, 60}).value_or(0);
  return fins;
}

}  // namespace

void read_fins(const Config& config, Vehicle& vehicle) {
  const double density = vehicle.body.fluid_density_kg_m3;
  if (const auto both = config.optional_child("fins")) {
    for (const char* key : {"rudder", "elevator"})
      if (config.has(key))
        config.refuse(key, "`fins` describes both pairs; give rudder and elevator, or fins");
    vehicle.rudder = vehicle.elevator = read_pair(*both, nullptr, density);
    return;
  }
  if (const auto rudder = config.optional_child("rudder"))
    vehicle.rudder = read_pair(*rudder, &rudder_keys, density);
  if (const auto elevator = config.optional_child("elevator"))
    vehicle.elevator = read_pair(*elevator, &elevator_keys, density);
}

}  // namespace slackwater::twin
