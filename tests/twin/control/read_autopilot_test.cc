#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/twin/control/closed_loop.h"

namespace slackwater::twin::read_autopilot_test {
namespace {

using tests::contains;

AutopilotSettings read(const std::string& yaml, VehicleKind kind, double step_s = 0.05) {
  const Config config = Config::parse(yaml, "made-up.yaml");
  const AutopilotSettings settings = read_autopilot(config, kind, step_s);
  config.expect_all_read();
  return settings;
}

std::string refusal(const std::string& yaml, VehicleKind kind, double step_s = 0.05) {
  try {
    (void)read(yaml, kind, step_s);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "accepted";
}

TEST(ReadAutopilot, TakesWhatTheFileSaysAndTheKindsDefaultsForTheRest) {
  const AutopilotSettings s = read(
      "autopilot: {horizontal_period_s: 9, most_yaw_rate_deg_s: 90, current_feed_forward: true}",
      VehicleKind::rov);
  EXPECT_EQ(s.horizontal_period_s, 9);
  EXPECT_NEAR(s.most_yaw_rate_rad_s, constants::pi / 2, 1e-12);
  EXPECT_TRUE(s.current_feed_forward);
  EXPECT_EQ(s.vertical_period_s, default_autopilot(VehicleKind::rov).vertical_period_s);
  EXPECT_EQ(read("autopilot: {damping_ratio: 0.9}", VehicleKind::uav, 0.004).most_climb_m_s, 3);
}

TEST(ReadAutopilot, RefusesNonsenseAndSaysWhatWouldDo) {
  const VehicleKind rov = VehicleKind::rov, uav = VehicleKind::uav, auv = VehicleKind::auv;
  EXPECT_TRUE(contains(refusal("autopilot: {horizontal_period_s: 0.5}", rov), "at least 1 s"));
  EXPECT_TRUE(contains(refusal("autopilot: {damping_ratio: 0.1}", rov), "damping_ratio"));
  EXPECT_TRUE(contains(refusal("autopilot: {heading_period_s: .nan}", rov), "heading_period_s"));
  EXPECT_TRUE(contains(refusal("autopilot: {horizontal_periods: 5}", rov), "horizontal_period_s"));
  EXPECT_TRUE(contains(refusal("autopilot: {most_tilt_deg: 30}", rov), "most_tilt_deg"));
  EXPECT_TRUE(
      contains(refusal("autopilot: {holding_radius_m: 30}", uav, 0.004), "holding_radius_m"));
  EXPECT_TRUE(contains(refusal("autopilot: {tilt_period_s: 2}", uav, 0.004), "3 tilt_period_s"));
  EXPECT_TRUE(contains(refusal("id: x", uav, 0.1), "largest_step_s"));
  EXPECT_TRUE(contains(refusal("autopilot: {tilt_period_s: 25}", auv), "2 tilt_period_s"));
  EXPECT_TRUE(
      contains(refusal("autopilot: {most_speed_m_s: 0.2}", auv), "more than most_speed_m_s"));
}

std::string unsteerable(VehicleKind kind, const Body& body, const Actuators& actuators) {
  try {
    (void)plan_autopilot(default_autopilot(kind), kind, body, actuators);
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "accepted";
}

TEST(PlanAutopilot, RefusesAVehicleThatItsKindCannotSteer) {
  const Body rov = tests::body_from_data("bluerov2_heavy");
  const auto t200 = tests::bluerov2_mounts();
  const auto ranges = tests::t200_ranges(8);
  const auto four = std::span(t200).first(4);
  EXPECT_TRUE(contains(unsteerable(VehicleKind::rov, rov, {four, std::span(ranges).first(4)}),
                       "push it ahead, sideways and up"));
  EXPECT_TRUE(contains(unsteerable(VehicleKind::usv, rov,
                                   {std::span(t200).subspan(4), std::span(ranges).subspan(4)}),
                       "Two side by side"));
  EXPECT_TRUE(contains(unsteerable(VehicleKind::auv, rov, {t200, ranges}), "fins"));
  // Rotors that all turn one way do not turn it.
  auto rotors = tests::x500_mounts();
  const auto lift = tests::x500_ranges();
  const Body x500 = tests::body_from_data("x500");
  Body heavy = x500;
  heavy.mass_kg = 3;
  EXPECT_TRUE(contains(unsteerable(VehicleKind::uav, heavy, {rotors, lift}), "1.2 times"));
  for (Mount& rotor : rotors) rotor.spin = 1;
  EXPECT_TRUE(
      contains(unsteerable(VehicleKind::uav, x500, {rotors, lift}), "as many turn one way"));
}

TEST(PlanAutopilot, TakesGainsFromPeriodsAndTheMassMatrix) {
  const tests::ClosedLoop loop = tests::bluerov2();
  // The PID of Fossen (2011), 12.2.10, for a mass m with natural frequency w and damping ratio z.
  const double w = 2 * constants::pi / 6, z = 0.9;
  const Loop& pid = loop.autopilot.horizontal;
  EXPECT_NEAR(pid.inner_per_s, 2 * z * w, 1e-12);
  EXPECT_NEAR(pid.inner_per_s * pid.outer_per_s, w * w, 1e-12);
  EXPECT_NEAR(pid.integral_per_s2 * pid.outer_per_s, w * w * w / 10, 1e-12);
  EXPECT_NEAR(loop.autopilot.mass.entry[0][0], 13.5 + 6.3567, 1e-12);
  // 0.95 of where 129 N meet 4.03 U + 46.2 U^2, without what the inflow takes.
  EXPECT_NEAR(loop.autopilot.settings.most_speed_m_s, 0.95 * 1.628, 0.01);
}

}  // namespace
}  // namespace slackwater::twin::read_autopilot_test
