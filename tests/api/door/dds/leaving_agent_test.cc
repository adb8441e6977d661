// Agents of `slackwater live` in other processes that leave, or fall silent: who waits for whom.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <thread>

#include "nav_msgsPubSubTypes.h"
#include "slackwater_msgsPubSubTypes.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/service_client.h"
#include "tests/support/comes_true.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::leaving_agent_test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// When each step of a vehicle was told, on the clock of the wall.
class Pulse : public peer::fdds::DataReaderListener {
 public:
  void on_data_available(peer::fdds::DataReader* reader) override {
    nav_msgs::msg::Odometry message;
    peer::fdds::SampleInfo info;
    while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
      const std::lock_guard lock(mutex_);
      if (info.valid_data) times_.push_back(Clock::now());
    }
  }
  /// Between one step and the next, s, those that end after `from`; the last one to now.
  std::vector<double> gaps_s(Clock::time_point from) {
    const std::lock_guard lock(mutex_);
    std::vector<double> gaps;
    for (std::size_t i = 1; i <= times_.size(); ++i) {
      const Clock::time_point end = i < times_.size() ? times_[i] : Clock::now();
      if (end > from) gaps.push_back(std::chrono::duration<double>(end - times_[i - 1]).count());
    }
    return gaps;
  }
  std::size_t steps() {
    const std::lock_guard lock(mutex_);
    return times_.size();
  }

 private:
  std::mutex mutex_;
  std::vector<Clock::time_point> times_;
};

/// Asks for a vehicle and answers each observation with a slow way ahead, until it is told to be
/// silent.
class Agent {
 public:
  /// @param deaf  for so long after it first asked it makes no reader of what it is told
  Agent(int domain, const std::string& vehicle, double timeout_s, Clock::duration deaf = {})
      : timeout_s_(timeout_s),
        deaf_(deaf),
        node_(std::make_unique<peer::Node>(domain)),
        observation_("rt/" + vehicle + "/host/observation") {
    using namespace slackwater_msgs::msg;
    request_ = node_->writer<HostRequestPubSubType>("rt/" + vehicle + "/host/request");
    command_ = node_->writer<AgentCommandPubSubType>("rt/" + vehicle + "/host/command");
    if (deaf == Clock::duration{}) listen();
    thread_ = std::jthread([this](const std::stop_token& over) { fly(over); });
  }
  ~Agent() { stop(); }
  [[nodiscard]] std::size_t seen() const { return seen_; }
  void be_silent(bool is_silent) { is_silent_ = is_silent; }

  void close_participant() {
    stop();
    node_.reset();
  }
  void close_writer() {
    stop();
    node_->publisher->delete_datawriter(command_);
  }
  void say_that_it_leaves() {
    stop();
    ask(0);
  }
  /// In one breath with an answer, which may be taken up behind it.
  void answer_and_leave() {
    is_leaving_ = true;
    thread_.join();
  }

 private:
  void listen() {
    observed_ = node_->reader<slackwater_msgs::msg::AgentObservationPubSubType>(observation_);
  }
  void stop() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
  }
  void ask(std::uint8_t role) {
    slackwater_msgs::msg::HostRequest asked;
    asked.token(1);
    asked.version(1);
    asked.role(role);
    asked.timeout_s(timeout_s_);
    request_->write(&asked);
  }
  void fly(const std::stop_token& over) {
    slackwater_msgs::msg::AgentObservation seen;
    peer::fdds::SampleInfo info;
    while (!over.stop_requested()) {
      peer::fdds::PublicationMatchedStatus hears;
      command_->get_publication_matched_status(hears);
      if (seen_ == 0 && hears.current_count > 0) {
        if (asked_ == Clock::time_point{}) asked_ = Clock::now();
        ask(1);
      }
      if (observed_ == nullptr) {
        if (asked_ != Clock::time_point{} && Clock::now() - asked_ >= deaf_) listen();
        std::this_thread::sleep_for(50ms);
        continue;
      }
      observed_->wait_for_unread_message({0, 50'000'000});
      if (is_silent_) continue;
      while (observed_->take_next_sample(&seen, &info) == ReturnCode_t::RETCODE_OK) {
        if (!info.valid_data) continue;
        slackwater_msgs::msg::AgentCommand command;
        command.step(seen.step());
        command.kind(1);
        command.velocity().linear().x(0.1);
        command_->write(&command);
        if (is_leaving_) return ask(0);
        ++seen_;
      }
    }
  }

  double timeout_s_;
  Clock::duration deaf_;
  Clock::time_point asked_{};  ///< first
  std::unique_ptr<peer::Node> node_;
  std::string observation_;
  peer::fdds::DataWriter* request_ = nullptr;
  peer::fdds::DataWriter* command_ = nullptr;
  peer::fdds::DataReader* observed_ = nullptr;
  std::atomic<std::size_t> seen_{0};
  std::atomic<bool> is_silent_{false}, is_leaving_{false};
  std::jthread thread_;
};

