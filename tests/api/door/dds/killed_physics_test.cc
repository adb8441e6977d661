// The physics of a vehicle of `slackwater live` are made by another process, which is killed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "nav_msgsPubSubTypes.h"
#include "slackwater_msgsPubSubTypes.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/strangers/live/services.h"
#include "tests/support/comes_true.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::killed_physics_test {
namespace {

using namespace std::chrono_literals;
constexpr double step_s = 0.05;  // of the scenario

/// All that came since it was asked last.
template <typename Message>
std::vector<Message> taken(peer::fdds::DataReader* reader) {
  std::vector<Message> messages;
  Message message;
  peer::fdds::SampleInfo info;
  while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK)
    if (info.valid_data) messages.push_back(message);
  return messages;
}

bool is_met(peer::fdds::DataReader* reader) {
  peer::fdds::SubscriptionMatchedStatus writers;
  reader->get_subscription_matched_status(writers);
  return writers.current_count > 0;
}

/// A run at twice the time, whose ROV another process moves: that of the examples, in still water
/// and always level.
class KilledPhysics : public testing::Test {
 protected:
  void start(const std::vector<std::string>& rule) {
    std::vector<std::string> arguments{"live",   live_scenario(),      "--dds-domain",
                                       number(), "--real-time-factor", "2",
                                       "--out",  folder_ / "run.nc"};
    arguments.insert(arguments.end(), rule.begin(), rule.end());
    run_.emplace(start_program(arguments, without_leaks(), "/dev/null", folder_ / "err"));
    ASSERT_TRUE(comes_true([&] { return is_met(answers_) && is_met(odometry_); }, 40s)) << said();
    // Who has met a writer may not have been met by it: it is asked for an answer until one comes.
    slackwater_msgs::msg::HostRequest nonsense;
    nonsense.version(99);
    ASSERT_TRUE(comes_true(
        [&] {
          requests_->write(&nonsense);
          std::this_thread::sleep_for(100ms);
          return !taken<slackwater_msgs::msg::HostAnswer>(answers_).empty();
        },
        40s))
        << said();
    physics_.emplace(
        start_other_program(SLACKWATER_TOWED_PHYSICS, {"--domain", number(), "--vehicle", "rov"}));
    std::size_t inputs = 0;
    ASSERT_TRUE(comes_true(
        [&] {
          for (const auto& answer : taken<slackwater_msgs::msg::HostAnswer>(answers_))
            if (answer.success()) host_ = answer.message();
          inputs += taken<slackwater_msgs::msg::PhysicsInput>(inputs_).size();
          return !host_.empty() && inputs >= 40;
        },
        40s))
        << inputs << " steps by '" << host_ << "'";
    // "hosted by dds 01.0f... from now on": whom a refusal would have to name.
    host_ = host_.substr(host_.find("dds "));
    host_ = host_.substr(0, host_.find(" from now on"));
    ASSERT_TRUE(comes_true([&] { return is_level(); })) << "it is not they that move it";
  }
  void kill() { ASSERT_EQ(physics_->end(SIGKILL), 128 + SIGKILL) << "they ended by themselves"; }
  testing::AssertionResult is_said(const std::string& why, std::chrono::seconds most) {
    const std::string words =
        "the physics of rov are ours again, " + host_ + " is taken off: " + why;
    if (comes_true([&] { return said().find(words) != std::string::npos; }, most))
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << words << "' was not said:\n" << said();
  }
  /// Steps that are made in a second of the wall.
  std::size_t steps_in_a_second() {
    (void)look();
    std::this_thread::sleep_for(1s);
    return look();
  }
  bool calls(const std::string& service) {
    const auto reply = peer::Trigger(node_, service).call({}, 20);
    return reply && reply->success();
  }
  /// It never went further in a step than it swims.
  void expect_no_jump() {
    (void)look();
    for (std::size_t i = 1; i < way_.size(); ++i) {
      const auto& a = way_[i - 1].pose().pose().position();
      const auto& b = way_[i].pose().pose().position();
      EXPECT_LT(std::hypot(a.x() - b.x(), a.y() - b.y(), a.z() - b.z()), 2 * step_s) << i;
    }
  }
  /// Ours are in waves: nobody but those of the example keeps a vehicle level to the last bit.
  bool is_level() {
    (void)look();
    if (way_.empty()) return false;
    const auto& twist = way_.back().twist().twist();
    return twist.angular().x() == 0 && twist.linear().y() == 0;
  }
  void expect_good_end() {
    ASSERT_EQ(run_->end(SIGINT), 0) << said();
    const ProgramResult again = run_program({"replay", folder_ / "run.nc", "--threads", "2"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
  }
  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "err").rdbuf();
    return text.str();
  }

