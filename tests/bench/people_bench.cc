// A session of people: twenty vehicles at 100 Hz with twenty spectators and three operators who
// drive twenty times a second, beside the same run alone; from a thruster command to the frame that
// shows it; what a station is sent, and twenty of fifty vehicles in waves. Half a minute;
// SLACKWATER_PEOPLE_SECONDS for more.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/door/live/punctuality.h"
#include "tests/api/door/people/fleet_in_waves.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/bench/bench_report.h"
#include "tests/twin/run/run_for_tests.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;
using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;
using tests::SessionUnderWay;
using tests::StationClient;
using Clock = std::chrono::steady_clock;

double seconds_asked(bool check_only) {
  if (check_only) return 2;
  const char* asked = std::getenv("SLACKWATER_PEOPLE_SECONDS");
  return asked == nullptr ? 30 : std::strtod(asked, nullptr);
}

/// ROVs that hold their places on a grid.
std::string fleet(int vehicles, double step_s) {
  std::string yaml = tests::head(step_s);
  for (int i = 0; i < vehicles; ++i)
    yaml += "  - {name: v" + std::to_string(i) +
            ", model: bluerov2_heavy, start: {north_m: " + std::to_string(40 * (i / 5)) +
            ", east_m: " + std::to_string(40 * (i % 5)) + ", depth_m: 10}, tasks: [{do: hold}]}\n";
  return yaml;
}

people::TokenBook crowd() { return people::TokenBook::drawn(UtcTime::max()); }

struct Watched {
  live::Punctuality punctuality{1};
  SessionUnderWay::Choice choice() {
    SessionUnderWay::Choice choice{1, crowd(), {}};
    choice.also = [this](const api::RunInHand& hand) {
      hand.run.at_opening([this, &control = hand.control](const twin::StepTime&) {
        punctuality.begin(control.due(), Clock::now());
      });
    };
    return choice;
  }
  [[nodiscard]] double late_share() const {
    return static_cast<double>(punctuality.late_steps()) /
           static_cast<double>(std::max<std::uint64_t>(punctuality.steps(), 1));
  }
};

/// Sits and looks on until it is over.
struct Spectator {
  Spectator(const SessionUnderWay& run, const std::atomic<bool>& over, bool is_brief = false)
      : station(run, run.token(Role::looks_on)), thread([this, &over, is_brief] {
          (void)station.hello("a spectator", is_brief);
          is_in = true;
          while (!over) {
            station.listen(100ms);
            wire_bytes = station.wire_bytes;
            frames += station.frames.size();
            station.frames.clear();
            station.messages.clear();
          }
        }) {}
  StationClient station;
  std::atomic<bool> is_in = false;
  std::atomic<std::size_t> frames = 0, wire_bytes = 0;
  std::thread thread;
};

/// Drives a vehicle of its own by stick, twenty times a second.
struct Operator {
  Operator(const SessionUnderWay& run, int vehicle, const std::atomic<bool>& over)
      : station(run, run.token(Role::drives)), thread([this, vehicle, &over] {
          (void)station.hello("an operator");
          (void)station.asks({{"do", "ask"}, {"vehicle", vehicle}});
          station.messages.clear();
          while (!over) {
            station.says(station.command("stick", vehicle, {{"velocity", {0.2, 0, 0, 0.1}}}));
            ++commands;
            station.listen(50ms);
            for (const json& message : station.messages)
              taken += message["is"] == "answer" && message["taken"] == true ? 1U : 0U;
            station.frames.clear();
            station.messages.clear();
          }
        }) {}
  StationClient station;
  std::size_t commands = 0, taken = 0;
  std::thread thread;
};

