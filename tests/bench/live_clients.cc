#include "tests/bench/live_clients.h"

#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <deque>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "api/door/dds/message/vehicle_messages.h"
#include "api/door/dds/participant.h"
#include "api/door/live/punctuality.h"

extern char** environ;

namespace slackwater::bench {
namespace {

using namespace std::chrono_literals;

dds::DomainSettings loopback(const std::string& domain) {
  dds::DomainSettings settings;
  settings.domain = std::stoi(domain);
  settings.is_loopback_only = true;
  settings.node = "client";
  return settings;
}

template <typename T>
T read_at(dds::Payload message, std::size_t offset) {
  T value{};
  if (message.size() >= offset + sizeof value)
    std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}
template <typename T>
void write_at(dds::Bytes& message, std::size_t offset, T value) {
  message.resize(std::max(message.size(), offset + sizeof value));
  std::memcpy(message.data() + offset, &value, sizeof value);
}

/// By the nearest rank: so great a share of all is no more than that.
void print_percentiles(std::vector<double>& samples) {
  std::sort(samples.begin(), samples.end());
  const auto at = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(samples.size()));
    return samples.empty() ? -1 : samples[static_cast<std::size_t>(rank) - 1];
  };
  std::printf("%.9f %.9f %zu\n", at(0.5), at(0.99), samples.size());
}

[[noreturn]] void wait_to_be_ended() {
  for (;;) std::this_thread::sleep_for(1s);
}

/// In this thread and all to come. @return it, for sigwait by this thread, which is asked first:
/// libraries may have threads already
sigset_t block_end_signal() {
  sigset_t asked;
  sigemptyset(&asked);
  sigaddset(&asked, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &asked, nullptr);
  return asked;
}

/// Each topic by itself: one that nobody hears is not made up for by the others.
int hear(const std::string& domain, int vehicles) {
  const sigset_t asked = block_end_signal();
  constexpr std::array topics{std::pair{"/odometry", "nav_msgs/msg/Odometry"},
                              std::pair{"/pose", "geometry_msgs/msg/PoseStamped"},
                              std::pair{"/imu", "sensor_msgs/msg/Imu"}};
  std::array<std::deque<std::atomic<std::uint64_t>>, topics.size()> heard;
  std::mutex mutex;
  std::set<int> met;
  dds::Participant participant(loopback(domain));  // last: what it calls uses the others
  for (int i = 0; i < vehicles; ++i) {
    const std::string name = "/v" + std::to_string(i);
    for (std::size_t k = 0; k < topics.size(); ++k) {
      participant.subscribe(
          {name + topics[k].first, topics[k].second, "", {}},
          [&count = heard[k].emplace_back(0)](dds::Payload, const std::string&) { ++count; });
    }
    // Said once before the first step, for those who come late: who has heard it is met.
    participant.subscribe({name + "/mission_state", "std_msgs/msg/String", "", {true, true, 1}},
                          [&, i](dds::Payload, const std::string&) {
                            const std::lock_guard lock(mutex);
                            const bool is_new = met.insert(i).second;
                            if (!is_new || met.size() != static_cast<std::size_t>(vehicles)) return;
                            std::puts("ready");
                            std::fflush(stdout);
                          });
  }
  int signal = 0;
  sigwait(&asked, &signal);
  for (const auto& counts : heard)
    std::printf("%llu ",
                static_cast<unsigned long long>(*std::min_element(counts.begin(), counts.end())));
  std::puts("");
  std::fflush(stdout);
  std::_Exit(0);
}

int readers(const std::string& domain, std::size_t count) {
  constexpr std::size_t wanted = 1000;
  std::mutex mutex;
  std::vector<double> ages_s;
  dds::Participant participant(loopback(domain));  // last: what it calls uses the others
  for (std::size_t i = 0; i < count; ++i) {
    participant.subscribe(
        {"/bench/current_profile", "slackwater_msgs/msg/CurrentProfile", "", {true, true, 1}},
        [&](dds::Payload message, const std::string&) {
          const double age_s = monotonic_s() - read_at<double>(message, 4);
          const std::lock_guard lock(mutex);
          ages_s.push_back(age_s);
        });
  }
  for (;;) {
    std::this_thread::sleep_for(20ms);
    const std::lock_guard lock(mutex);
    if (ages_s.size() < wanted * count) continue;
    print_percentiles(ages_s);
    return 0;
  }
}