 private:
  /// Its odometry of each step. @return how many came since it was asked last
  std::size_t look() {
    const auto more = taken<nav_msgs::msg::Odometry>(odometry_);
    way_.insert(way_.end(), more.begin(), more.end());
    return more.size();
  }
  [[nodiscard]] std::string number() const { return std::to_string(domain_.number()); }

  OwnDomain domain_;
  TemporaryFolder folder_;
  peer::Node node_{domain_.number()};
  peer::fdds::DataReader* answers_ =
      node_.reader<slackwater_msgs::msg::HostAnswerPubSubType>("rt/rov/host/answer");
  peer::fdds::DataWriter* requests_ =
      node_.writer<slackwater_msgs::msg::HostRequestPubSubType>("rt/rov/host/request");
  peer::fdds::DataReader* inputs_ =
      node_.reader<slackwater_msgs::msg::PhysicsInputPubSubType>("rt/rov/host/physics_input");
  peer::fdds::DataReader* odometry_ =
      node_.reader<nav_msgs::msg::OdometryPubSubType>("rt/rov/odometry");
  std::vector<nav_msgs::msg::Odometry> way_;
  std::string host_;
  std::optional<StartedProgram> run_, physics_;
};

TEST_F(KilledPhysics, AreTakenBackAndTheRunGoesOn) {
  ASSERT_NO_FATAL_FAILURE(start({}));
  kill();
  EXPECT_TRUE(is_said("its answer did not come within 2 s", 20s));
  EXPECT_GT(steps_in_a_second(), 10U);
  expect_no_jump();
  EXPECT_TRUE(comes_true([&] { return !is_level(); })) << "nobody moves it";
  expect_good_end();
}

TEST_F(KilledPhysics, HaltTheRunWhereThatIsTheRuleUntilPeopleResumeIt) {
  ASSERT_NO_FATAL_FAILURE(start({"--when-host-fails", "halt"}));
  kill();
  EXPECT_TRUE(is_said("its answer did not come within 2 s", 20s));
  std::this_thread::sleep_for(500ms);  // the step that waited ends
  EXPECT_EQ(steps_in_a_second(), 0U);
  expect_no_jump();
  ASSERT_TRUE(calls("/slackwater/resume"));
  EXPECT_GT(steps_in_a_second(), 10U);
  EXPECT_TRUE(comes_true([&] { return !is_level(); })) << "nobody moves it";
  expect_good_end();
}

// No step waits for an answer: it is the participant that is missed, 20 s (Fast DDS's lease).
TEST_F(KilledPhysics, OfAPausedRunAreGoneWithTheirLease) {
  ASSERT_NO_FATAL_FAILURE(start({}));
  ASSERT_TRUE(calls("/slackwater/pause"));
  kill();
  EXPECT_TRUE(is_said("it is gone", 60s));
  EXPECT_EQ(steps_in_a_second(), 0U);
  ASSERT_TRUE(calls("/slackwater/resume"));
  EXPECT_GT(steps_in_a_second(), 10U) << "it waits for who is gone";
  EXPECT_TRUE(comes_true([&] { return !is_level(); })) << "nobody moves it";
  expect_good_end();
}

}  // namespace
}  // namespace slackwater::tests::killed_physics_test
