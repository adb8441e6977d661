// A live run for robots, with its clients as processes of their own: twenty vehicles at 100 Hz with
// five subscribers and a recording, beside an empty loop and the same run that tells nobody; two
// hundred with their state at 10 Hz; an agent in lock-step; from a command to the moved state, by
// thrusters and by cmd_vel; the longest lists of waypoints; a profile to fifty readers; a camera on
// one of two vehicles. Half a minute of each; SLACKWATER_LIVE_SECONDS=600 for the whole (make
// soak).
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>
#include <thread>

#include "api/door/live/live_run.h"
#include "api/door/live/topics/recording_outlet.h"
#include "data/bag/bag.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/live_clients.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

/// Of this process alone.
int domain_number() {
  static const tests::OwnDomain own;
  return own.number();
}

double seconds_asked(bool check_only) {
  if (check_only) return 1;
  const char* asked = std::getenv("SLACKWATER_LIVE_SECONDS");
  return asked == nullptr ? 30 : std::strtod(asked, nullptr);
}

/// ROVs with their instruments on a grid, each on a round of its own, in current and waves.
twin::Scenario fleet(int vehicles, double step_s, double duration_s, bool has_sensors) {
  std::string yaml = tests::head(step_s,
                                 "{partitions: [{significant_height_m: 0.5, "
                                 "peak_period_s: 5, from_deg: 250}], components: 16}");
  for (int i = 0; i < vehicles; ++i) {
    const std::string north = std::to_string(30 * (i / 20)), east = std::to_string(30 * (i % 20));
    yaml += "  - {name: v" + std::to_string(i) +
            ", model: bluerov2_heavy, start: {north_m: " + north + ", east_m: " + east +
            ", depth_m: 10}, speed_m_s: 0.4, tasks: [{do: orbit, "
            "centre: {north_m: " +
            north + ", east_m: " + east +
            ", depth_m: 10}, radius_m: 5, from_deg: 0, turns: 99}]}\n";
  }
  if (has_sensors) yaml += "log: {sensors: true}\n";
  twin::Scenario scenario = twin::parse_scenario(yaml, "bench.yaml");
  scenario.duration_s = duration_s;
  scenario.log_every_s = 10;
  return scenario;
}

struct Live {
  live::LiveSettings settings;
  double factor = 1;
  std::function<void(const api::RunInHand&)> also{};
  std::vector<ClientProcess*> subscribers{};  ///< it begins when they have met its vehicles
};

struct Ran {
  live::Punctuality punctuality{0};
  double wall_s = 0;
  double simulated_s = 0;
  std::uint64_t steps = 0;
  std::vector<live::SensorTold> seen{};
};

Ran run(const twin::Scenario& scenario, Live how) {
  api::ScenarioWater water;
  water.surround = tests::surround_of(scenario);
  api::RunChoice choice{1, true, how.factor};
  std::unique_ptr<live::LiveRun> joined;
  how.settings.real_time_factor = how.factor;
  Ran ran;
  choice.on_ready = [&](const api::RunInHand& hand) {
    joined = std::make_unique<live::LiveRun>(hand, how.settings);
    hand.run.at_barrier([&](const twin::StepTime&) { ++ran.steps; });
    if (how.also) how.also(hand);
    for (ClientProcess* subscriber : how.subscribers) subscriber->wait_for_line();
  };
  choice.on_over = [&] {
    ran.punctuality = joined->punctuality();
    ran.seen = joined->end_sensors();
    joined.reset();
  };
  const api::ScenarioResult result = api::run_scenario(scenario, water, choice);
  ran.wall_s = result.wall_s;
  ran.simulated_s = result.account.ran_s;
  return ran;
}

live::LiveSettings on_loopback() {
  live::LiveSettings settings;
  settings.domain.emplace();
  settings.domain->domain = domain_number();
  settings.domain->is_loopback_only = true;
  return settings;
}

double late_share(const Ran& ran) {
  return static_cast<double>(ran.punctuality.late_steps()) /
         static_cast<double>(std::max<std::uint64_t>(ran.punctuality.steps(), 1));
}

