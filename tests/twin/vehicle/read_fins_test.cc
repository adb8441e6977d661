#include "tests/support/contains.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::read_fins_test {
namespace {

using tests::changed_vehicle;
using tests::contains;
using tests::lrauv_fins;
using tests::prestero_elevator;
using tests::prestero_rudder;

Vehicle with_fins(const std::string& yaml) {
  return changed_vehicle("lrauv_tethys", {{lrauv_fins, yaml}});
}
std::string refusal_of_fins(const std::string& yaml) {
  return tests::refusal_of("lrauv_tethys", {{lrauv_fins, yaml}});
}

std::string area_and_slope(const std::string& more = "") {
  return "{area_m2: 0.0244, position_x_m: -1.05, lift_slope_per_rad: 4.13, drag_factor: 0.069, "
         "stall_rad: 0.17, limit_rad: 0.261799, rate_rad_s: 0.35" +
         more + "}\n";
}

TEST(ReadFins, RudderAndElevatorAlikeAreTheFinsOfBoth) {
  const Vehicle both = with_fins(lrauv_fins);
  const Vehicle apart =
      with_fins("rudder: " + area_and_slope() + "elevator: " + area_and_slope(", lag_s: 0"));
  for (const double u : {-0.4, 1.3}) {
    const Spatial<double> nu_r{{u, 0.1, -0.07}, {0.01, 0.03, -0.02}};
    const Spatial<double> a = fins_force(both, nu_r, 0.05, -0.1);
    const Spatial<double> b = fins_force(apart, nu_r, 0.05, -0.1);
    EXPECT_EQ(a.linear.x, b.linear.x);
    EXPECT_EQ(a.linear.y, b.linear.y);
    EXPECT_EQ(a.linear.z, b.linear.z);
    EXPECT_EQ(a.angular.y, b.angular.y);
    EXPECT_EQ(a.angular.z, b.angular.z);
  }
}

/// Prestero (2001): Y = 9.64 u^2 delta_r, N = -6.15 u^2 delta_r, Z = -9.64 u^2 delta_s, M = -6.15
/// u^2 delta_s. SNAME's positive angles turn the bow to port and down, ours to starboard and up.
TEST(ReadFins, ByDerivativesGiveTheForcesOfThePublishedTable) {
  const Vehicle remus = with_fins(prestero_rudder + prestero_elevator);
  EXPECT_NEAR(remus.rudder.position_x_m, -0.638, 5e-4);
  EXPECT_NEAR(remus.elevator.position_x_m, -0.638, 5e-4);
  const double u = 2, delta_r = 0.1, delta_s = 0.07;
  const Spatial<double> force = fins_force(remus, {{u, 0, 0}, {}}, -delta_r, -delta_s);
  EXPECT_NEAR(force.linear.y, 9.64 * u * u * delta_r, 1e-7);
  EXPECT_NEAR(force.angular.z, -6.15 * u * u * delta_r, 1e-7);
  EXPECT_NEAR(force.linear.z, -9.64 * u * u * delta_s, 1e-7);
  EXPECT_NEAR(force.angular.y, -6.15 * u * u * delta_s, 1e-7);
  EXPECT_EQ(force.linear.x, 0);  // such tables have no drag of fins
  // Our commands: bow to starboard, bow up.
  EXPECT_GT(fins_force(remus, {{u, 0, 0}, {}}, 0.1, 0.0).angular.z, 0);
  EXPECT_GT(fins_force(remus, {{u, 0, 0}, {}}, 0.0, 0.1).angular.y, 0);
  // What the hull's derivatives have amidships they do not give once more.
  const Spatial<double> adrift = fins_force(remus, {{u, 0.2, 0.3}, {0, 0.1, -0.1}}, 0.0, 0.0);
  EXPECT_EQ(adrift.linear.y, 0);
  EXPECT_EQ(adrift.linear.z, 0);
}

TEST(ReadFins, OfASourceThatCountsItsRudderTheOtherWayAreTheSame) {
  const Vehicle remus = with_fins(
      "rudder: {Y_uu_delta_r: -9.64, N_uu_delta_r: 6.15, limit_rad: 0.237, rate_rad_s: 0.5}\n" +
      prestero_elevator);
  EXPECT_GT(fins_force(remus, {{2, 0, 0}, {}}, 0.1, 0.0).angular.z, 0);
}

TEST(ReadFins, TheirAreaGivesDerivativesADragAndAPassiveSlope) {
  const Vehicle remus = with_fins(
      "rudder: {Y_uu_delta_r: 9.64, N_uu_delta_r: -6.15, area_m2: 0.0133, drag_factor: 0.2, "
      "passive_lift_slope_per_rad: 2, stall_rad: 0.3, limit_rad: 0.237, rate_rad_s: 0.5}\n" +
      prestero_elevator);
  const double u = 1.5, v = 0.03, u2 = u * u + v * v;
  const Spatial<double> force = fins_force(remus, {{u, v, 0}, {}}, 0.0, 0.0);
  const double lift_n = 0.5 * 1025 * 0.0133 * 2 * u2 * v / std::sqrt(u2);
  EXPECT_NEAR(force.linear.y, -lift_n, 1e-8);
  const double coefficient = 2 * v / std::sqrt(u2);
  EXPECT_NEAR(force.linear.x, -0.5 * 1025 * 0.0133 * 0.2 * coefficient * coefficient * u2, 1e-9);
}

TEST(ReadFins, RefusesWhatNoFinsAreAndSaysWhy) {
  EXPECT_EQ(refusal_of_fins(lrauv_fins), "nothing was refused");
  const std::string rudder = "rudder: " + area_and_slope(),
                    elevator = "elevator: " + area_and_slope();
  EXPECT_TRUE(contains(refusal_of_fins(lrauv_fins + rudder), "give rudder and elevator, or fins"));
  EXPECT_TRUE(
      contains(refusal_of_fins("fins: " + area_and_slope(", passive_lift_slope_per_rad: -1")),
               "passive_lift_slope_per_rad"));
  EXPECT_TRUE(contains(refusal_of_fins("fins: " + area_and_slope(", lag_s: -1")), "lag_s"));
  const auto of_rudder = [&](const std::string& numbers) {
    return refusal_of_fins("rudder: {" + numbers + ", limit_rad: 0.2, rate_rad_s: 0.5}\n" +
                           elevator);
  };
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 9.64, N_uu_delta_r: 6.15"), "aft of the origin"));
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 0, N_uu_delta_r: 6.15"), "found 0"));
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 9.64"), "N_uu_delta_r"));
  EXPECT_TRUE(contains(of_rudder("Z_uu_delta_s: -9.64, M_uu_delta_s: -6.15"), "area_m2"));
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 9.64, N_uu_delta_r: -6.15, position_x_m: -0.6"),
                       "leave it out"));
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 9.64, N_uu_delta_r: -6.15, drag_factor: 0.1"),
                       "give area_m2 too"));
  EXPECT_TRUE(contains(of_rudder("Y_uu_delta_r: 9.64, N_uu_delta_r: -6.15, area_m2: 13.3"),
                       "a lift slope of 0.00141"));
  EXPECT_TRUE(contains(refusal_of_fins(rudder + "elevator: {Z_uu_delta_s: -9.64, M_uu_delta_s: "
                                                "6.15, limit_rad: 0.2, rate_rad_s: 0.5}\n"),
                       "with the sign of Z_uu_delta_s"));
}

}  // namespace
}  // namespace slackwater::twin::read_fins_test
