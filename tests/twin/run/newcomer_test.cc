// Vehicles that join a run while it goes on.
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/run/command_numbers.h"
#include "twin/run/newcomer_yard.h"

namespace slackwater::twin::newcomer_test {
namespace {

constexpr double step_s = 0.05;

/// A fleet, and who may join it.
struct Fleet {
  explicit Fleet(const std::string& yaml) : scenario(parse_scenario(yaml, "test.yaml")) {
    for (ScenarioVehicle& vehicle : scenario.vehicles)
      for (ScenarioTask& task : vehicle.tasks)
        if (task.hold_s == 60) task.hold_s = 1;  // shorter than a file can say
    ready = set_up(scenario, tests::surround_of(scenario));
  }
  [[nodiscard]] NewcomerYard newcomer_yard() const {
    return {scenario, tests::source_folder() / "data", ready.vehicles, ready.agents};
  }
  [[nodiscard]] std::unique_ptr<twin::Run> begun(std::size_t threads = 1,
                                                 bool is_batch = true) const {
    RunSettings settings = tests::settings_of(step_s);
    settings.threads = threads;
    settings.is_batch = is_batch;
    settings.most_newcomers = 8;
    return std::make_unique<twin::Run>(ready.agents, ready.states, settings);
  }
  Scenario scenario;
  ReadyRun ready;
};

Command spawn(const NewcomerYard& newcomer_yard, const Newcomer& newcomer, std::uint64_t step,
              double received_s = 0) {
  Command command;
  command.step = step;
  command.what = Spawn{newcomer, newcomer_yard.ready(newcomer, received_s)};
  command.source = "dds 01";
  command.received_s = received_s;
  return command;
}

/// One of each model of the mixed fleet, away from it.
std::vector<Newcomer> one_of_each() {
  return {{"bluerov2_heavy", "late_rov", {300, 300, 14}, 0.5},
          {"lrauv_tethys", "late_auv", {-300, 400, 20}, 2},
          {"x500", "late_uav", {200, -300, -25}, -1},
          {"wamv16", "late_usv", {-500, -300, 0}, 3},
          {"ctv24", "late_ctv", {-700, 500, 0}, 0}};
}

/// The same as vehicles of a scenario that hold from the start.
std::string as_listed(const std::vector<Newcomer>& newcomers) {
  std::string yaml;
  for (const Newcomer& n : newcomers) {
    const double heading_deg = n.heading_rad * 180 / 3.141592653589793;
    yaml += "  - {name: " + n.name + ", model: " + n.model +
            ", start: {north_m: " + std::to_string(n.position_m.x) +
            ", east_m: " + std::to_string(n.position_m.y) +
            (n.position_m.z < 0 ? ", height_m: " : ", depth_m: ") +
            std::to_string(std::abs(n.position_m.z)) +
            ", heading_deg: " + std::to_string(heading_deg) + "}, tasks: [{do: hold}]}\n";
  }
  return yaml;
}

void expect_same_states(std::span<const AgentState> a, std::span<const AgentState> b,
                        const std::string& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const VehicleState<double>&v = a[i].vehicle, &w = b[i].vehicle;
    EXPECT_EQ(std::memcmp(&v, &w, sizeof v), 0) << what << ": vehicle " << i;
    EXPECT_EQ(a[i].nearest, b[i].nearest) << what << ": vehicle " << i;
  }
}

TEST(Newcomers, OfTheFirstStepAreTheVehiclesOfAScenarioThatHold) {
  const Fleet fleet(tests::mixed_fleet());
  // A file gives headings in degrees: those of the entry, so that the same bits are asked for.
  std::vector<Newcomer> newcomers = one_of_each();
  const Fleet whole(tests::mixed_fleet() + as_listed(newcomers));
  const std::size_t before = fleet.ready.agents.size();
  for (std::size_t i = 0; i < newcomers.size(); ++i) {
    newcomers[i].heading_rad = whole.scenario.vehicles[before + i].heading_rad;
    newcomers[i].position_m = whole.scenario.vehicles[before + i].start_m;
  }
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const auto run = fleet.begun(threads, is_batch);
      const auto expected = whole.begun(threads, is_batch);
      for (const Newcomer& newcomer : newcomers) run->enqueue(spawn(newcomer_yard, newcomer, 0));
      RunLog got, wanted;
      tests::step_and_log(*run, 60, got);
      tests::step_and_log(*expected, 60, wanted);
      tests::expect_same_bits(got, wanted, "listed in the scenario");
      ASSERT_EQ(run->agents().size(), before + newcomers.size());
      EXPECT_EQ(run->agents().back().name, "late_ctv");
      EXPECT_EQ(run->commands_taken()[4].agent, before + 4);
    }
}

