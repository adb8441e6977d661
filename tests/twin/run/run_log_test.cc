#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::run_log_test {
namespace {

/// An ROV and a multirotor that go north-east and down or up, logged at each step.
class RunLogOf : public testing::Test {
 protected:
  static constexpr double step_s = 0.02;
  static constexpr int steps = 400;
  static void SetUpTestSuite() {
    const ReadyRun ready = tests::ready_of(
        tests::head(step_s) +
        "  - {name: rov, model: bluerov2_heavy, start: {north_m: 10, east_m: -20, depth_m: 10, "
        "heading_deg: 90}, "
        "tasks: [{do: route, waypoints: [{north_m: 20, east_m: 0, depth_m: 15}]}]}\n"
        "  - {name: uav, model: x500, start: {north_m: 10, east_m: -20, height_m: 30}, "
        "tasks: [{do: route, waypoints: [{north_m: 60, east_m: 30, height_m: 40}]}]}\n");
    twin::Run run(ready.agents, ready.states, tests::settings_of(step_s));
    log = RunLog();
    tests::step_and_log(run, steps, log);
    first = ready.states;
    last.assign(run.states().begin(), run.states().end());
  }
  static RunLog log;
  static std::vector<AgentState> first, last;
};
RunLog RunLogOf::log;
std::vector<AgentState> RunLogOf::first;
std::vector<AgentState> RunLogOf::last;

TEST_F(RunLogOf, PositionsAreEastNorthUp) {
  for (std::size_t i : {0U, 1U}) {
    const Triple<double>& ned = last[i].vehicle.body.position_m;
    EXPECT_EQ(log.column(i, "x").back(), ned.y);
    EXPECT_EQ(log.column(i, "y").back(), ned.x);
    EXPECT_EQ(log.column(i, "z").back(), -ned.z);
    EXPECT_NEAR(log.column(i, "x").front(), -20, 0.1);
    EXPECT_NEAR(log.column(i, "y").front(), 10, 0.1);
  }
  EXPECT_LT(log.column(0, "z").back(), log.column(0, "z").front() - 0.5);  // dives
  EXPECT_GT(log.column(1, "z").back(), log.column(1, "z").front() + 2);    // climbs
}

TEST_F(RunLogOf, WindBlowsTowardsTheEastAndTheCurrentIsEastNorthUp) {
  // From the west at 8 m/s; at 30 m more than at 10 m. The ROV at 10 m has (0.325, 0.05).
  EXPECT_GT(log.column(1, "wind_velocity")[0], 8);
  EXPECT_NEAR(log.column(1, "wind_velocity")[1], 0, 1e-9);
  EXPECT_NEAR(log.column(0, "water_velocity")[0], 0.325, 1e-3);
  EXPECT_NEAR(log.column(0, "water_velocity")[1], 0.05, 1e-3);
  EXPECT_NEAR(log.column(0, "yaw").front(), constants::pi / 2, 0.05);
}

TEST_F(RunLogOf, PositionsAreTheIntegralOfTheVelocity) {
  for (std::size_t i : {0U, 1U}) {
    const auto x = log.column(i, "x"), y = log.column(i, "y"), z = log.column(i, "z");
    const auto roll = log.column(i, "roll"), pitch = log.column(i, "pitch"),
               yaw = log.column(i, "yaw"), v = log.column(i, "velocity_body");
    const auto enu = [&](std::size_t k) {
      const Triple<double> ned = rotation_of(attitude_of({roll[k], pitch[k], yaw[k]}))
                                     .to_ned(Triple<double>{v[3 * k], v[3 * k + 1], v[3 * k + 2]});
      return Triple<double>{ned.y, ned.x, -ned.z};
    };
    Triple<double> sum{x[0], y[0], z[0]};
    double way_m = 0;
    for (std::size_t k = 1; k < x.size(); ++k) {
      const Triple<double> mean = 0.5 * (enu(k - 1) + enu(k));
      sum = sum + step_s * mean;
      way_m += step_s * std::sqrt(dot(mean, mean));
    }
    // Trapezoids: h^2/12 times the change of acceleration, at most 10 m/s3 over 8 s.
    const double tolerance_m = 5e-3;
    EXPECT_GT(way_m, 2);
    EXPECT_NEAR(sum.x, x.back(), tolerance_m) << i;
    EXPECT_NEAR(sum.y, y.back(), tolerance_m) << i;
    EXPECT_NEAR(sum.z, z.back(), tolerance_m) << i;
  }
}

TEST_F(RunLogOf, EnergyIsTheIntegralOfPowerAndChargeThatOfCurrent) {
  const auto power = log.column(0, "electrical_power"), energy = log.column(0, "energy_delivered");
  const auto current = log.column(0, "battery_current"), drawn = log.column(0, "charge_drawn");
  const auto voltage = log.column(0, "bus_voltage"), charge = log.column(0, "state_of_charge");
  double joule = 0, coulomb = 0;
  // The ROV makes one step per barrier: each row's power was drawn for the whole step before it.
  for (std::size_t k = 0; k < power.size(); ++k) {
    joule += step_s * power[k];
    coulomb += step_s * current[k];
    EXPECT_NEAR(power[k], voltage[k] * current[k], 1e-6 * power[k]) << k;
  }
  EXPECT_NEAR(energy.back(), joule, 1e-9 * joule);
  EXPECT_NEAR(drawn.back(), coulomb, 1e-9 * coulomb);
  EXPECT_GT(joule, 100);
  EXPECT_LT(charge.back(), 1);
  EXPECT_GT(charge.back(), 0.99);
}

TEST_F(RunLogOf, ColumnsAreNamedOnceWithUnitsAndFillTheRow) {
  std::size_t sum = 0;
  for (const LogVariable& a : log_variables()) {
    sum += a.per;
    EXPECT_NE(std::string(a.units), "") << a.name;
    EXPECT_EQ(log.column(0, a.name).size(), a.per * log.t_s.size()) << a.name;
    int same = 0;
    for (const LogVariable& b : log_variables()) same += std::string(a.name) == b.name ? 1 : 0;
    EXPECT_EQ(same, 1) << a.name;
  }
  EXPECT_EQ(sum, log_row_size());
  EXPECT_ANY_THROW((void)log.column(0, "speed_of_sound"));
  EXPECT_NEAR(log.t_s.back(), steps * step_s, 1e-9);
}

}  // namespace
}  // namespace slackwater::twin::run_log_test
