#include "twin/agent/coarse_step.h"

#include "fields/base/error.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::coarse_step_test {
namespace {

/// So many ROVs on tethers side by side, in a sea of 1 m.
std::string fleet(int vehicles, const std::string& detail) {
  std::string yaml = tests::head(
      0.05,
      "{partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 250}], components: 64}");
  for (int i = 0; i < vehicles; ++i) {
    const std::string n = std::to_string(i);
    yaml += "  - {name: rov" + n + ", model: bluerov2_heavy, detail: " + detail +
            ", start: {north_m: " + n + ", east_m: 5, depth_m: 1" + n +
            "}, tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 40}, tasks: [{do: "
            "route, waypoints: [{north_m: " +
            n + ", east_m: 15, depth_m: 12}]}]}\n";
  }
  return yaml;
}

RunLog log_of(const ReadyRun& ready, const RunSettings& settings, int steps) {
  twin::Run run(ready.agents, ready.states, settings);
  RunLog log;
  tests::step_and_log(run, steps, log);
  return log;
}

TEST(CoarseStep, LooksAndPullsAfterWholeSteps) {
  const CoarsePlan plan = plan_coarse(0.05, nullptr, 100);
  EXPECT_DOUBLE_EQ(plan.pull_s, 0.1);
  EXPECT_DOUBLE_EQ(plan.look_s, 0.5);
  // A segment of 1.25 m turns twice as fast as one of 2.5 m.
  EXPECT_DOUBLE_EQ(plan_coarse(0.05, nullptr, 40).pull_s, 0.1);
  EXPECT_DOUBLE_EQ(plan_coarse(0.05, nullptr, 20).pull_s, 0.05);
  for (const double dt_s : {0.004, 0.03, 0.04, 0.07, 0.1, 0.25}) {
    const CoarsePlan other = plan_coarse(dt_s, nullptr, 90);
    EXPECT_NEAR(std::remainder(other.pull_s, dt_s), 0, 1e-12);
    EXPECT_NEAR(std::remainder(other.look_s, other.pull_s), 0, 1e-12);
    EXPECT_LE(other.look_s, std::max(0.5, dt_s) + 1e-12);
  }
}

TEST(CoarseStep, LooksTenTimesInTheMeanPeriodOfTheSea) {
  const WaveWater water{1000, {}};
  const auto swell = [&](double period_s) {
    const double omega = 2 * constants::pi / period_s;
    const Horizontal k = omega * omega / constants::gravity_m_s2;
    return SeaRealisation({{0.5, omega, omega, k, 0}}, water, UtcTime{});
  };
  for (const auto& [period_s, look_s] :
       {std::pair{3.05, 0.3}, {2.05, 0.2}, {1.0, 0.1}, {0.5, 0.05}, {4.5, 0.4}, {12.0, 0.5}}) {
    const SeaRealisation sea = swell(period_s);
    const CoarsePlan plan = plan_coarse(0.05, &sea, 0);
    EXPECT_NEAR(plan.look_s, look_s, 1e-12) << period_s;
    EXPECT_LE(plan.pull_s, std::max(period_s / 20, 0.05) + 1e-12) << period_s;
  }
  const SeaRealisation calm({}, water, UtcTime{});
  EXPECT_NEAR(plan_coarse(0.05, &calm, 0).look_s, 0.5, 1e-12);
}

TEST(CoarseStep, HasTheSameBitsByEightOnAnyInstructionSetThreadsAndCompany) {
  // Ten, more than a block holds, and one in full among them.
  ReadyRun ready = tests::ready_of(fleet(10, "coarse"));
  ready.agents[6].coarse.reset();
  constexpr int steps = 60;
  RunSettings settings = tests::settings_of(0.05);
  settings.is_batch = false;
  const RunLog plain = log_of(ready, settings, steps);
  EXPECT_GT(plain.column(9, "tether_tension").back(), 0);
  settings.is_batch = true;
  for (const KernelPath path : supported_kernel_paths()) {
    for (const std::size_t threads : {1U, 2U}) {
      settings.path = path;
      settings.threads = threads;
      tests::expect_same_bits(log_of(ready, settings, steps), plain, std::string(name_of(path)));
    }
  }
  ReadyRun alone;
  alone.agents = {ready.agents[3]};
  alone.states = {ready.states[3]};
  const RunLog one = log_of(alone, tests::settings_of(0.05), steps);
  EXPECT_TRUE(tests::same_bits(one.rows[0], plain.rows[3]));
}

TEST(CoarseStep, GoesOnFromACheckpointBetweenTwoLooks) {
  const ReadyRun ready = tests::ready_of(fleet(3, "coarse"));
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 11; ++i) run.step();
  const twin::Run::Checkpoint checkpoint = run.checkpoint();
  RunLog expected, got;
  tests::step_and_log(run, 30, expected);
  twin::Run other(ready.agents, ready.states, tests::settings_of(0.05));
  other.restore(checkpoint);
  tests::step_and_log(other, 30, got);
  tests::expect_same_bits(got, expected, "from a checkpoint");
}