TEST(Newcomers, GoOnAsInARunThatHadThemAtThatTime) {
  const Fleet fleet(tests::mixed_fleet());
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  constexpr int before = 30, after = 60;
  const double then_s = before * step_s;
  RunLog alone;
  const auto undisturbed = fleet.begun();
  tests::step_and_log(*undisturbed, before + after, alone);
  for (const bool is_batch : {true, false}) {
    const auto run = fleet.begun(2, is_batch);
    RunLog skipped, got, wanted;
    tests::step_and_log(*run, before, skipped);
    const twin::Run::Checkpoint then = run->checkpoint();
    ReadyRun larger = fleet.ready;
    twin::Run::Checkpoint with_all = then;
    for (const Newcomer& newcomer : one_of_each()) {
      const Command command = spawn(newcomer_yard, newcomer, 0, then_s);
      const ReadyNewcomer& ready = *std::get<Spawn>(command.what).ready;
      larger.agents.push_back(ready.agent);
      larger.states.push_back(ready.state);
      with_all.states.push_back(ready.state);
      run->enqueue(command);
    }
    RunSettings settings = tests::settings_of(step_s);
    settings.is_batch = is_batch;
    twin::Run had_them(larger.agents, larger.states, settings);
    had_them.restore(with_all);
    tests::step_and_log(*run, after, got);
    tests::step_and_log(had_them, after, wanted);
    tests::expect_same_bits(got, wanted, is_batch ? "in blocks" : "one by one");
    expect_same_states(run->states(), had_them.states(), "at the end");
    // Nor do the others notice who is far away.
    for (std::size_t i = 0; i < fleet.ready.agents.size(); ++i) {
      const std::span<const double> whole = alone.rows[i];
      EXPECT_TRUE(tests::same_bits(got.rows[i], whole.last(got.rows[i].size()))) << i;
    }
  }
}

/// Three that join at different steps, are driven and put elsewhere.
std::vector<Command> busy_hour(const NewcomerYard& newcomer_yard, std::size_t first) {
  std::vector<Command> commands{
      spawn(newcomer_yard, {"bluerov2_heavy", "one", {60, 60, 12}, 1}, 10, 0.5),
      spawn(newcomer_yard, {"wamv16", "two", {-40, 60, 0}, 2}, 10, 0.5)};
  commands.push_back({20, first, Reroute{{{{70, 70, 15}, 0.4}}}});
  commands.push_back({25, first + 1, SetThrusters{{0.4, 0.2}}});
  commands.push_back(spawn(newcomer_yard, {"bluerov2_heavy", "three", {3, 9, 12}, 1}, 30, 1.4));
  VehicleState<double> put = std::get<Spawn>(commands[0].what).ready->state.vehicle;
  put.body.position_m.y += 3;
  commands.push_back({35, first + 2, PutVehicle{put}});
  commands.push_back({40, 0, HoldHere{}});
  return commands;
}

/// As it comes back from a file.
Command read_again(const Command& command, const NewcomerYard& newcomer_yard) {
  Command again = command;
  again.what = what_of(name_of(command.what), numbers_of(command.what));
  if (auto* joins = std::get_if<Spawn>(&again.what)) {
    EXPECT_EQ(numbers_of(again.what), numbers_of(command.what));
    EXPECT_EQ(joins->newcomer.name, std::get<Spawn>(command.what).newcomer.name);
    joins->ready = newcomer_yard.ready(joins->newcomer, command.received_s);
  }
  return again;
}