/// Of each step of each vehicle, but for what a reader of the last ten may lose.
void check_heard(BenchReport& report, const std::string& what, ClientProcess& subscriber,
                 std::uint64_t steps, std::size_t topics) {
  std::string printed = subscriber.asked_result();
  printed.erase(std::min(printed.find_last_not_of(" \n") + 1, printed.size()));
  std::istringstream counts(printed);
  std::size_t good = 0;
  for (std::uint64_t heard = 0; good < topics && counts >> heard && heard <= steps + 1 &&
                                static_cast<double>(heard) >= 0.95 * static_cast<double>(steps);)
    ++good;
  report.answer(what + " hears 95 % of the steps on every topic", good == topics,
                "odometry, pose, imu of " + std::to_string(steps) + " steps: " + printed);
}

/// What the machine itself does to a clock at that pace, at that time.
void report_empty_loop(BenchReport& report, const std::string& printed) {
  std::istringstream words(printed);
  double late = -1, steps = 0;
  std::string text;
  std::getline(words >> late >> steps >> std::ws, text);
  report.answer("an empty loop keeps the pace beside it", steps > 0 && late >= 0, text);
  report.figure({"an empty loop beside it", "%", {100 * late / steps}, std::nullopt, text});
}

void twenty_at_100_hz(BenchReport& report) {
  const double length_s = seconds_asked(report.options().check_only);
  const twin::Scenario scenario = fleet(20, 0.01, length_s, true);
  const tests::TemporaryFolder folder;
  std::uint64_t recorded = 0;
  Ran told;
  std::string empty;
  const double cpu_before_s = ClientProcess::children_cpu_s();
  {
    std::vector<std::unique_ptr<ClientProcess>> subscribers;
    for (int i = 0; i < 5; ++i)
      subscribers.push_back(std::make_unique<ClientProcess>(
          std::vector<std::string>{"hear", std::to_string(domain_number()), "20"}));
    Live how{on_loopback()};
    const auto recording = std::make_shared<live::RecordingOutlet>(
        folder / "run.mcap", [](const std::string& text) { throw std::runtime_error(text); });
    how.settings.outlets.push_back(recording);
    for (const auto& subscriber : subscribers) how.subscribers.push_back(subscriber.get());
    std::unique_ptr<ClientProcess> empty_loop;
    how.also = [&](const api::RunInHand&) {
      empty_loop = std::make_unique<ClientProcess>(
          std::vector<std::string>{"pace", std::to_string(scenario.step_s)});
      empty_loop->wait_for_line();
    };
    told = run(scenario, std::move(how));
    empty = empty_loop->asked_result();
    for (std::size_t i = 0; i < subscribers.size(); ++i)
      check_heard(report, "subscriber " + std::to_string(i + 1) + " of five", *subscribers[i],
                  told.steps, 3);
    recorded = recording->close();
  }
  const double clients_s = ClientProcess::children_cpu_s() - cpu_before_s;
  twin::Scenario a_minute = scenario;
  a_minute.duration_s = std::min(length_s, 60.0);
  const Ran alone = run(a_minute, {});
  std::size_t poses = 0;
  const auto bag = bag::open_bag(folder / "run.mcap");
  while (const auto message = bag->next())
    poses += bag->channels()[message->channel].topic == "/v7/pose" ? 1U : 0U;
  // One before the first step.
  report.answer("each pose of twenty vehicles at 100 Hz is recorded", poses == told.steps + 1,
                std::to_string(poses) + " of v7 in " + std::to_string(told.steps) + " steps, " +
                    std::to_string(recorded) + " messages");
  report.figure(
      {"20 vehicles at 100 Hz, DDS to 5 processes, recorded: steps that began > 10 ms late",
       "%",
       {100 * late_share(told)},
       0.1,
       told.punctuality.text() + "; clients " +
           std::to_string(clients_s / std::max(told.wall_s, 1e-9)) + " cores"});
  report_empty_loop(report, empty);
  report.figure({"the same run that tells nobody, a minute at most",
                 "%",
                 {100 * late_share(alone)},
                 std::nullopt,
                 alone.punctuality.text()});
}

