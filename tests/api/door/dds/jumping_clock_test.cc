// The clock on the wall jumps by hours while a vehicle is driven.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "api/door/dds/participant.h"
#include "geometry_msgsPubSubTypes.h"
#include "std_msgsPubSubTypes.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/generated_client.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::jumping_clock_test {
namespace {

using namespace std::chrono_literals;

/// That of a program which has shifted_clock.c loaded into it.
class WallClock {
 public:
  explicit WallClock(const std::filesystem::path& file) : file_(file) {
    const std::int64_t none = 0;
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(&none), sizeof none);
    const int handle = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    shift_s_ = static_cast<volatile std::int64_t*>(
        ::mmap(nullptr, sizeof none, PROT_READ | PROT_WRITE, MAP_SHARED, handle, 0));
    ::close(handle);
  }
  ~WallClock() { ::munmap(const_cast<std::int64_t*>(shift_s_), sizeof *shift_s_); }
  WallClock(const WallClock&) = delete;
  WallClock& operator=(const WallClock&) = delete;

  void shift(std::chrono::seconds by) { *shift_s_ = by.count(); }
  [[nodiscard]] std::map<std::string, std::string> environment() const {
    // It comes before the sanitizer.
    auto environment = without_leaks(":verify_asan_link_order=0");
    environment["LD_PRELOAD"] = SLACKWATER_SHIFTED_CLOCK_LIBRARY;
    environment["SLACKWATER_SHIFTED_CLOCK"] = file_;
    return environment;
  }

 private:
  std::filesystem::path file_;
  volatile std::int64_t* shift_s_;
};

/// A pose as a stranger's reader gets it.
struct Seen {
  double run_s = 0;                               ///< its stamp
  double sent_s = 0;                              ///< by the wall clock of who sent it
  std::chrono::steady_clock::time_point at = {};  ///< when it came
};
class PoseListener final : public fdds::DataReaderListener {
 public:
  void on_data_available(fdds::DataReader* reader) override {
    geometry_msgs::msg::PoseStamped pose;
    fdds::SampleInfo info;
    while (reader->take_next_sample(&pose, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      const auto& stamp = pose.header().stamp();
      seen_.put({stamp.sec() + 1e-9 * stamp.nanosec(),
                 1e-9 * static_cast<double>(info.source_timestamp.to_ns()),
                 std::chrono::steady_clock::now()});
    }
  }
  [[nodiscard]] Seen last() { return seen_.wait().empty() ? Seen() : seen_.wait().back(); }

 private:
  Inbox<Seen> seen_;
};

/// What the vehicle does, each time that it is told.
class DoingListener final : public fdds::DataReaderListener {
 public:
  void on_data_available(fdds::DataReader* reader) override {
    std_msgs::msg::String state;
    fdds::SampleInfo info;
    while (reader->take_next_sample(&state, &info) ==
           eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK)
      if (info.valid_data) doing_.put(nlohmann::json::parse(state.data()).at("doing"));
  }
  /// Whether it comes to that.
  [[nodiscard]] bool comes_to(const std::string& what, std::chrono::seconds most = 60s) {
    return comes_true([&] { return doing_.size() > 0 && doing_.wait().back() == what; }, most);
  }

 private:
  Inbox<std::string> doing_;
};

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// What the vehicle was doing, from when on, s.
struct Doing {
  double from_s = 0;
  std::string what, cause, authority;
};
std::vector<Doing> doings(const std::vector<LiveMessage>& record) {
  std::vector<Doing> doings;
  for (const LiveMessage& message : record) {
    if (message.topic != "/rov/mission_state") continue;
    const auto json = nlohmann::json::parse(HandReader(message.payload).string());
    doings.push_back({1e-9 * static_cast<double>(message.log_time_ns), json.at("doing"),
                      json.value("cause", ""), json.at("authority")});
  }
  return doings;
}

class JumpingClock : public testing::Test {
 protected:
  /// Half as fast as real time: a client that a busy machine holds up for two seconds is in time.
  void start(const std::vector<std::string>& transports) {
    std::vector<std::string> arguments{"live",
                                       live_scenario(),
                                       "--dds-domain",
                                       std::to_string(domain_.number()),
                                       "--loopback",
                                       "--real-time-factor",
                                       "0.5",
                                       "--record",
                                       folder_ / "run.mcap"};
    arguments.insert(arguments.end(), transports.begin(), transports.end());
    run_.emplace(start_program(arguments, wall_.environment()));
    stranger_.reader("rt/rov/pose",
                     fdds::TypeSupport(new geometry_msgs::msg::PoseStampedPubSubType), &poses_);
    stranger_.reader("rt/rov/mission_state", fdds::TypeSupport(new std_msgs::msg::StringPubSubType),
                     &doing_, true);
  }
  /// Goes on once the run has seen it.
  void jump(std::chrono::hours shift) {
    wall_.shift(shift);
    const double expected_s = std::chrono::duration<double>(shift).count();
    EXPECT_TRUE(comes_true([&] {
      return std::abs(poses_.last().sent_s - now_s() - expected_s) < 60;
    })) << "the program does not see its clock jump";
    std::this_thread::sleep_for(1s);
  }