TEST(Newcomers, MakeTheRunAgainFromItsRecordOnAnyThreads) {
  const Fleet fleet(tests::mixed_fleet());
  const auto run = fleet.begun();
  const std::size_t first = fleet.ready.agents.size();
  for (const Command& command : busy_hour(fleet.newcomer_yard(), first)) run->enqueue(command);
  RunLog made;
  tests::step_and_log(*run, 80, made);
  ASSERT_EQ(run->commands_taken().size(), 7U);
  EXPECT_EQ(made.rows.size(), first + 3);
  EXPECT_GT(run->states()[first].helm.way.waypoints_taken + 1, 0U);
  EXPECT_EQ(run->states()[first].helm.mode, HelmMode::waypoints);
  // Vehicles are read anew.
  NewcomerYard other(fleet.scenario, tests::source_folder() / "data", {}, fleet.ready.agents);
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const auto again = fleet.begun(threads, is_batch);
      for (const Command& command : run->commands_taken())
        again->enqueue(read_again(command, other));
      RunLog log;
      tests::step_and_log(*again, 80, log);
      tests::expect_same_bits(log, made, std::to_string(threads) + " threads");
      expect_same_states(again->states(), run->states(), "at the end");
    }
}

TEST(Newcomers, AreInACheckpointWhetherTheyJoinedOrAreOnTheirWay) {
  const Fleet fleet(tests::mixed_fleet());
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  const std::size_t first = fleet.ready.agents.size();
  const auto whole = fleet.begun();
  for (const Command& command : busy_hour(newcomer_yard, first)) whole->enqueue(command);
  RunLog skipped, expected;
  for (int i = 0; i < 5; ++i) whole->step();
  const twin::Run::Checkpoint none_there = whole->checkpoint();
  for (int i = 0; i < 20; ++i) whole->step();
  const twin::Run::Checkpoint two_there = whole->checkpoint();
  EXPECT_EQ(none_there.states.size(), first);
  EXPECT_EQ(two_there.states.size(), first + 2);
  tests::step_and_log(*whole, 60, expected);
  EXPECT_EQ(expected.rows.size(), first + 3);

  const auto second = fleet.begun(2, false);
  for (int i = 0; i < 3; ++i) second->step();
  RunLog got;
  second->restore(two_there);
  EXPECT_EQ(second->seen().size(), first + 2);
  tests::step_and_log(*second, 60, got);
  tests::expect_same_bits(got, expected, "another run");

  // The same run, back to when nobody had joined.
  whole->restore(none_there);
  EXPECT_EQ(whole->agents().size(), first);
  for (int i = 0; i < 20; ++i) whole->step();
  RunLog again;
  tests::step_and_log(*whole, 60, again);
  tests::expect_same_bits(again, expected, "the same run, back");
}

TEST(Newcomers, KeepTheirPlacesAndAreNobodys) {
  const Fleet fleet(tests::head(step_s) +
                    "  - {name: other, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                    "depth_m: 10}, tasks: [{do: hold}]}\n");
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  const auto run = fleet.begun();
  for (int i = 0; i < 40; ++i) run->step();
  for (const Newcomer& newcomer : one_of_each())
    run->enqueue(spawn(newcomer_yard, newcomer, 0, run->time_s()));
  for (int i = 0; i < 2400; ++i) run->step();
  const auto agents = run->agents();
  for (std::size_t i = 1; i < agents.size(); ++i) {
    const AgentState& state = run->states()[i];
    const Triple<double> off_m = state.vehicle.body.position_m - one_of_each()[i - 1].position_m;
    // Within their own length, or the circle of those that cannot stand still.
    const double most_m = std::max(2 * agents[i].vehicle->body.radius_m,
                                   2 * agents[i].autopilot->settings.holding_radius_m);
    EXPECT_LT(std::hypot(off_m.x, off_m.y), most_m) << agents[i].name;
    EXPECT_EQ(state.halt, Halt::none) << agents[i].name;
    EXPECT_FALSE(state.helm.is_helmed()) << agents[i].name;
    EXPECT_FALSE(state.mission.is_done) << agents[i].name;
    EXPECT_GT(state.vehicle.drawn_j + state.vehicle.fuel_kg, 0) << agents[i].name;
  }
}

