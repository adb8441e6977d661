#include "twin/vehicle/level_flight.h"

#include <algorithm>
#include <cmath>

#include "twin/body/body_dynamics.h"

namespace slackwater::twin {
namespace {

constexpr int pitches = 200;  ///< that are looked at, from level to the steepest

/// How steeply it may be pitched at a speed, as the w of that.
double most_pitched_m_s(const Vehicle& vehicle, double speed_m_s) {
  const AutopilotSettings& s = vehicle.autopilot;
  const double most_m_s = s.most_speed_m_s > 0 ? s.most_speed_m_s : vehicle.cruise_speed_m_s;
  const double sine = std::min(std::tan(s.most_tilt_rad), 0.9);
  return std::min(sine * speed_m_s, 0.3 * most_m_s);
}

/// From level to its steepest pitch, until one is what is looked for.
template <typename Wanted>
void for_each_pitch(const Vehicle& vehicle, double speed_m_s, double net_buoyancy_n,
                    const Wanted& wanted) {
  // A light one goes bow down.
  const double most_m_s = std::copysign(most_pitched_m_s(vehicle, speed_m_s), -net_buoyancy_n);
  for (int i = 0; i <= pitches; ++i)
    if (wanted(level_flight_at(vehicle, speed_m_s, most_m_s * i / pitches))) return;
}

}  // namespace

LevelFlight level_flight_at(const Vehicle& vehicle, double speed_m_s, double down_m_s) {
  const Body& body = vehicle.body;
  LevelFlight flight;
  flight.pitch_rad = std::atan2(down_m_s, speed_m_s);
  const Rotation<double> r = rotation_of(attitude_of({0, flight.pitch_rad, 0}));
  const Spatial<double> nu{{speed_m_s, 0, down_m_s}, {}};
  Spatial<double> of_water =
      lift_of_hull(body, nu) - coriolis(body.added_mass, nu) - damping<double>(body, r, nu, {});
  if (body.has_more()) of_water = of_water + lift_and_cross_flow<double>(body, r, nu, {});
  const double moment_n_m = of_water.angular.y + restoring<double>(body, r, 1, 0, 0).angular.y;
  const double most_trim_n_m = vehicle.trim.moving_mass_kg * constants::gravity_m_s2 *
                               vehicle.trim.travel_m * std::cos(flight.pitch_rad);
  // What is left for the elevator, whose lift points down and stands aft.
  const double by_fins_n_m = -(moment_n_m - std::clamp(moment_n_m, -most_trim_n_m, most_trim_n_m));
  const FinPair& fins = vehicle.elevator;
  const double square_m2_s2 = dot(nu.linear, nu.linear);
  const double passive_rad = fins.passive_share * down_m_s / std::sqrt(square_m2_s2);
  const double slope_n =
      0.5 * body.fluid_density_kg_m3 * fins.area_m2 * fins.lift_slope_per_rad * square_m2_s2;
  double lift_n = 0;
  if (slope_n > 0 && fins.position_x_m < 0) {
    lift_n = by_fins_n_m / -fins.position_x_m;
    const double angle_rad = lift_n / slope_n;
    flight.elevator_rad = angle_rad + passive_rad;
    flight.is_held =
        std::abs(angle_rad) <= fins.stall_rad && std::abs(flight.elevator_rad) <= fins.limit_rad;
  } else {
    flight.is_held = by_fins_n_m == 0;
  }
  flight.borne_n = (of_water.linear.z + lift_n) / std::cos(flight.pitch_rad);
  return flight;
}

LevelFlight strongest_level_flight(const Vehicle& vehicle, double speed_m_s, double way) {
  LevelFlight strongest;
  for_each_pitch(vehicle, speed_m_s, way, [&](const LevelFlight& flight) {
    if (flight.is_held && flight.borne_n * way > strongest.borne_n * way) strongest = flight;
    return false;
  });
  return strongest;
}

LevelFlight level_flight(const Vehicle& vehicle, double speed_m_s, double net_buoyancy_n) {
  LevelFlight before, first;
  bool is_found = false;
  for_each_pitch(vehicle, speed_m_s, net_buoyancy_n, [&](const LevelFlight& flight) {
    is_found = flight.borne_n * net_buoyancy_n >= net_buoyancy_n * net_buoyancy_n;
    (is_found ? first : before) = flight;
    return is_found;
  });
  if (!is_found) return strongest_level_flight(vehicle, speed_m_s, net_buoyancy_n);
  double low_m_s = speed_m_s * std::tan(before.pitch_rad);
  double high_m_s = speed_m_s * std::tan(first.pitch_rad);
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle_m_s = 0.5 * (low_m_s + high_m_s);
    first = level_flight_at(vehicle, speed_m_s, middle_m_s);
    (first.borne_n * net_buoyancy_n < net_buoyancy_n * net_buoyancy_n ? low_m_s : high_m_s) =
        middle_m_s;
  }
  return first;
}

}  // namespace slackwater::twin