  OwnDomain domain_;
  TemporaryFolder folder_;
  WallClock wall_{folder_ / "shift"};
  PoseListener poses_;
  DoingListener doing_;
  GeneratedParticipant stranger_{domain_.number(), true};
  std::optional<StartedProgram> run_;
};

// That of a client on another machine stays what it is.
TEST_F(JumpingClock, OfTheRunMovesNeitherItNorItsTimeOuts) {
  start({"--udp-only"});
  dds::DomainSettings settings;
  settings.domain = domain_.number();
  settings.is_loopback_only = settings.is_udp_only = true;
  {
    dds::Participant helm(settings);
    const auto velocity =
        helm.publish_on({"/rov/cmd_vel", "geometry_msgs/msg/Twist", "", {true, false, 1}});
    std::atomic<bool> is_sent = true;
    std::thread sender([&] {
      const dds::Bytes message = HandWriter().doubles({0.2, 0, 0, 0, 0, 0}).bytes();
      for (; is_sent; std::this_thread::sleep_for(50ms)) helm.send(velocity, message);
    });
    EXPECT_TRUE(doing_.comes_to("velocity"));
    const Seen first = poses_.last();
    for (const auto shift : {std::chrono::hours(3), std::chrono::hours(-3)}) jump(shift);
    const Seen last = poses_.last();
    const double waited_s = std::chrono::duration<double>(last.at - first.at).count();
    EXPECT_GT(waited_s, 1.5);
    EXPECT_NEAR((last.run_s - first.run_s) / waited_s, 0.5, 0.25) << "the pace of the run";
    is_sent = false;
    sender.join();
    EXPECT_TRUE(doing_.comes_to("hold"));
  }
  EXPECT_EQ(run_->end(SIGINT), 0);

  const auto record = messages_of(folder_ / "run.mcap");
  EXPECT_GT(expect_even_clock(record), 20U);
  double last_command_s = 0;
  for (const LiveMessage& message : record)
    if (message.topic == "/rov/cmd_vel")
      last_command_s = 1e-9 * static_cast<double>(message.log_time_ns);
  const auto changes = doings(record);
  const auto driven = std::find_if(changes.begin(), changes.end(),
                                   [](const Doing& d) { return d.what == "velocity"; });
  // Through both jumps it was driven, by the same client; then the time-out, to some steps.
  const auto left =
      std::find_if(driven, changes.end(), [](const Doing& d) { return d.authority.empty(); });
  const auto held =
      std::find_if(driven, changes.end(), [](const Doing& d) { return d.what != "velocity"; });
  ASSERT_TRUE(left != changes.end() && held != changes.end());
  EXPECT_EQ(held->what, "hold");
  EXPECT_EQ(held->cause, "not_renewed");
  EXPECT_NEAR(left->from_s - last_command_s, 1, 0.15);
  EXPECT_NEAR(held->from_s - last_command_s, 1, 0.15);
}

// Through shared memory a client has the run's own clock. Set back, it makes what the client sends
// look late for a minute at most (HeldBack): the vehicle holds, and then goes on.
TEST_F(JumpingClock, OfTheMachineMakesCommandsStaleForAMinute) {
  start({});
  StartedProgram helm(start_other_program(SLACKWATER_RENEWING_HELM,
                                          {std::to_string(domain_.number())}, "/dev/null",
                                          wall_.environment()));
  EXPECT_TRUE(doing_.comes_to("velocity"));
  jump(std::chrono::hours(3));
  EXPECT_TRUE(doing_.comes_to("velocity", 0s)) << "set forward, it takes nothing from anybody";
  jump(std::chrono::hours(-3));
  EXPECT_TRUE(doing_.comes_to("hold"));
  EXPECT_TRUE(doing_.comes_to("velocity", 90s));
  ::kill(helm.process(), SIGTERM);
  EXPECT_TRUE(doing_.comes_to("hold"));
  EXPECT_EQ(helm.end(SIGTERM), 0);
  EXPECT_EQ(run_->end(SIGINT), 0);

  const auto record = messages_of(folder_ / "run.mcap");
  EXPECT_GT(expect_even_clock(record), 20U);
  std::vector<double> stale_s;  // of the run, which is half as fast as the clock
  for (const LiveMessage& message : record) {
    if (message.topic != "/rov/refused") continue;
    EXPECT_EQ(nlohmann::json::parse(HandReader(message.payload).string()).at("reason"), "stale");
    stale_s.push_back(1e-9 * static_cast<double>(message.log_time_ns));
  }
  ASSERT_GT(stale_s.size(), 2U);
  const double lasted_s = (stale_s.back() - stale_s.front()) / 0.5;
  EXPECT_GT(lasted_s, 25) << "the last half minute of delays, at least";
  EXPECT_LT(lasted_s, 65);
}

}  // namespace
}  // namespace slackwater::tests::jumping_clock_test