TEST(Newcomers, AreGivenWayLikeAnybodyElse) {
  const auto closest_of = [](bool with_clearance) {
    const Fleet fleet(tests::calm_head(step_s) +
                      "  - {name: passing, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                      "depth_m: 10}, tasks: [{do: route, waypoints: [{north_m: 30, east_m: 0, "
                      "depth_m: 10}]}]}\n" +
                      (with_clearance ? "clearance: {craft_m: 2}\n" : ""));
    const auto run = fleet.begun();
    for (int i = 0; i < 20; ++i) run->step();
    run->enqueue(spawn(fleet.newcomer_yard(), {"bluerov2_heavy", "late", {15, 0.1, 10}, 0}, 0, 1));
    for (int i = 0; i < 1600; ++i) run->step();
    const auto states = run->states();
    EXPECT_EQ(states[0].nearest.vehicle.whom, 1);
    EXPECT_EQ(states[1].nearest.vehicle.whom, 0);
    EXPECT_NEAR(states[0].vehicle.body.position_m.x, 30, 2);
    return states[0].nearest.vehicle.distance_m;
  };
  const double hulls_m = 2 * Fleet(tests::calm_head(step_s) +
                                   "  - {name: a, model: bluerov2_heavy, start: {north_m: 0, "
                                   "east_m: 0, depth_m: 10}, tasks: [{do: hold}]}\n")
                                 .ready.agents[0]
                                 .vehicle->body.radius_m;
  EXPECT_GT(closest_of(true), 2 + hulls_m);
  EXPECT_LT(closest_of(false), 0.5);
}

TEST(Newcomers, OfAnotherTimeBeginInTheGustsOfThen) {
  const Fleet fleet(tests::mixed_fleet());
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  const Newcomer uav = one_of_each()[2];
  const auto then = newcomer_yard.ready(uav, 12), again = newcomer_yard.ready(uav, 12);
  EXPECT_EQ(std::memcmp(&then->state.gust, &again->state.gust, sizeof then->state.gust), 0);
  Newcomer other = uav;
  other.name = "other";
  const auto named = newcomer_yard.ready(other, 12);
  EXPECT_NE(std::memcmp(&then->state.gust, &named->state.gust, sizeof then->state.gust), 0)
      << "randomness comes from the name";
}

class Slip : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal(const Newcomer& newcomer, ErrorKind kind,
                                    double t_s = 0) const {
    try {
      (void)fleet_.newcomer_yard().ready(newcomer, t_s);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), kind) << e.message();
      return e.message();
    }
    return "taken";
  }
  Fleet fleet_{tests::head(step_s) +
               "  - {name: a, model: bluerov2_heavy, start: {north_m: 50, east_m: 0, depth_m: "
               "10}, tasks: [{do: hold}]}\n"
               "structures: [{name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, "
               "top_height_m: 20, bottom_depth_m: 60}]\n"};
};

