#include "fields/base/error.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/navigation/navigation_for_tests.h"
#include "twin/run/sensor_log.h"

namespace slackwater::twin::navigation_in_a_run_test {
namespace {

/// One of each vehicle on its way, in current and wind; `more` in each.
std::string five(const std::string& more, double step_s = 0.05) {
  const auto one = [&](const char* name, const char* model, const char* start, const char* to) {
    return "  - {name: " + std::string(name) + ", model: " + model + ", start: " + start +
           ", tasks: [{do: route, waypoints: [" + to + "]}]" + more + "}\n";
  };
  return tests::head(step_s) +
         one("rov", "bluerov2_heavy", "{north_m: 0, east_m: 0, depth_m: 20}",
             "{north_m: 15, east_m: 10, depth_m: 25}, {north_m: 0, east_m: 10, depth_m: 25}") +
         one("auv", "lrauv_tethys", "{north_m: 100, east_m: 0, depth_m: 10}",
             "{north_m: 250, east_m: 0, depth_m: 20}, {north_m: 250, east_m: 150, depth_m: 20}") +
         one("uav", "x500", "{north_m: 0, east_m: 50, height_m: 30}",
             "{north_m: 80, east_m: 50, height_m: 40}, {north_m: 80, east_m: 120, height_m: 40}") +
         one("usv", "wamv16", "{north_m: -100, east_m: 0, depth_m: 0}",
             "{north_m: -100, east_m: 150, depth_m: 0}, {north_m: -200, east_m: 150, depth_m: 0}") +
         one("ctv", "ctv24", "{north_m: -500, east_m: 0, depth_m: 0, heading_deg: 90}",
             "{north_m: -500, east_m: 800, depth_m: 0}");
}
const std::string by_sensors = ", navigation: sensors";

TEST(NavigationInARun, PerfectInstrumentsGiveTheRunOfTheTruth) {
  // Over ground, which these instruments tell; of the water some know nothing.
  const std::string speed = ", ground_speed_m_s: 0.8";
  const ReadyRun truth = tests::ready_of(five(speed));
  const ReadyRun sensed =
      tests::ready_with(five(by_sensors + speed), [](Sensors& s) { s = tests::perfect(s); });
  twin::Run a(truth.agents, truth.states, tests::settings_of(0.05));
  twin::Run b(sensed.agents, sensed.states, tests::settings_of(0.05));
  for (int i = 0; i < 1200; ++i) {
    a.step();
    b.step();
  }
  for (std::size_t i = 0; i < truth.agents.size(); ++i) {
    const Triple<double> apart = b.seen(i).position_m - a.seen(i).position_m;
    const Triple<double>& error = b.states()[i].navigation.error_m;
    RecordProperty(truth.agents[i].name + "_apart_m", std::to_string(std::sqrt(dot(apart, apart))));
    // The navigator's trapezoid against the Runge-Kutta step of the truth.
    EXPECT_LT(std::sqrt(dot(error, error)), 2e-3) << truth.agents[i].name;
    EXPECT_LT(std::sqrt(dot(apart, apart)), 2e-2) << truth.agents[i].name;
    EXPECT_EQ(b.states()[i].halt, Halt::none);
  }
}

TEST(NavigationInARun, MissionsSucceedByTheVehiclesOwnInstruments) {
  const ReadyRun ready = tests::ready_of(five(by_sensors));
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  std::vector<double> done_s(5), squares(5);
  int looks = 0;
  for (int i = 0; i < 20 * 600; ++i) {
    run.step();
    if (i % 20 != 0) continue;
    ++looks;
    for (std::size_t k = 0; k < 5; ++k) {
      const AgentState& state = run.states()[k];
      if (state.mission.is_done && done_s[k] == 0) done_s[k] = run.time_s();
      const double lost = tests::lost_m(state);
      squares[k] += lost * lost;
    }
  }
  const double way_m[] = {35, 300, 150, 250, 800};
  for (std::size_t k = 0; k < 5; ++k) {
    const AgentState& state = run.states()[k];
    const std::string& name = ready.agents[k].name;
    std::printf("%s: done at %.0f s, lost by %.2f m in the plane (rms %.2f), %.2f m down\n",
                name.c_str(), done_s[k], tests::lost_m(state), std::sqrt(squares[k] / looks),
                state.navigation.error_m.z);
    EXPECT_TRUE(state.mission.is_done) << name;
    EXPECT_EQ(state.halt, Halt::none) << name;
    // A receiver's 2.4 m, or what a compass that is off by 3 degrees makes of the way.
    EXPECT_LT(tests::lost_m(state), 4 + 0.06 * way_m[k]) << name;
    EXPECT_GT(tests::lost_m(state), 1e-3) << name;
  }
  // Held where it takes the last waypoint to be.
  const Triple<double> off = run.seen(0).position_m - Triple<double>{0, 10, 25};
  const Triple<double>& error = run.states()[0].navigation.error_m;
  EXPECT_LT(std::hypot(off.x + error.x, off.y + error.y), 0.7);
}

TEST(NavigationInARun, AnRovHoldsItsStationByItsDvl) {
  const ReadyRun ready = tests::ready_of(
      tests::head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, navigation: sensors, start: {north_m: 0, east_m: 0, "
      "depth_m: 20}}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  double farthest_m = 0;
  for (int i = 0; i < 20 * 1200; ++i) {
    run.step();
    const Triple<double>& at = run.seen(0).position_m;
    farthest_m = std::max(farthest_m, std::hypot(at.x, at.y));
  }
  std::printf("twenty minutes of hold: %.2f m off, lost by %.2f m\n", farthest_m,
              tests::lost_m(run.states()[0]));
  // 7 mm/s a ping and axis walk it by 0.16 m in 20 min; three of these, and the first pull of the
  // current.
  EXPECT_LT(farthest_m, 1.5);
  EXPECT_EQ(run.seen(0).halt, Halt::none);
}

TEST(NavigationInARun, TheSameBitsInBlocksThreadsAndOnEveryInstructionSet) {
  std::string yaml = five(by_sensors);
  for (const std::string n : {"1", "2", "3"})
    yaml += "  - {name: rov" + n +
            ", model: bluerov2_heavy, navigation: sensors, start: {north_m: " + n +
            "0, east_m: -20, depth_m: 10}}\n";
  const ReadyRun ready = tests::ready_of(yaml);
  const auto log_of = [&](const RunSettings& settings) {
    twin::Run run(ready.agents, ready.states, settings);
    RunLog log;
    tests::step_and_log(run, 60, log);
    return log;
  };
  RunSettings settings = tests::settings_of(0.05);
  settings.is_batch = false;
  const RunLog plain = log_of(settings);
  settings.is_batch = true;
  for (const KernelPath path : supported_kernel_paths()) {
    settings.path = path;
    settings.threads = 2;
    tests::expect_same_bits(log_of(settings), plain, std::string(name_of(path)));
  }
  // And from a checkpoint.
  twin::Run first(ready.agents, ready.states, settings);
  RunLog log, rest, expected;
  tests::step_and_log(first, 30, log);
  const auto checkpoint = first.checkpoint();
  tests::step_and_log(first, 30, expected);
  twin::Run second(ready.agents, ready.states, settings);
  second.restore(checkpoint);
  tests::step_and_log(second, 30, rest);
  tests::expect_same_bits(rest, expected, "from a checkpoint");
}

TEST(NavigationInARun, InstrumentsThatAreOnlyLoggedChangeNothing) {
  const std::string yaml = five("");
  const std::string head = yaml.substr(0, yaml.find("vehicles:"));
  const ReadyRun quiet = tests::ready_of(yaml);
  const ReadyRun logged =
      tests::ready_of(head + "log: {sensors: true}\n" + yaml.substr(head.size()));
  EXPECT_FALSE(quiet.agents[0].navigation);
  ASSERT_TRUE(logged.agents[0].navigation);
  twin::Run a(quiet.agents, quiet.states, tests::settings_of(0.05));
  twin::Run b(logged.agents, logged.states, tests::settings_of(0.05));
  RunLog log_a, log_b;
  tests::step_and_log(a, 100, log_a);
  tests::step_and_log(b, 100, log_b);
  tests::expect_same_bits(log_b, log_a, "with and without");
  EXPECT_GT(tests::lost_m(b.states()[0]), 0);
}

TEST(NavigationInARun, NothingIsAllocatedInAStep) {
  const ReadyRun ready = tests::ready_of(five(by_sensors));
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  for (int i = 0; i < 20; ++i) run.step();
  const std::size_t before = bench::allocations();
  for (int i = 0; i < 250; ++i) run.step();
  EXPECT_EQ(bench::allocations(), before);
  EXPECT_FALSE(run.all_halted());
}

TEST(NavigationInARun, AVehicleThatCannotFindItsWayIsRefusedAndSaysWhy) {
  const Scenario scenario =
      parse_scenario(tests::head(0.05) +
                         "  - {name: rov, model: bluerov2_heavy, navigation: sensors, start: "
                         "{north_m: 0, east_m: 0, depth_m: 10}}\n",
                     "test.yaml");
  const ReadyRun ready = tests::ready_of(scenario.yaml);
  const auto refusal = [&](const std::function<void(Sensors&)>& change) {
    auto vehicle = std::make_shared<Vehicle>(*ready.agents[0].vehicle);
    change(vehicle->sensors);
    try {
      (void)make_agent(vehicle, ready.agents[0].water, scenario.vehicles[0], 0.05);
    } catch (const Error& problem) {
      return problem.message();
    }
    return std::string("nothing was refused");
  };
  EXPECT_EQ(refusal([](Sensors&) {}), "nothing was refused");
  EXPECT_NE(refusal([](Sensors& s) { s.dvl.reset(); }).find("gnss or dvl"), std::string::npos);
  EXPECT_NE(refusal([](Sensors& s) { s.imu.reset(); }).find("imu"), std::string::npos);
  EXPECT_NE(refusal([](Sensors& s) { s.compass.reset(); }).find("compass"), std::string::npos);
  EXPECT_NE(refusal([](Sensors& s) { s.depth.reset(); }).find("depth"), std::string::npos);
}

TEST(SensorLog, HoldsWhatWasShownAndOnlyWhatIsAskedFor) {
  ReadyRun ready = tests::ready_with(five(", navigation: sensors"), [](Sensors& s) {
    s = tests::perfect(s);
    if (s.depth) s.adcp.emplace();  // the divers get one
  });
  ready.agents.pop_back();
  ready.states.pop_back();
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  SensorLog small(ready.agents, false, 7), all(ready.agents, true, 7);
  ASSERT_EQ(small.columns().size(), 1U);
  EXPECT_STREQ(small.columns()[0].name, "navigation_error");
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 20; ++k) run.step();
    small.append(run.time_s(), run.agents(), run.states());
    all.append(run.time_s(), run.agents(), run.states());
  }
  EXPECT_NEAR(all.column(0, "measured_depth").back(), run.seen(0).position_m.z, 0.05);
  EXPECT_TRUE(std::isnan(all.column(2, "measured_depth").back()));
  EXPECT_NEAR(all.column(1, "dvl_altitude").back(), 60 - run.seen(1).position_m.z, 1);
  EXPECT_EQ(all.column(1, "dvl_bottom_track").back(), 1);
  EXPECT_TRUE(std::isnan(all.column(1, "gnss_position").back()));                  // under water
  EXPECT_NEAR(all.column(2, "gnss_position")[12], run.seen(2).position_m.y, 1.5);  // east
  EXPECT_NEAR(all.column(2, "gnss_position")[14], -run.seen(2).position_m.z, 1.5);
  // The water above the ROV, once a minute.
  const std::vector<double> east = all.column(0, "adcp_eastward_velocity");
  EXPECT_EQ(east.size(), 5U * 40);
  EXPECT_NEAR(east[0], 0.4 - 0.3 * 8 / 40, 0.1);
  EXPECT_TRUE(std::isnan(east[40]));
  EXPECT_EQ(small.column(0, "navigation_error").size(), 15U);
}

}  // namespace
}  // namespace slackwater::twin::navigation_in_a_run_test