/// A run at the pace of the clock, twenty steps a second, with vehicles that others may host; `c`
/// is watched.
class LeavingAgent : public testing::Test {
 protected:
  LeavingAgent() {
    std::ofstream scenario(folder_ / "scenario.yaml");
    scenario << "name: test\nseed: 7\nduration: 20min\nstep_s: 0.05\nlog_every_s: 0.5\n"
                "water: {made_up: {depth_m: 60}}\nvehicles:\n";
    for (const char* name : {"a", "b", "c"})
      scenario << "  - {name: " << name
               << ", model: bluerov2_heavy, start: {north_m: 0, east_m: " << 20 * (name[0] - 'a')
               << ", depth_m: 10}, tasks: [{do: hold}]}\n";
    scenario.close();
    observer_.reader<nav_msgs::msg::OdometryPubSubType>("rt/c/odometry")->set_listener(&pulse_);
    run_.emplace(start_program(
        {"live", folder_ / "scenario.yaml", "--dds-domain", std::to_string(domain_.number()),
         "--out", folder_ / "run.nc", "--record", folder_ / "run.mcap"},
        without_leaks(), "/dev/null", folder_ / "err"));
  }
  std::unique_ptr<Agent> hosted(const std::string& vehicle, double timeout_s) {
    auto agent = std::make_unique<Agent>(domain_.number(), vehicle, timeout_s);
    EXPECT_TRUE(comes_true([&] { return agent->seen() >= 20 && pulse_.steps() >= 20; }, 60s))
        << agent->seen() << " observations\n"
        << said();
    return agent;
  }
  double longest_s(Clock::time_point from) {
    const auto gaps = pulse_.gaps_s(from);
    return gaps.empty() ? 1e9 : *std::max_element(gaps.begin(), gaps.end());
  }
  std::ptrdiff_t stalls(Clock::time_point from) {
    const auto gaps = pulse_.gaps_s(from);
    return std::count_if(gaps.begin(), gaps.end(), [](double gap_s) { return gap_s > 0.6; });
  }
  bool is_said(const std::string& words, std::chrono::seconds most = 20s) {
    return comes_true([&] { return said().find(words) != std::string::npos; }, most);
  }
  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "err").rdbuf();
    return text.str();
  }
  void expect_good_end() {
    ASSERT_EQ(run_->end(SIGINT), 0) << said();
    const ProgramResult again = run_program({"replay", folder_ / "run.nc"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
  }

  OwnDomain domain_;
  TemporaryFolder folder_;
  Pulse pulse_;
  peer::Node observer_{domain_.number()};
  std::optional<StartedProgram> run_;
};

struct Way {
  const char* name;
  void (Agent::*leave)();
  const char* words;
  friend void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }
};
class LeavesBy : public LeavingAgent, public testing::WithParamInterface<Way> {};
INSTANTIATE_TEST_SUITE_P(
    EachWay, LeavesBy,
    testing::Values(Way{"ClosingItsParticipant", &Agent::close_participant, "it is gone"},
                    Way{"ClosingItsWriter", &Agent::close_writer, "it is gone"},
                    Way{"SayingSo", &Agent::say_that_it_leaves, "it left"},
                    Way{"SayingSoWithAnAnswer", &Agent::answer_and_leave, "it left"}),
    [](const auto& way) { return std::string(way.param.name); });