TEST_F(Slip, KnowsTheCatalogueAndNoPaths) {
  const std::string folder = (tests::source_folder() / "data" / "vehicles").string();
  std::vector<std::string> there;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    there.push_back(entry.path().stem().string());
  std::sort(there.begin(), there.end());
  EXPECT_GE(there.size(), 5U);
  for (const std::string& model :
       {std::string(), std::string("../vehicles/x500"), std::string("/etc/passwd"),
        folder + "/x500.yaml", std::string("x500.yaml"), std::string("vehicles/x500"),
        std::string("x500.yaml\0", 10), std::string("x500\0", 5), std::string("X500"),
        std::string(100'000, 'x'), std::string("..")}) {
    const std::string text = refusal({model, "late", {30, 30, 10}, 0}, ErrorKind::not_found);
    EXPECT_NE(text.find(joined(there, ", ")), std::string::npos) << text;
    EXPECT_LT(text.size(), 300U);
  }
}

TEST_F(Slip, RefusesPlacesWhereTheVehicleCannotBe) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const auto says = [&](const char* model, const Triple<double>& at_m, const char* what,
                        double heading_rad = 0, double t_s = 0) {
    const std::string text =
        refusal({model, "late", at_m, heading_rad}, ErrorKind::invalid_input, t_s);
    EXPECT_NE(text.find(what), std::string::npos) << text << "; expected " << what;
  };
  says("bluerov2_heavy", {nan, 0, 10}, "found nan m north");
  says("bluerov2_heavy", {30, inf, 10}, "found inf m east");
  says("bluerov2_heavy", {30, 30, -inf}, "m down");
  says("bluerov2_heavy", {30, 30, 10}, "orientation", nan);
  says("bluerov2_heavy", {1e300, 0, 10}, "within 1e+06 m");
  says("bluerov2_heavy", {300e3, 0, 10}, "outside_area");
  says("bluerov2_heavy", {30, 30, 70}, "below_bed");
  says("bluerov2_heavy", {30, 30, -2}, "above the sea");
  says("bluerov2_heavy", {1, 1, 10}, "lies in pile");
  says("bluerov2_heavy", {30, 30, 10}, "outside_time", 0, 1e6);
  says("wamv16", {30, 30, -50}, "floats");
  says("ctv24", {30, 30, 20}, "floats");
  says("wamv16", {1, 1, 0}, "lies in pile");
  says("x500", {30, 30, 5}, "below the sea");
  EXPECT_EQ(refusal({"bluerov2_heavy", "late", {30, 30, 10}, 0}, ErrorKind::internal), "taken");
  EXPECT_EQ(refusal({"wamv16", "late", {30, 30, -1}, 0}, ErrorKind::internal), "taken");
}

TEST_F(Slip, AVehicleDeeperThanItIsRatedForIsRefused) {
  const NewcomerYard newcomer_yard = fleet_.newcomer_yard();
  const auto rated = newcomer_yard.ready({"bluerov2_heavy", "late", {30, 30, 10}, 0}, 0)
                         ->agent.vehicle->rated_depth_m;
  ASSERT_TRUE(rated.has_value());
  EXPECT_NE(refusal({"bluerov2_heavy", "late", {30, 30, *rated + 1}, 0}, ErrorKind::invalid_input)
                .find("rated for"),
            std::string::npos);
}

TEST(Newcomers, ForWhomThereIsNoRoomAreABug) {
  const Fleet fleet(tests::mixed_fleet());
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  twin::Run run(fleet.ready.agents, fleet.ready.states, tests::settings_of(step_s));
  EXPECT_EQ(run.most_vehicles(), fleet.ready.agents.size());
  EXPECT_THROW(run.enqueue(spawn(newcomer_yard, one_of_each()[0], 0)), ContractViolation);
  Command not_ready;
  not_ready.what = Spawn{one_of_each()[0], nullptr};
  const auto roomy = fleet.begun();
  EXPECT_THROW(roomy->enqueue(not_ready), ContractViolation);
  EXPECT_THROW(roomy->enqueue({0, fleet.ready.agents.size(), HoldHere{}}), ContractViolation);
  // For one that is on its way there may be commands.
  roomy->enqueue(spawn(newcomer_yard, one_of_each()[0], 3));
  roomy->enqueue({5, fleet.ready.agents.size(), HoldHere{}});
  for (int i = 0; i < 10; ++i) roomy->step();
  EXPECT_EQ(roomy->states().back().helm.mode, HelmMode::hold);
}

TEST(Newcomers, StayWhereTheyAreInMemory) {
  const Fleet fleet(tests::mixed_fleet());
  const NewcomerYard newcomer_yard = fleet.newcomer_yard();
  const auto run = fleet.begun();
  const Agent* const agents = run->agents().data();
  const AgentState* const states = run->states().data();
  for (int i = 0; i < 8; ++i)
    run->enqueue(spawn(newcomer_yard,
                       {"bluerov2_heavy", "late" + std::to_string(i), {200.0 + 5 * i, 0, 20}, 0},
                       static_cast<std::uint64_t>(i)));
  for (int i = 0; i < 10; ++i) run->step();
  EXPECT_EQ(run->agents().size(), fleet.ready.agents.size() + 8);
  EXPECT_EQ(run->agents().data(), agents);
  EXPECT_EQ(run->states().data(), states);
}

TEST(RunLog, HasNoNumbersOfAVehicleBeforeItJoined) {
  const Fleet fleet(tests::mixed_fleet());
  const auto run = fleet.begun();
  const std::size_t late = fleet.ready.agents.size();
  run->enqueue(spawn(fleet.newcomer_yard(), one_of_each()[0], 12));
  RunLog log;
  tests::step_and_log(*run, 30, log);
  EXPECT_EQ(log.first_time(0), 0U);
  EXPECT_EQ(log.first_time(late), 12U);
  const std::vector<double> x = log.column(late, "x"), halt = log.column(late, "halt");
  ASSERT_EQ(x.size(), log.t_s.size());
  for (std::size_t t = 0; t < x.size(); ++t) {
    EXPECT_EQ(std::isnan(x[t]), t < 12) << t;
    EXPECT_EQ(std::isnan(halt[t]), t < 12) << t;
  }
  EXPECT_NEAR(x[12], 300, 0.1);
}

}  // namespace
}  // namespace slackwater::twin::newcomer_test