void a_full_session(BenchReport& report) {
  const double length_s = seconds_asked(report.options().check_only);
  Watched watched, alone;
  {
    SessionUnderWay run(fleet(20, 0.01), alone.choice());
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(length_s, 30.0)));
  }
  std::size_t frames = 0, bytes = 0, commands = 0, taken = 0, least = SIZE_MAX;
  {
    SessionUnderWay run(fleet(20, 0.01), watched.choice());
    std::atomic<bool> over = false;
    std::vector<std::unique_ptr<Spectator>> spectators;
    spectators.reserve(20);
    for (int i = 0; i < 20; ++i) spectators.push_back(std::make_unique<Spectator>(run, over));
    std::vector<std::unique_ptr<Operator>> operators;
    operators.reserve(3);
    for (int i = 0; i < 3; ++i) operators.push_back(std::make_unique<Operator>(run, i, over));
    std::this_thread::sleep_for(std::chrono::duration<double>(length_s));
    over = true;
    for (const auto& spectator : spectators) {
      spectator->thread.join();
      frames += spectator->frames;
      bytes += spectator->station.received_bytes;
      least = std::min(least, spectator->frames.load());
    }
    for (const auto& one : operators) {
      one->thread.join();
      commands += one->commands;
      taken += one->taken;
    }
  }
  report.answer("each spectator sees at least 18 frames a second",
                static_cast<double>(least) >= 18 * (length_s - 1),
                std::to_string(least) + " frames in " + std::to_string(length_s) + " s");
  report.answer("each stick is taken", taken >= commands - 6 && commands > 0,
                std::to_string(taken) + " of " + std::to_string(commands));
  report.figure(
      {"20 vehicles at 100 Hz, 20 spectators and 3 operators at 20 Hz: steps that began "
       "> 10 ms late",
       "%",
       {100 * watched.late_share()},
       0.1,
       watched.punctuality.text()});
  report.figure({"the same run with nobody there",
                 "%",
                 {100 * alone.late_share()},
                 std::nullopt,
                 alone.punctuality.text()});
  report.figure({"what a spectator of twenty vehicles is sent, frames and messages",
                 "kB/s",
                 {static_cast<double>(bytes) / 20 / length_s / 1000},
                 std::nullopt,
                 std::to_string(frames / 20) + " frames"});
}

/// The speed of vehicle 0 in a frame; no number where it is not in it.
double speed_in(const std::string& bytes) {
  const auto* frame = session::GetFrame(reinterpret_cast<const std::uint8_t*>(bytes.data()));
  for (const auto* pose : *frame->poses())
    if (pose->vehicle() == 0) return std::hypot(pose->east_m_s(), pose->north_m_s());
  return std::nan("");
}

/// Of a vehicle that is no longer at rest; frames tell speeds to 0.005 m/s.
constexpr double moves_m_s = 0.006;

/// Pushes a vehicle at rest and waits for the first frame in which it moves.
void from_command_to_frame(BenchReport& report) {
  const int pushes = report.options().check_only ? 3 : 100;
  SessionUnderWay run(tests::calm_head(0.01) +
                          "  - {name: v0, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                          "depth_m: 10}, tasks: [{do: hold}]}\n"
                          "  - {name: v1, model: bluerov2_heavy, start: {north_m: 40, east_m: 0, "
                          "depth_m: 10}, tasks: [{do: hold}]}\n",
                      {1, crowd(), {}});
  StationClient pilot(run, run.token(Role::drives));
  (void)pilot.hello("pilot");
  (void)pilot.asks({{"do", "ask"}, {"vehicle", 0}});
  (void)pilot.asks({{"do", "raw"}, {"vehicle", 0}, {"is_on", true}});
  std::vector<double> waits_ms;
  const auto began = Clock::now();
  const std::size_t bytes_before = pilot.received_bytes;
  const auto push = [&](double share) {
    pilot.says(
        pilot.command("thrusters", 0, {{"share", {share, share, -share, -share, 0, 0, 0, 0}}}));
  };
  for (int i = 0; i < pushes; ++i) {
    (void)pilot.asks(pilot.command("hold", 0));
    // At rest, and at another moment of the twentieth of a second each time.
    pilot.listen(1200ms + std::chrono::milliseconds(7 * i % 50));
    pilot.frames.clear();
    pilot.messages.clear();
    const auto asked = Clock::now();
    push(i % 2 == 0 ? 0.6 : -0.6);
    bool is_seen = false;
    while (!is_seen && Clock::now() < asked + 1s) {
      pilot.listen(2ms);
      for (const std::string& frame : pilot.frames)
        is_seen = is_seen || speed_in(frame) > moves_m_s;
    }
    if (is_seen)
      waits_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - asked).count());
  }
  const double length_s = std::chrono::duration<double>(Clock::now() - began).count();
  std::sort(waits_ms.begin(), waits_ms.end());
  report.answer("each push is seen", waits_ms.size() == static_cast<std::size_t>(pushes),
                std::to_string(waits_ms.size()) + " of " + std::to_string(pushes));
  if (waits_ms.empty()) return;
  const double p99 =
      waits_ms[static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(waits_ms.size()))) -
               1];
  report.figure({"from a thruster command to the frame that shows it, p99",
                 "ms",
                 {p99},
                 80,
                 "median " + std::to_string(waits_ms[waits_ms.size() / 2]) + " ms"});
  report.figure({"what a station of two vehicles is sent, frames and messages",
                 "kB/s",
                 {static_cast<double>(pilot.received_bytes - bytes_before) / length_s / 1000},
                 20,
                 "one of them driven"});
}