TEST(CoarseStep, KnowsNothingOfTheWaterWhereItIsPutElsewhere) {
  const ReadyRun ready = tests::ready_of(fleet(2, "coarse"));
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 12; ++i) run.step();
  VehicleState<double> put = run.states()[0].vehicle;
  put.body.position_m.z += 8;  // above it the waves have most of their motion
  run.enqueue({0, 0, PutVehicle{put}});
  run.step();
  const AgentState& state = run.states()[0];
  const Body& body = ready.agents[0].vehicle->body;
  const WaterSample expected = ready.agents[0].water->water(
      put.body.position_m + rotation_of(put.body.attitude).to_ned(body.centre_of_buoyancy_m),
      body.height_m, 0.6);
  EXPECT_NEAR(length_of(state.water_m_s - expected.motion.velocity_m_s), 0, 1e-3);
  EXPECT_NEAR(state.elevation_m, expected.motion.elevation_m, 1e-3);
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(CoarseStep, PullsAndDrawsAsTheFullOne) {
  // The table over the range of missions is that of tests/bench/rehearse_bench.cc.
  const ReadyRun full = tests::ready_of(fleet(1, "full"));
  const ReadyRun coarse = tests::ready_of(fleet(1, "coarse"));
  constexpr int steps = 800;
  const RunLog a = log_of(full, tests::settings_of(0.05), steps);
  const RunLog b = log_of(coarse, tests::settings_of(0.05), steps);
  const double tension_n = mean_of(a.column(0, "tether_tension"));
  EXPECT_GT(tension_n, 0.5);
  EXPECT_NEAR(mean_of(b.column(0, "tether_tension")), tension_n, 0.03 * tension_n);
  EXPECT_NEAR(b.column(0, "energy_delivered").back(), a.column(0, "energy_delivered").back(),
              0.01 * a.column(0, "energy_delivered").back());
  for (const char* axis : {"x", "y", "z"})
    EXPECT_NEAR(b.column(0, axis).back(), a.column(0, axis).back(), 0.05) << axis;
}

TEST(CoarseStep, HaltsWhereTheFullOneDoes) {
  // Down through the bed of 60 m.
  const auto down = [](const std::string& detail) {
    const std::string yaml =
        tests::calm_head(0.05) + "  - {name: rov, model: bluerov2_heavy, detail: " + detail +
        ", start: {north_m: 0, east_m: 0, depth_m: 58}, speed_m_s: 0.5, tasks: [{do: route, "
        "waypoints: [{north_m: 0, east_m: 1, depth_m: 59.8}]}]}\n";
    ReadyRun ready = tests::ready_of(yaml);
    ready.agents[0].mission.tasks[0].waypoints[0].position_m.z = 63;
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
    for (int i = 0; i < 1200 && !run.all_halted(); ++i) run.step();
    return run.states()[0];
  };
  const AgentState full = down("full");
  const AgentState coarse = down("coarse");
  EXPECT_EQ(full.halt, Halt::aground);
  EXPECT_EQ(coarse.halt, Halt::aground);
  EXPECT_NEAR(coarse.halted_at_s, full.halted_at_s, 0.051);
}

TEST(CoarseStep, IsForWhatSwimsUnderWater) {
  for (const std::string model : {"x500, start: {north_m: 0, east_m: 0, height_m: 20}",
                                  "wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}"}) {
    try {
      (void)tests::ready_of(tests::head(0.05) + "  - {name: a, detail: coarse, model: " + model +
                            "}\n");
      FAIL() << model;
    } catch (const Error& problem) {
      EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
      EXPECT_NE(problem.message().find("under water"), std::string::npos) << problem.message();
    }
  }
  try {
    (void)tests::ready_of(fleet(1, "quick"));
    FAIL();
  } catch (const Error& problem) {
    EXPECT_NE(problem.message().find("expected full or coarse"), std::string::npos);
  }
}

}  // namespace
}  // namespace slackwater::twin::coarse_step_test