/// Two hundred that step ten times a second tell of themselves ten times a second.
void two_hundred(BenchReport& report) {
  const twin::Scenario scenario = fleet(200, 0.1, report.options().check_only ? 2 : 600, false);
  ClientProcess subscriber({"hear", std::to_string(domain_number()), "200"});
  const Ran ran = run(scenario, {on_loopback(), 0, {}, {&subscriber}});
  check_heard(report, "the subscriber of 200 vehicles", subscriber, ran.steps, 2);  // no sensors
  report.answer("200 vehicles run to their end", ran.simulated_s == scenario.duration_s,
                std::to_string(ran.simulated_s) + " s");
  report.figure({"200 vehicles, state at 10 Hz on DDS to a process",
                 "x real time",
                 {ran.simulated_s / ran.wall_s},
                 std::nullopt,
                 "",
                 5});
}

void agent_in_lock_step(BenchReport& report) {
  const twin::Scenario scenario = fleet(1, 0.05, report.options().check_only ? 20 : 600, false);
  const ClientProcess agent({"agent", std::to_string(domain_number())});
  std::uint64_t hosted = 0;
  double from_s = 0, until_s = 0;
  Live how{on_loopback(), 0};
  twin::CommandArbiter* arbiter = nullptr;
  how.also = [&](const api::RunInHand& hand) {
    arbiter = &hand.arbiter;
    // It begins once the agent has asked for the vehicle.
    hand.run.at_opening([&](const twin::StepTime&) {
      while (arbiter->holder(0).empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      if (hosted++ == 0) from_s = monotonic_s();
      until_s = monotonic_s();
    });
  };
  const Ran ran = run(scenario, std::move(how));
  report.answer("all steps are made with the agent", hosted == ran.steps,
                std::to_string(hosted) + " of " + std::to_string(ran.steps));
  report.figure({"an agent in another process, in lock-step over DDS",
                 "steps/s",
                 {static_cast<double>(hosted) / (until_s - from_s)},
                 std::nullopt,
                 "",
                 2000});
}

struct Percentiles {
  double half_s = -1, p99_s = -1;
  std::size_t count = 0;
};
Percentiles percentiles_of(const std::string& printed) {
  Percentiles p;
  std::istringstream(printed) >> p.half_s >> p.p99_s >> p.count;
  return p;
}

/// A client in that role, beside a run that ends with it. @return what it printed
std::string printed_beside(const twin::Scenario& scenario, const std::vector<std::string>& role) {
  ClientProcess client(role);
  std::string printed;
  std::atomic<bool> is_over{false};
  std::thread waiter([&] {
    printed = client.result();
    is_over = true;
  });
  Live how{on_loopback(), 1};
  how.also = [&](const api::RunInHand& hand) {
    hand.run.at_barrier([&, &control = hand.control](const twin::StepTime&) {
      if (is_over) control.stop();
    });
  };
  (void)run(scenario, std::move(how));
  if (!is_over) client.end();
  waiter.join();
  return printed;
}

void thrusters_to_moved_state(BenchReport& report) {
  const int trials = report.options().check_only ? 3 : 200;
  const std::string printed =
      printed_beside(fleet(1, 0.02, 600, false),
                     {"push", std::to_string(domain_number()), std::to_string(trials)});
  const Percentiles p = percentiles_of(printed);
  report.answer("each push is seen", p.count == static_cast<std::size_t>(trials), printed);
  report.figure({"from a thruster command to the odometry that shows it, 50 Hz, p99",
                 "ms",
                 {1000 * p.p99_s},
                 50,
                 "median " + std::to_string(1000 * p.half_s) + " ms"});
}

/// An ROV that holds its place in still water.
twin::Scenario still_vehicle(double step_s) {
  twin::Scenario scenario = twin::parse_scenario(
      tests::calm_head(step_s) +
          "  - {name: v0, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
          "tasks: [{do: hold}]}\n",
      "bench.yaml");
  scenario.duration_s = 1200;
  return scenario;
}

/// What the client `steer` does, without a wire: how long the vehicle itself takes, on its way,
/// from the opening at which it is asked for more until it is so much faster.
double own_response_s(const twin::Scenario& scenario) {
  constexpr std::uint64_t asked_at = 1000, renewed_every = 5;
  std::uint64_t took = 0;
  double before_m_s = 0;
  Live how{{}, 0};
  how.also = [&](const api::RunInHand& hand) {
    const auto surge_m_s = [&run = hand.run] { return run.states()[0].vehicle.body.nu.linear.x; };
    hand.run.at_opening([&, surge_m_s, &arbiter = hand.arbiter](const twin::StepTime& time) {
      if (time.step == asked_at) before_m_s = surge_m_s();
      if (time.step % renewed_every != 0) return;
      twin::Command command;
      const double faster_m_s = time.step < asked_at ? 0 : steered_by_m_s;
      command.what = twin::SetVelocity{{steered_m_s + faster_m_s, 0, 0, 0}};
      command.sequence = time.step + 1;
      command.received_s = arbiter.time_s();
      (void)arbiter.submit("bench", std::move(command), arbiter.time_s());
    });
    hand.run.at_barrier([&, surge_m_s, &control = hand.control](const twin::StepTime& time) {
      if (time.step < asked_at || surge_m_s() - before_m_s <= steered_shows_m_s) return;
      took = time.step + 1 - asked_at;
      control.stop();
    });
  };
  (void)run(scenario, std::move(how));
  return took > 0 ? static_cast<double>(took) * scenario.step_s : -1;
}

/// What is asked of a velocity is eased by the autopilot and answered by its loop, before any
/// thruster of it comes up: most of what is measured is the vehicle's own.
void velocity_to_moved_state(BenchReport& report) {
  constexpr double step_s = 0.02;
  const int trials = report.options().check_only ? 3 : 30;
  const twin::Scenario scenario = still_vehicle(step_s);
  const double own_s = own_response_s(scenario);
  const std::string printed =
      printed_beside(scenario, {"steer", std::to_string(domain_number()), std::to_string(trials)});
  const Percentiles p = percentiles_of(printed);
  report.answer("each velocity asked for is seen", p.count == static_cast<std::size_t>(trials),
                printed);
  // A step is made as soon as it is due: what n of them show is there n - 1 after the first.
  report.answer("it takes what the vehicle itself takes, within two steps",
                own_s > 0 && p.half_s >= own_s - step_s && p.half_s <= own_s + 2 * step_s,
                std::to_string(1000 * own_s) + " ms of its own, median " +
                    std::to_string(1000 * p.half_s) + " ms");
  report.figure({"from cmd_vel to the odometry that shows it, 50 Hz, p99",
                 "ms",
                 {1000 * p.p99_s},
                 std::nullopt,
                 "median " + std::to_string(1000 * p.half_s) + " ms, of it " +
                     std::to_string(1000 * own_s) + " ms the vehicle's own"});
}

/// Two clients send the longest lists there are beside a monopile; one of them is at the helm.
void long_lists(BenchReport& report) {
  constexpr std::uint64_t enough = 20;
  const bool check_only = report.options().check_only;
  twin::Scenario scenario = fleet(1, 0.01, check_only ? 60 : 30, false);
  scenario.structures.push_back({.name = "monopile",
                                 .kind = twin::ScenarioStructure::Kind::cylinder,
                                 .centre_m = {0, 40, 0},
                                 .diameter_m = 6,
                                 .size_m = {},
                                 .top_m = -20,
                                 .bottom_m = 60});
  std::uint64_t taken = 0, refused = 0;
  Live how{on_loopback()};
  how.also = [&](const api::RunInHand& hand) {
    hand.run.at_barrier([&, &arbiter = hand.arbiter, &control = hand.control](const auto&) {
      taken = arbiter.taken(0);
      refused = 0;
      for (const twin::RefusalCount& of : arbiter.refusals())
        if (of.reason == twin::RefusalReason::unauthorised) refused += of.count;
      if (check_only && taken >= enough && refused >= enough) control.stop();
    });
  };
  const ClientProcess one({"lists", std::to_string(domain_number())});
  const ClientProcess other({"lists", std::to_string(domain_number())});
  const Ran ran = run(scenario, std::move(how));
  report.answer("lists of 10 000 places are taken from one client and refused to the other",
                taken >= enough && refused >= enough,
                std::to_string(taken) + " taken, " + std::to_string(refused) + " refused");
  report.figure(
      {"100 Hz, with lists of 10 000 waypoints from two clients, ten a second each: steps "
       "that began > 10 ms late",
       "%",
       {100 * late_share(ran)},
       0.1,
       ran.punctuality.text()});
}

void profile_to_fifty(BenchReport& report) {
  const std::size_t count = report.options().check_only ? 3 : 50;
  ClientProcess readers({"readers", std::to_string(domain_number()), std::to_string(count)});
  dds::DomainSettings settings = *on_loopback().domain;
  dds::Participant participant(settings);
  const auto writer = participant.publish_on(
      {"/bench/current_profile", "slackwater_msgs/msg/CurrentProfile", "", live::latched_quality});
  std::string printed;
  std::atomic<bool> is_over{false};
  std::thread waiter([&] {
    printed = readers.result();
    is_over = true;
  });
  dds::Bytes message(7 * 50 * 8 + 200);  // fifty levels
  message[1] = 1;
  while (!is_over) {
    const double now_s = monotonic_s();
    std::memcpy(message.data() + 4, &now_s, sizeof now_s);
    participant.send(writer, message);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  waiter.join();
  const Percentiles p = percentiles_of(printed);
  report.answer("a thousand to each reader", p.count >= 1000 * count, printed);
  report.figure({"a profile of 50 levels to 50 readers of another process, p99",
                 "ms",
                 {1000 * p.p99_s},
                 5,
                 "median " + std::to_string(1000 * p.half_s) + " ms"});
}

/// Two vehicles beside a pile, recorded; one of them has a camera of 640 x 360 at 2 Hz.
void camera_beside(BenchReport& report) {
  const double length_s = report.options().check_only ? 3 : seconds_asked(false);
  twin::Scenario scenario = fleet(2, 0.05, length_s, true);
  scenario.structures.push_back({.name = "monopile",
                                 .kind = twin::ScenarioStructure::Kind::cylinder,
                                 .centre_m = {12, 0, 0},
                                 .diameter_m = 6,
                                 .size_m = {},
                                 .top_m = -20,
                                 .bottom_m = 60});
  const tests::TemporaryFolder folder;
  const auto recording =
      std::make_shared<live::RecordingOutlet>(folder / "seen.mcap", [](const std::string&) {});
  Live how;
  how.settings.see.sensors = {{"v0", "rov_camera", 2}};
  how.settings.outlets.push_back(recording);
  double from_s = -1, to_s = 0;
  how.also = [&](const api::RunInHand& hand) {
    hand.run.at_barrier([&](const twin::StepTime&) {
      to_s = monotonic_s();
      if (from_s < 0) from_s = to_s;
    });
  };
  const Ran ran = run(scenario, std::move(how));
  const live::LooksMade& made = ran.seen.at(0).made;
  const double pace = (ran.simulated_s - scenario.step_s) / (to_s - from_s);
  report.answer("each picture is seen or counted as left out",
                made.moments == static_cast<std::uint64_t>(2 * length_s) + 1 && made.looks >= 2 &&
                    made.moments == made.looks + made.dropped,
                ran.seen[0].text());
  report.answer("a run with a camera keeps its pace", pace > 0.95 && pace < 1.05,
                std::to_string(pace) + " times the clock; " + ran.punctuality.text());
  report.figure({"two vehicles at 20 Hz, one with a camera at 2 Hz: pace of the run",
                 "of the clock",
                 {pace},
                 std::nullopt,
                 ran.punctuality.text(),
                 0.99});
  report.figure({"the same: pictures left out",
                 "%",
                 {100 * static_cast<double>(made.dropped) / static_cast<double>(made.moments)},
                 1,
                 ran.seen[0].text()});
  report.figure({"the same: from a moment to its picture",
                 "ms",
                 {1000 * made.mean_s()},
                 500,
                 std::to_string(1000 * made.worst_s) + " ms at worst"});
}

void all(BenchReport& report) {
  twenty_at_100_hz(report);
  two_hundred(report);
  agent_in_lock_step(report);
  thrusters_to_moved_state(report);
  velocity_to_moved_state(report);
  long_lists(report);
  profile_to_fifty(report);
  camera_beside(report);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "--client")
    return live_client(std::vector<std::string>(argv + 2, argv + argc));
  return run_bench(argc, argv, "live", all);
}
