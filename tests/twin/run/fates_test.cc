// What befalls a vehicle is known when the run is over: lost power, capsizing, how far it rolled;
// and its log says what was there, or that nothing is known.
#include <limits>

#include "fields/base/error.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::fates_test {
namespace {

void run_for(twin::Run& run, double seconds) {
  RunControl control(0);
  run.run_until(run.time_s() + seconds, control);
}

TEST(Fates, AMultirotorWithAnEmptyBatteryLosesPowerFallsAndStrikesTheSea) {
  for (const bool is_batch : {true, false}) {
    std::string yaml = tests::head(0.004);
    for (const char* n : {"0", "10"})
      yaml += std::string("  - {name: uav") + n +
              ", model: x500, state_of_charge: 0.005, start: "
              "{north_m: " +
              n + ", east_m: 0, height_m: 40}, tasks: [{do: hold}]}\n";
    const ReadyRun ready = tests::ready_of(yaml);
    RunSettings settings = tests::settings_of(0.004);
    settings.is_batch = is_batch;
    twin::Run run(ready.agents, ready.states, settings);
    run_for(run, 60);
    for (const AgentState& state : run.states()) {
      EXPECT_EQ(state.halt, Halt::struck);
      EXPECT_GT(state.milestones.power_lost_s, 1);
      EXPECT_GT(state.halted_at_s, state.milestones.power_lost_s + 1);
      EXPECT_LT(state.halted_at_s, state.milestones.power_lost_s + 10);
    }
  }
}

TEST(Fates, ACraftThatIsTurnedOverHaltsAsCapsizedWhereItFloatsAndIsToldOfWhereItSwims) {
  for (const char* model : {"wamv16", "lrauv_tethys", "bluerov2_heavy"}) {
    for (const bool is_batch : {true, false}) {
      std::string yaml = tests::calm_head(0.05);
      for (const char* n : {"0", "100"})
        yaml += std::string("  - {name: it") + n + ", model: " + model + ", start: {north_m: " + n +
                ", east_m: 0, depth_m: 10}, tasks: [{do: hold}]}\n";
      const ReadyRun ready = tests::ready_of(yaml);
      RunSettings settings = tests::settings_of(0.05);
      settings.is_batch = is_batch;
      twin::Run run(ready.agents, ready.states, settings);
      run_for(run, 2);
      VehicleState<double> over = run.states()[1].vehicle;
      over.body.attitude = attitude_of({2.0, 0, 0});
      run.enqueue({0, 1, PutVehicle{over}});
      run_for(run, 5);
      EXPECT_EQ(run.states()[0].halt, Halt::none) << model;
      EXPECT_TRUE(std::isnan(run.states()[0].milestones.capsized_s)) << model;
      const bool floats = std::string(model) == "wamv16";
      EXPECT_EQ(run.states()[1].halt, floats ? Halt::capsized : Halt::none) << model;
      EXPECT_NEAR(run.states()[1].milestones.capsized_s, 2, 0.06) << model;
      EXPECT_GE(run.states()[1].milestones.largest_roll_rad(), 2.0 - 1e-9) << model;
    }
  }
}

TEST(Fates, TheLargestRollAndPitchAreThoseOfEveryStep) {
  Milestones m;
  for (const double roll : {0.1, -0.4, 0.2})
    note_attitude(m, rotation_of(attitude_of({roll, -0.5 * roll, 1.0})), 1);
  EXPECT_NEAR(m.largest_roll_rad(), 0.4, 1e-12);
  EXPECT_NEAR(m.largest_pitch_rad(), 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(m.capsized_s));
  note_attitude(m, rotation_of(attitude_of({-2.5, 0, 0})), 7);
  EXPECT_NEAR(m.largest_roll_rad(), 2.5, 1e-9);
  EXPECT_EQ(m.capsized_s, 7);
}

TEST(Fates, AVehicleWithoutABatteryOrOnAHeldBusTellsItsEnergyAllTheSame) {
  for (const char* more : {"", ", hold_bus_v: 16"}) {
    const ReadyRun ready = tests::ready_of(
        tests::calm_head(0.05) + "  - {name: rov, model: bluerov2_heavy" + more +
        ", start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: [{do: route, waypoints: [{north_m: "
        "90, east_m: 0, depth_m: 10}]}]}\n");
    twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
    run_for(run, 20);
    const VehicleState<double>& v = run.states()[0].vehicle;
    EXPECT_GT(v.drawn_j, 20 * 15.0) << more;  // the hotel load alone
    if (std::string(more).empty()) {
      EXPECT_NEAR(v.drawn_j, v.battery.delivered_j, 1e-6 * v.drawn_j);
    }
  }
}

/// One WAM-V at rest in a swell from the west, an AUV, a multirotor.
std::string in_swell(const std::string& waves) {
  return tests::head(0.05, waves) +
         "  - {name: usv, model: wamv16, start: {north_m: 0, east_m: 0, depth_m: 0}}\n"
         "  - {name: auv, model: lrauv_tethys, start: {north_m: 90, east_m: 0, depth_m: 20}}\n"
         "  - {name: uav, model: x500, start: {north_m: 200, east_m: 0, height_m: 30}}\n";
}

RunLog log_of(const std::string& yaml, int steps) {
  const ReadyRun ready = tests::ready_of(yaml);
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  RunLog log;
  log.append(0, run.agents(), run.states());
  tests::step_and_log(run, steps, log);
  return log;
}

TEST(Logs, AFloatingCraftLogsTheSeaThatMovesIt) {
  const RunLog log =
      log_of(in_swell("{partitions: [{significant_height_m: 2, peak_period_s: 12, from_deg: 270}], "
                      "components: 32}"),
             2400);
  const std::vector<double> z = log.column(0, "z"), eta = log.column(0, "surface_elevation"),
                            water = log.column(0, "water_velocity");
  double sum_zz = 0, sum_ee = 0, sum_ze = 0, upward = 0;
  const double mean = z.front();
  for (std::size_t i = 600; i < z.size(); ++i) {
    sum_zz += (z[i] - mean) * (z[i] - mean);
    sum_ee += eta[i] * eta[i];
    sum_ze += (z[i] - mean) * eta[i];
    upward = std::max(upward, std::abs(water[3 * i + 2]));
  }
  // A craft of five metres rides on a swell of 200 m: it is where the surface is.
  EXPECT_GT(sum_ee / static_cast<double>(z.size()), 0.05);
  EXPECT_GT(sum_ze / std::sqrt(sum_zz * sum_ee), 0.98);
  EXPECT_NEAR(std::sqrt(sum_zz / sum_ee), 1, 0.1);
  EXPECT_GT(upward, 0.2);  // orbital: pi Hs / Tp, about
}

TEST(Logs, WhatIsNotThereIsMissingAndNotZero) {
  for (const std::string& waves :
       {std::string("{from: calm}"),
        std::string("{partitions: [{significant_height_m: 1, "
                    "peak_period_s: 6, from_deg: 270}], components: 16}")}) {
    const RunLog log = log_of(in_swell(waves), 20);
    const bool is_calm = waves.find("calm") != std::string::npos;
    for (std::size_t vehicle = 0; vehicle < 3; ++vehicle) {
      const auto water = log.column(vehicle, "water_velocity"),
                 wind = log.column(vehicle, "wind_velocity"),
                 through = log.column(vehicle, "speed_through_water"),
                 eta = log.column(vehicle, "surface_elevation");
      for (std::size_t i = 0; i < eta.size(); ++i) {
        // From the first row on: at the start, too, there is water and wind.
        EXPECT_EQ(std::isnan(water[3 * i]), vehicle == 2) << vehicle << " " << i;
        EXPECT_EQ(std::isnan(through[i]), vehicle == 2) << vehicle << " " << i;
        EXPECT_EQ(std::isnan(wind[3 * i]), vehicle == 1) << vehicle << " " << i;
        EXPECT_EQ(eta[i] == 0, is_calm) << vehicle << " " << i;
      }
      if (vehicle < 2) {
        EXPECT_GT(water[0], 0.05) << vehicle;
      }
      if (vehicle != 1) {
        EXPECT_GT(wind[0], 3) << vehicle;
      }
    }
  }
}

TEST(Logs, TheDepthErrorOfAHoldIsThereToo) {
  // An ROV that is put three metres below the place it holds.
  const ReadyRun ready = tests::ready_of(
      tests::calm_head(0.05) +
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}}\n");
  twin::Run run(ready.agents, ready.states, tests::settings_of(0.05));
  RunLog log;
  tests::step_and_log(run, 20, log);
  VehicleState<double> lower = run.states()[0].vehicle;
  lower.body.position_m.z += 3;
  run.enqueue({0, 0, PutVehicle{lower}});
  tests::step_and_log(run, 5, log);
  EXPECT_NEAR(log.column(0, "below_track").front(), 0, 0.05);
  EXPECT_NEAR(log.column(0, "below_track").back(), 3, 0.1);
}

}  // namespace
}  // namespace slackwater::twin::fates_test
