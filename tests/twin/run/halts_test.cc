#include <limits>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::halts_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int steps = 40;

/// Three ROVs side by side.
ReadyRun three() {
  std::string yaml = tests::head(0.05);
  for (const std::string n : {"0", "1", "2"}) {
    yaml += "  - {name: rov" + n + ", model: bluerov2_heavy, start: {north_m: " + n +
            "0, east_m: 0, depth_m: 10}, tasks: [{do: route, waypoints: [{north_m: " + n +
            "0, east_m: 50, depth_m: 10}]}]}\n";
  }
  return tests::ready_of(yaml);
}

/// Changes the second between two steps.
void put(twin::Run& run, const std::function<void(VehicleState<double>&)>& change) {
  VehicleState<double> vehicle = run.states()[1].vehicle;
  change(vehicle);
  run.enqueue({0, 1, PutVehicle{vehicle}});
}

RunLog log_with(bool is_batch, const std::function<void(twin::Run&, int)>& meddle) {
  const ReadyRun ready = three();
  RunSettings settings = tests::settings_of(0.05);
  settings.is_batch = is_batch;
  twin::Run run(ready.agents, ready.states, settings);
  RunLog log;
  for (int i = 0; i < steps; ++i) {
    meddle(run, i);
    run.step();
    log.append(run.time_s(), run.agents(), run.states());
  }
  return log;
}

/// The second of the three halts for that reason; the others' bits are those of a run where nothing
/// happens.
void expect_halt(const std::function<void(twin::Run&, int)>& meddle, Halt why) {
  const RunLog quiet = log_with(true, [](twin::Run&, int) {});
  for (const bool is_batch : {true, false}) {
    const RunLog log = log_with(is_batch, meddle);
    EXPECT_TRUE(tests::same_bits(log.rows[0], quiet.rows[0])) << is_batch;
    EXPECT_TRUE(tests::same_bits(log.rows[2], quiet.rows[2])) << is_batch;
    EXPECT_EQ(log.column(1, "halt").back(), static_cast<double>(why)) << is_batch;
    EXPECT_EQ(log.column(1, "halt").front(), 0);
    EXPECT_EQ(log.t_s.size(), static_cast<std::size_t>(steps));
  }
}

TEST(Halts, AStateThatIsNoNumberDiverged) {
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.position_m.y = nan; });
      },
      Halt::diverged);
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.nu.linear.x = nan; });
      },
      Halt::diverged);
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.attitude.w = nan; });
      },
      Halt::diverged);
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.attitude.y = nan; });
      },
      Halt::diverged);
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.battery.charge = nan; });
      },
      Halt::diverged);
}

TEST(Halts, AThrusterOrABatteryThatIsNoNumberDivergedToo) {
  const auto spoilt = [](const std::function<void(VehicleState<double>&)>& spoil) {
    return [spoil](twin::Run& run, int i) {
      if (i == 10) put(run, spoil);
    };
  };
  using State = VehicleState<double>;
  expect_halt(spoilt([](State& v) { v.thruster[3] = nan; }), Halt::diverged);
  expect_halt(spoilt([](State& v) { v.battery.rc_voltage_v = nan; }), Halt::diverged);
  expect_halt(spoilt([](State& v) { v.battery.drawn_c = nan; }), Halt::diverged);
  expect_halt(spoilt([](State& v) { v.battery.delivered_j = HUGE_VAL; }), Halt::diverged);
  expect_halt(spoilt([](State& v) { v.fuel_kg = nan; }), Halt::diverged);
  expect_halt(spoilt([](State& v) { v.volume_m3 = nan; }), Halt::diverged);
}