TEST_P(LeavesBy, IsUnhostedAtOnceAndNobodyWaits) {
  const auto agent = hosted("a", 2);
  const auto left = Clock::now();
  (*agent.*GetParam().leave)();
  EXPECT_TRUE(is_said("the agent of a, dds ")) << said();
  EXPECT_TRUE(is_said(std::string("is taken off: ") + GetParam().words)) << said();
  EXPECT_LT(Clock::now() - left, 1500ms);
  std::this_thread::sleep_for(3s);
  EXPECT_LT(longest_s(left), 1.2) << "its time-out is 2 s";
  expect_good_end();
  std::string last;
  for (const LiveMessage& message : messages_of(folder_ / "run.mcap"))
    if (message.topic == "/a/mission_state")
      last.assign(message.payload.begin() + 8, message.payload.end() - 1);
  EXPECT_EQ(nlohmann::json::parse(last).at("authority"), "") << "who left keeps no helm";
}

TEST_F(LeavingAgent, WhoFallsSilentIsWaitedForOnceAndTheOthersGoOn) {
  const auto silent = hosted("a", 1), other = hosted("b", 1);
  const auto from = Clock::now();
  const std::size_t seen = other->seen();
  silent->be_silent(true);
  EXPECT_TRUE(is_said("did not answer within 1 s: the run goes on without waiting for it"));
  EXPECT_TRUE(is_said("is taken off: no answer came within 5 s")) << said();
  const std::chrono::duration<double> took = Clock::now() - from;
  EXPECT_NEAR(took.count(), 5, 1.5);
  EXPECT_EQ(stalls(from), 1);
  EXPECT_LT(longest_s(from), 1.8) << "one time-out";
  EXPECT_GT(other->seen(), seen + 50) << "of the hundred steps of five seconds";
  expect_good_end();
}

TEST_F(LeavingAgent, WhoseReaderIsFoundLateIsWaitedForFromThenOn) {
  const Agent agent(domain_.number(), "a", 1, 2s);
  ASSERT_TRUE(comes_true([&] { return agent.seen() >= 20; }, 60s)) << said();
  EXPECT_EQ(said().find("did not answer"), std::string::npos) << said();
  EXPECT_EQ(said().find("is taken off"), std::string::npos) << said();
  EXPECT_EQ(stalls({}), 0) << "nobody waits for who cannot hear yet";
  expect_good_end();
}

TEST_F(LeavingAgent, WhoDoesNotListenIsTakenOffAndNobodyWaits) {
  const Agent agent(domain_.number(), "a", 1, 1h);
  EXPECT_TRUE(is_said("is taken off: it does not read /a/host/observation", 60s)) << said();
  EXPECT_EQ(stalls({}), 0);
  expect_good_end();
}

TEST_F(LeavingAgent, TwoThatFallSilentTogetherAreWaitedForTogether) {
  const auto one = hosted("a", 1), other = hosted("b", 1);
  const auto from = Clock::now();
  one->be_silent(true);
  other->be_silent(true);
  EXPECT_TRUE(is_said("the agent of a, "));
  EXPECT_TRUE(is_said("the agent of b, "));
  std::this_thread::sleep_for(1s);
  EXPECT_LT(longest_s(from), 1.8);
  expect_good_end();
}

TEST_F(LeavingAgent, WhoAnswersAgainIsInLockStepAgain) {
  const auto agent = hosted("a", 1);
  agent->be_silent(true);
  EXPECT_TRUE(is_said("did not answer within 1 s"));
  std::this_thread::sleep_for(1500ms);
  agent->be_silent(false);
  std::this_thread::sleep_for(1s);
  const std::size_t seen = agent->seen(), steps = pulse_.steps();
  std::this_thread::sleep_for(4s);
  EXPECT_EQ(said().find("is taken off"), std::string::npos) << said();
  const auto made = static_cast<double>(pulse_.steps() - steps);
  EXPECT_NEAR(static_cast<double>(agent->seen() - seen), made, 0.1 * made + 3) << "each step";
  expect_good_end();
  // What it answered counts: of the four seconds, and of those before.
  const std::vector<LiveMessage> messages = messages_of(folder_ / "run.mcap");
  std::size_t late = 0;
  for (const LiveMessage& message : messages)
    late += message.topic == "/a/cmd_vel" &&
                    messages.back().log_time_ns - message.log_time_ns < 4'000'000'000
                ? 1
                : 0;
  EXPECT_GT(late, 50U);
}