/// By hand: the client's own encoding of what api/door/dds/idl says.
int agent(const std::string& domain) {
  std::atomic<bool> is_taken{false};
  dds::Participant participant(loopback(domain));
  const auto request =
      participant.publish_on({"/v0/host/request", "slackwater_msgs/msg/HostRequest", "", {}});
  const auto command =
      participant.publish_on({"/v0/host/command", "slackwater_msgs/msg/AgentCommand", "", {}});
  participant.subscribe({"/v0/host/answer", "slackwater_msgs/msg/HostAnswer", "", {}},
                        [&](dds::Payload, const std::string&) { is_taken = true; });
  participant.subscribe({"/v0/host/observation", "slackwater_msgs/msg/AgentObservation", "", {}},
                        [&](dds::Payload seen, const std::string&) {
                          // Behind a header with the frame "v0/base_link": 8 + 4 + 13, on eight.
                          const auto step = read_at<std::uint64_t>(seen, 4 + 32);
                          dds::Bytes answer{0, 1, 0, 0};
                          write_at(answer, 4, step);
                          answer.resize(4 + 64);                       // kind 0 and a twist
                          write_at(answer, 4 + 64, std::uint32_t{0});  // no thrusters
                          answer.resize(4 + 76);                       // a stamp
                          write_at(answer, 4 + 76, std::uint32_t{1});  // a frame of one byte, NUL
                          answer.resize(4 + 84);
                          write_at(answer, 4 + 84, std::uint32_t{0});  // no poses
                          participant.send(command, answer);
                        });
  dds::Bytes asked{0, 1, 0, 0};
  write_at(asked, 4, std::uint64_t{42});
  write_at(asked, 4 + 8, std::uint32_t{1});
  write_at(asked, 4 + 12, std::uint8_t{1});
  write_at(asked, 4 + 16, 1.0);
  while (!is_taken) {
    participant.send(request, asked);
    std::this_thread::sleep_for(100ms);
  }
  wait_to_be_ended();
}

/// The first odometry after a push whose surge bends: its thrusters come up over a tenth of a
/// second, so that it takes longer to go the other way: by 4 mm/s from one odometry to the next.
/// Drag, current and waves bend it by less than 1 mm/s.
int push(const std::string& domain, int trials) {
  constexpr double bent_m_s = 2e-3;
  std::mutex mutex;
  std::condition_variable came;
  double surge_m_s = 0, change_m_s = 0, bend_m_s = 0;
  std::uint64_t heard = 0;
  dds::Participant participant(loopback(domain));
  const auto thrusters =
      participant.publish_on({"/v0/thrusters", "std_msgs/msg/Float64MultiArray", "", {}});
  participant.subscribe({"/v0/odometry", "nav_msgs/msg/Odometry", "", {}},
                        [&](dds::Payload message, const std::string&) {
                          // Behind header ("map"), child frame ("v0/base_link"), pose, covariance.
                          const double now_m_s = read_at<double>(message, 4 + 40 + 56 + 288);
                          const std::lock_guard lock(mutex);
                          bend_m_s = (now_m_s - surge_m_s) - change_m_s;
                          change_m_s = now_m_s - surge_m_s;
                          surge_m_s = now_m_s;
                          ++heard;
                          came.notify_all();
                        });
  dds::Bytes asked{0, 1, 0, 0};
  write_at(asked, 4, std::uint32_t{0});  // no dimensions
  write_at(asked, 4 + 4, std::uint32_t{0});
  write_at(asked, 4 + 8, std::uint32_t{8});
  std::vector<double> times_s;
  for (int trial = 0; trial < trials + 5; ++trial) {
    const double share = trial % 2 == 0 ? 0.4 : -0.4;
    // The BlueROV2's first four push ahead, two of them astern of the others (its file).
    for (int i = 0; i < 4; ++i)
      write_at(asked, static_cast<std::size_t>(20 + 8 * i), i < 2 ? -share : share);
    for (int i = 4; i < 8; ++i) write_at(asked, static_cast<std::size_t>(20 + 8 * i), 0.0);
    const double from_s = monotonic_s();
    participant.send(thrusters, asked);
    {
      std::unique_lock lock(mutex);
      const std::uint64_t before = heard;
      const bool is_seen = came.wait_for(lock, 2s, [&] {
        return heard > before && bend_m_s * (trial % 2 == 0 ? 1 : -1) > bent_m_s;
      });
      if (trial >= 5 && is_seen) times_s.push_back(monotonic_s() - from_s);
    }
    for (int i = 0; i < 4; ++i) {  // renewed, so that the helm is kept
      std::this_thread::sleep_for(100ms);
      participant.send(thrusters, asked);
    }
  }
  print_percentiles(times_s);
  return 0;
}