/// Fifty vehicles in waves at 20 Hz, and twenty who look at the scene, as the page does.
void fifty_in_waves(BenchReport& report) {
  const double length_s = std::min(seconds_asked(report.options().check_only), 30.0);
  std::size_t bytes = 0, frames = 0, least = SIZE_MAX;
  double took_s = 0;
  std::vector<std::vector<people::Pose>> seen;  // at each twentieth of a second
  SessionUnderWay::Choice choice{1, crowd(), {}};
  std::shared_ptr<people::RunLook> look;
  choice.also = [&](const api::RunInHand& hand) {
    look = std::make_shared<people::RunLook>(hand);
    hand.run.at_barrier([&](const twin::StepTime&) {
      std::vector<people::Pose> poses;
      for (const people::VehicleNow& vehicle : look->look().vehicles) poses.push_back(vehicle.pose);
      seen.push_back(std::move(poses));
    });
  };
  {
    SessionUnderWay run(tests::fleet_in_waves(50, 0.05), choice);
    std::atomic<bool> over = false;
    std::vector<std::unique_ptr<Spectator>> spectators;
    spectators.reserve(20);
    for (int i = 0; i < 20; ++i) spectators.push_back(std::make_unique<Spectator>(run, over, true));
    while (!std::all_of(spectators.begin(), spectators.end(),
                        [](const auto& spectator) { return spectator->is_in.load(); }))
      std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(500ms);  // and what each is told of the others
    std::vector<std::size_t> frames_before;
    for (const auto& spectator : spectators) {
      frames_before.push_back(spectator->frames);
      bytes -= spectator->wire_bytes;
    }
    const auto from = Clock::now();
    std::this_thread::sleep_for(std::chrono::duration<double>(length_s));
    for (std::size_t i = 0; i < spectators.size(); ++i) {
      least = std::min(least, spectators[i]->frames - frames_before[i]);
      frames += spectators[i]->frames - frames_before[i];
      bytes += spectators[i]->wire_bytes;
    }
    took_s = std::chrono::duration<double>(Clock::now() - from).count();
    over = true;
    for (const auto& spectator : spectators) spectator->thread.join();
    (void)run.ended();
  }
  report.answer("each spectator of fifty vehicles sees at least 18 frames a second",
                static_cast<double>(least) >= 18 * (length_s - 1),
                std::to_string(least) + " frames in " + std::to_string(length_s) + " s");
  report.figure({"20 spectators of 50 vehicles in waves at 20 Hz, all that is sent to them",
                 "kB/s",
                 {static_cast<double>(bytes) / took_s / 1000},
                 300,
                 std::to_string(frames / 20) + " frames each"});
  // The same motion again, told to twenty by one thread.
  std::vector<people::FrameFlow> flows(20);
  for (people::FrameFlow& flow : flows) flow.be_brief(true);
  std::size_t of_frames = 0;
  const auto began = Clock::now();
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (people::FrameFlow& flow : flows) {
      people::FrameHead head;
      head.time_s = 0.05 * static_cast<double>(i);
      head.clock_ms = 50 * i;
      of_frames += flow.next(seen[i], head).size();
      (void)flow.saw(static_cast<std::uint32_t>(i + 1));
    }
  const double made_s = std::chrono::duration<double>(Clock::now() - began).count();
  const double at_20_hz_s = 0.05 * static_cast<double>(std::max<std::size_t>(seen.size(), 1));
  report.figure(
      {"making their frames, of one core",
       "%",
       {100 * made_s / at_20_hz_s},
       std::nullopt,
       std::to_string(of_frames / std::max<std::size_t>(20 * seen.size(), 1)) + " bytes a frame"});
}

void sessions(BenchReport& report) {
  a_full_session(report);
  from_command_to_frame(report);
  fifty_in_waves(report);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "people", sessions); }