/// Physics of a body that nothing but the water pushes.
class Physics {
 public:
  Physics(int domain, const std::string& vehicle) : node_(domain) {
    using namespace slackwater_msgs::msg;
    request_ = node_.writer<HostRequestPubSubType>("rt/" + vehicle + "/host/request");
    output_ = node_.writer<PhysicsOutputPubSubType>("rt/" + vehicle + "/host/physics_output");
    input_ = node_.reader<PhysicsInputPubSubType>("rt/" + vehicle + "/host/physics_input");
    thread_ = std::jthread([this](const std::stop_token& over) { make(over); });
  }
  [[nodiscard]] std::size_t made() const { return made_; }
  /// While a step waits for it.
  void close_writer() {
    thread_.request_stop();
    thread_.join();
    std::this_thread::sleep_for(200ms);
    node_.publisher->delete_datawriter(output_);
  }

 private:
  void make(const std::stop_token& over) {
    slackwater_msgs::msg::PhysicsInput input;
    peer::fdds::SampleInfo info;
    Clock::time_point asked_at{};
    while (!over.stop_requested()) {
      slackwater_msgs::msg::HostRequest asked;
      asked.version(1);
      asked.role(2);
      asked.timeout_s(5);
      peer::fdds::PublicationMatchedStatus hears;
      output_->get_publication_matched_status(hears);
      // Once, unless it was not heard: each time that is taken is on record.
      if (made_ == 0 && hears.current_count > 0 && Clock::now() > asked_at + 1s) {
        asked_at = Clock::now();
        request_->write(&asked);
      }
      input_->wait_for_unread_message({0, 50'000'000});
      while (input_->take_next_sample(&input, &info) == ReturnCode_t::RETCODE_OK) {
        if (!info.valid_data) continue;
        slackwater_msgs::msg::PhysicsOutput output;
        output.step(input.step());
        output.kind(2);
        output_->write(&output);
        ++made_;
      }
    }
  }

  peer::Node node_;
  peer::fdds::DataWriter* request_ = nullptr;
  peer::fdds::DataWriter* output_ = nullptr;
  peer::fdds::DataReader* input_ = nullptr;
  std::atomic<std::size_t> made_{0};
  std::jthread thread_;
};

TEST_F(LeavingAgent, PhysicsThatLeaveWhileAStepWaitsAreOursAtOnceAndForGood) {
  Physics physics(domain_.number(), "a");
  ASSERT_TRUE(comes_true([&] { return physics.made() >= 20 && pulse_.steps() >= 20; }, 60s))
      << said();
  const auto left = Clock::now();
  physics.close_writer();
  EXPECT_TRUE(is_said("the physics of a are ours again, dds ")) << said();
  EXPECT_TRUE(is_said("is taken off: it is gone")) << said();
  std::this_thread::sleep_for(2s);
  EXPECT_LT(longest_s(left), 2) << "its time-out is 5 s";
  ASSERT_EQ(run_->end(SIGINT), 0) << said();
  const ProgramResult again =
      run_program({"replay", folder_ / "run.nc", "--record", folder_ / "again.mcap", "--json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto taken = nlohmann::json::parse(again.out).at("commands").at("taken");
  const auto host = std::find_if(taken.begin(), taken.end(),
                                 [](const auto& kind) { return kind.at("kind") == "host"; });
  ASSERT_NE(host, taken.end());
  EXPECT_EQ(host->at("in_log"), 2) << "where they begin, and where they end";
}

}  // namespace
}  // namespace slackwater::tests::leaving_agent_test
