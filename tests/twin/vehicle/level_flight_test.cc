#include "twin/vehicle/level_flight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/body/mass_matrix.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::level_flight_test {
namespace {

const std::pair<std::string, std::string> fixed_mass{"travel_m: 0.03", "travel_m: 0"};

/// Hull, passive fins and the moment of the added mass.
Vehicle lrauv() { return tests::changed_vehicle("lrauv_tethys", {fixed_mass}); }

/// With everything that bodies can have beside that.
Vehicle lrauv_with_more() {
  return tests::changed_vehicle(
      "lrauv_tethys",
      {fixed_mass,
       {"  Z_w_abs_w: -601.27\n", "  Z_w: -12\n  M_w: 3\n  M_w_abs_w: 1.5\n"},
       {"drag_stations: {along: length, count: 5}\n",
        "drag_stations: {along: length, count: 5}\n"
        "lift: {Z_uw: -40, M_uw: -20, Z_uq: -9, M_uq: -8}\n"
        "cross_flow: {from_x_m: -1.1, to_x_m: 1, strips: 5, "
        "heave: {drag_coefficient: 1.1, breadth_m: [0.2, 0.3, 0.3, 0.3, 0.1]}}\n"}});
}

/// What the equations of the step leave over of force and moment on that way, with a weight at the
/// origin that makes its net buoyancy what is borne.
Spatial<double> left_over(const Vehicle& vehicle, const LevelFlight& flight, double speed_m_s) {
  const Body& body = vehicle.body;
  const double net_n = constants::gravity_m_s2 *
                       (body.fluid_density_kg_m3 * body.displaced_volume_m3 - body.mass_kg);
  BodyState<double> way;
  way.position_m.z = 100;
  way.attitude = attitude_of({0, flight.pitch_rad, 0});
  way.nu.linear = {speed_m_s, 0, speed_m_s * std::tan(flight.pitch_rad)};
  Forcing<double> forcing;
  forcing.tau = fins_force(vehicle, way.nu, 0.0, flight.elevator_rad);
  forcing.tau.linear =
      forcing.tau.linear + (net_n - flight.borne_n) * rotation_of(way.attitude).down;
  return sum_of(body.rigid_mass, body.added_mass) * acceleration(body, way, forcing);
}

TEST(LevelFlight, LeavesTheEquationsOfTheStepNoForceAndNoMoment) {
  for (const Vehicle& vehicle : {lrauv(), lrauv_with_more()}) {
    int held = 0;
    for (const double speed_m_s : {0.3, 1.0, 2.0})
      for (const double down_m_s : {-0.05, -0.01, 0.0, 0.02, 0.04}) {
        const LevelFlight flight = level_flight_at(vehicle, speed_m_s, down_m_s);
        if (!flight.is_held) continue;  // stalled: another lift than was asked for
        ++held;
        // The step's fins have 1e-9 m/s added to their speed, for one at rest.
        const Spatial<double> rest = left_over(vehicle, flight, speed_m_s);
        EXPECT_NEAR(rest.linear.z, 0, 1e-7) << speed_m_s << " " << down_m_s;
        EXPECT_NEAR(rest.angular.y, 0, 1e-7) << speed_m_s << " " << down_m_s;
      }
    EXPECT_GT(held, 8);
  }
}

TEST(LevelFlight, GoesBowDownWhereItIsLightAndBearsWhatItIsAskedTo) {
  for (const Vehicle& vehicle : {lrauv(), lrauv_with_more()})
    for (const double net_n : {4.0, -4.0}) {
      const LevelFlight flight = level_flight(vehicle, 1, net_n);
      EXPECT_TRUE(flight.is_held);
      EXPECT_NEAR(flight.borne_n, net_n, 1e-9);
      EXPECT_LT(flight.pitch_rad * net_n, 0);
    }
}

TEST(LevelFlight, BearsNoMoreThanItsElevatorHolds) {
  const Vehicle vehicle = lrauv();
  Vehicle weak = vehicle;
  weak.elevator.limit_rad = 0.05;
  const LevelFlight strong_one = strongest_level_flight(vehicle, 1, 1);
  const LevelFlight weak_one = strongest_level_flight(weak, 1, 1);
  EXPECT_LT(weak_one.borne_n, 0.8 * strong_one.borne_n);
  EXPECT_LE(std::abs(weak_one.elevator_rad), 0.05);
  // Asked for more, it says what that would take.
  const LevelFlight asked = level_flight(weak, 1, 1.1 * weak_one.borne_n);
  EXPECT_FALSE(asked.is_held);
  EXPECT_NEAR(asked.borne_n, 1.1 * weak_one.borne_n, 1e-9);
  EXPECT_GT(std::abs(asked.elevator_rad), 0.05);
  // And asked for what no pitch bears, the most that it has.
  EXPECT_EQ(level_flight(vehicle, 1, 1e4).borne_n, strong_one.borne_n);
}

}  // namespace
}  // namespace slackwater::twin::level_flight_test