/// The first odometry behind a velocity asked for that shows it. In still water, and only when the
/// vehicle has gone steadily for half a second: what it does then is the command's.
int steer(const std::string& domain, int trials) {
  constexpr double steady_m_s = 3e-4;
  constexpr std::size_t half_second = 25;
  std::mutex mutex;
  std::condition_variable came;
  std::deque<double> surges_m_s;
  dds::Participant participant(loopback(domain));
  const auto velocity = participant.publish_on({"/v0/cmd_vel", "geometry_msgs/msg/Twist", "", {}});
  participant.subscribe({"/v0/odometry", "nav_msgs/msg/Odometry", "", {}},
                        [&](dds::Payload message, const std::string&) {
                          const std::lock_guard lock(mutex);
                          surges_m_s.push_back(read_at<double>(message, 4 + 40 + 56 + 288));
                          if (surges_m_s.size() > half_second) surges_m_s.pop_front();
                          came.notify_all();
                        });
  const auto ask = [&](double surge_m_s) {
    dds::Bytes asked(4 + 48);
    asked[1] = 1;
    write_at(asked, 4, surge_m_s);
    participant.send(velocity, asked);
  };
  const auto is_steady = [&] {
    const std::lock_guard lock(mutex);
    if (surges_m_s.size() < half_second) return false;
    const auto [least, most] = std::minmax_element(surges_m_s.begin(), surges_m_s.end());
    return *most - *least < steady_m_s;
  };
  std::vector<double> times_s;
  for (int trial = 0; trial < trials + 1; ++trial) {
    constexpr int least = 20, patience = 300;
    for (int i = 0; i < patience && (i < least || !is_steady()); ++i) {
      ask(steered_m_s);  // renewed, so that the helm is kept
      std::this_thread::sleep_for(100ms);
    }
    std::unique_lock lock(mutex);
    const double before_m_s = surges_m_s.empty() ? 0 : surges_m_s.back();
    lock.unlock();
    const double from_s = monotonic_s();
    ask(steered_m_s + steered_by_m_s);
    lock.lock();
    const bool is_seen = came.wait_for(lock, 1s, [&] {
      return !surges_m_s.empty() && surges_m_s.back() - before_m_s > steered_shows_m_s;
    });
    if (trial > 0 && is_seen) times_s.push_back(monotonic_s() - from_s);
  }
  print_percentiles(times_s);
  return 0;
}

/// As long as a list may be: to and fro past where the vehicle is, leg after leg.
int lists(const std::string& domain) {
  dds::Participant participant(loopback(domain));
  const auto waypoints =
      participant.publish_on({"/v0/waypoints", "nav_msgs/msg/Path", "", {true, false, 10}});
  std::vector<twin::Waypoint> list(10'000);
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i].position_m = {i % 2 == 0 ? -20.0 : 20.0, 1e-3 * static_cast<double>(i), 10};
  const dds::Bytes message = dds::active_waypoints(list, {});
  for (;;) {
    participant.send(waypoints, message);
    std::this_thread::sleep_for(100ms);
  }
}

/// A run at the same pace that has nothing to do: how late the machine itself lets it begin.
int pace(double step_s) {
  const sigset_t asked = block_end_signal();
  twin::RunControl control(1);
  live::Punctuality punctuality(1);
  std::thread loop([&] {
    control.start_clock(0);
    for (std::uint64_t step = 0; control.may_step(step, step_s); ++step)
      punctuality.begin(control.due(), live::Punctuality::WallClock::now());
  });
  std::puts("ready");
  std::fflush(stdout);
  int signal = 0;
  sigwait(&asked, &signal);
  control.stop();
  loop.join();
  std::printf("%llu %llu %s\n", static_cast<unsigned long long>(punctuality.late_steps()),
              static_cast<unsigned long long>(punctuality.steps()), punctuality.text().c_str());
  return 0;
}

}  // namespace

double monotonic_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int live_client(const std::vector<std::string>& role) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // of a benchmark that was killed none stays
  if (role.at(0) == "hear") return hear(role.at(1), std::stoi(role.at(2)));
  if (role[0] == "readers") return readers(role.at(1), std::stoul(role.at(2)));
  if (role[0] == "agent") return agent(role.at(1));
  if (role[0] == "push") return push(role.at(1), std::stoi(role.at(2)));
  if (role[0] == "steer") return steer(role.at(1), std::stoi(role.at(2)));
  if (role[0] == "lists") return lists(role.at(1));
  if (role[0] == "pace") return pace(std::stod(role.at(1)));
  throw std::runtime_error("no such client: " + role[0]);
}

ClientProcess::ClientProcess(const std::vector<std::string>& role) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::vector<std::string> arguments{"/proc/self/exe", "--client"};
  arguments.insert(arguments.end(), role.begin(), role.end());
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  const int failed =
      ::posix_spawn(&process_, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  out_ = ends[0];
  if (failed != 0) throw std::runtime_error("the client cannot be started");
}

ClientProcess::~ClientProcess() {
  end();
  ::close(out_);
}

void ClientProcess::end() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

void ClientProcess::wait_for_line() {
  char one = 0;
  while (one != '\n')
    if (::read(out_, &one, 1) != 1)
      throw std::runtime_error("the client ended before it was ready");
}

std::string ClientProcess::asked_result() {
  ::kill(process_, SIGTERM);
  return result();
}

std::string ClientProcess::result() {
  std::string text;
  char some[256];
  for (ssize_t got; (got = ::read(out_, some, sizeof some)) > 0;)
    text.append(some, static_cast<std::size_t>(got));
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
  return text;
}

double ClientProcess::children_cpu_s() {
  rusage use{};
  getrusage(RUSAGE_CHILDREN, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(use.ru_utime) + seconds(use.ru_stime);
}

}  // namespace slackwater::bench