TEST(Halts, ARunawayKeepsItsLastSoundState) {
  // 190 m/s through water is more than the step can follow: it overshoots to what no vehicle has.
  const auto push = [](twin::Run& run, int i) {
    if (i == 10) put(run, [](auto& v) { v.body.nu.linear = {190, 150, -190}; });
  };
  expect_halt(push, Halt::diverged);
  for (const bool is_batch : {true, false}) {
    const RunLog log = log_with(is_batch, push);
    // All that is its own; what it does not meet (wind) is missing.
    for (const char* own : {"x", "y", "z", "roll", "pitch", "yaw", "velocity_body", "rate_body",
                            "thrust", "thruster_state", "electrical_power", "state_of_charge"})
      for (std::size_t i = 0; i < log.rows.size(); ++i)
        for (const double value : log.column(i, own)) ASSERT_TRUE(std::isfinite(value)) << own;
    const std::vector<double> x = log.column(1, "x");
    EXPECT_EQ(x.back(), x[x.size() - 10]);  // it stays where it was
    EXPECT_LT(std::abs(x.back()), 60);
  }
}

TEST(Halts, AgroundBelowTheBed) {
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.position_m.z = 61; });
      },
      Halt::aground);
}

TEST(Halts, OutsideOfTheForecastsArea) {
  expect_halt(
      [](twin::Run& run, int i) {
        if (i == 10) put(run, [](auto& v) { v.body.position_m.x = 60e3; });
      },
      Halt::outside_area);
}

TEST(Halts, AtTheEndOfTheForecastAllDoAndStayInTheLog) {
  const ReadyRun ready = three();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  // Two hours and a step: the forecast of the tests ends after two.
  twin::Run::Checkpoint late = run.checkpoint();
  late.steps_made = 2 * 3600 * 20 - 2;
  run.restore(late);
  RunLog log;
  tests::step_and_log(run, 6, log);
  EXPECT_TRUE(run.all_halted());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(log.column(i, "halt").back(), static_cast<double>(Halt::outside_time));
    EXPECT_EQ(log.column(i, "x").size(), 6U);
    EXPECT_NEAR(run.states()[i].halted_at_s, 7200, 0.06);
    EXPECT_EQ(run.seen(i).halt, Halt::outside_time);
  }
}

TEST(Halts, AVehicleThatACurrentCarriesIntoAPileHasStruckIt) {
  // 2.5 m/s is more than an ROV can hold; the pile's near side is 20 m down the stream.
  const ReadyRun ready = tests::ready_of(R"(name: test
seed: 7
duration: 5min
step_s: 0.05
log_every_s: 1
water: {made_up: {depth_m: 60, current: [{depth_m: 0, east_m_s: 2.5, north_m_s: 0}]}}
structures:
  - {kind: cylinder, north_m: 0, east_m: 23, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 60}
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}}
)");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 2000 && !run.all_halted(); ++i) run.step();
  EXPECT_EQ(run.seen(0).halt, Halt::struck);
  EXPECT_NEAR(run.seen(0).position_m.y, 20, 0.2);
}

TEST(Halts, AMultirotorThatCannotStayUpFallsIntoTheSea) {
  const ReadyRun ready = tests::ready_of(tests::calm_head(0.02) +
                                         "  - {name: uav, model: x500, state_of_charge: 0, start: "
                                         "{north_m: 0, east_m: 0, height_m: 15}}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.02));
  for (int i = 0; i < 300; ++i) run.step();
  EXPECT_NE(run.states()[0].halt, Halt::none) << run.states()[0].vehicle.body.position_m.z;
  EXPECT_NE(run.states()[0].halt, Halt::diverged);
  EXPECT_LT(run.states()[0].vehicle.body.position_m.z, 1);
}

TEST(Halts, AnEmptyBatteryIsNoHaltButNoThrustEither) {
  const ReadyRun ready = tests::ready_of(
      tests::calm_head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, state_of_charge: 0, start: {north_m: 0, east_m: 0, "
      "depth_m: 10}, "
      "tasks: [{do: route, waypoints: [{north_m: 50, east_m: 0, depth_m: 20}]}]}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 200; ++i) run.step();
  const AgentState& state = run.states()[0];
  EXPECT_EQ(state.halt, Halt::none);
  EXPECT_EQ(state.vehicle.battery.off, 1);
  for (const double thrust : state.vehicle.thrust_n) EXPECT_EQ(thrust, 0);
  EXPECT_LT(std::abs(state.vehicle.body.position_m.x), 0.5);
}

}  // namespace
}  // namespace slackwater::twin::halts_test
