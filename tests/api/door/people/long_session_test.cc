// Three scripted clients over hours of a run: hand-overs without end, links that break, and one
// holder at a time; then the run is made again to the last bit.
#include <gtest/gtest.h>

#include "fields/base/numbers/random.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/asked_number.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::long_session_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;

constexpr double times_as_fast = 30;

std::string fleet(int minutes) {
  return "name: long\nseed: 7\nduration: " + std::to_string(minutes) +
         "min\nstep_s: 0.1\nlog_every_s: 1\n"
         "water: {made_up: {depth_m: 60, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}]}}\n"
         "vehicles:\n"
         "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
         "tasks: [{do: hold}]}\n"
         "  - {name: rov 2, model: bluerov2_heavy, start: {north_m: 30, east_m: 0, depth_m: 10}, "
         "tasks: [{do: hold}]}\n";
}

/// A person who does this and that, is cut off and comes back.
class Restless {
 public:
  Restless(const SessionUnderWay& run, Role role, const std::string& name)
      : run_(run), name_(name), rng_(7, name), station_(std::in_place, run, run.token(role)) {
    resume_ = station_->hello(name)["resume"];
  }
  void act() {
    const auto vehicle = static_cast<int>(2 * rng_.uniform());
    const double chance = rng_.uniform();
    const auto about = [&](const char* what) {
      (void)station_->asks({{"do", what}, {"vehicle", vehicle}, {"reason", "a storm of them"}});
    };
    if (chance < 0.45) {
      const double surge_m_s = 0.4 * rng_.uniform() - 0.2;
      (void)station_->asks(
          station_->command("stick", vehicle, {{"velocity", {surge_m_s, 0, 0, 0.1}}}));
    } else if (chance < 0.6) {
      about("ask");
    } else if (chance < 0.7) {
      about("grant");
    } else if (chance < 0.75) {
      about("deny");
    } else if (chance < 0.8) {
      about("give_back");
    } else if (chance < 0.85) {
      about("allow");
    } else if (chance < 0.9) {
      about("take_back");
    } else if (chance < 0.95) {
      (void)station_->asks(station_->command("hold", vehicle));
    } else {
      cut_off();
    }
  }

 private:
  void cut_off() {
    station_->hang_up();
    station_.emplace(run_, resume_);
    const json welcome = station_->hello(name_);
    ASSERT_TRUE(welcome.is_object()) << name_ << ": the seat is gone";
    resume_ = welcome["resume"];
  }

  const SessionUnderWay& run_;
  std::string name_;
  Rng rng_;
  std::string resume_;
  std::optional<StationClient> station_;
};

bool hands_over(const people::Action& row) {
  static const std::vector<std::string> deeds{"ask",       "grant", "take_back", "hold",
                                              "waypoints", "home",  "helm got"};
  return row.is_taken && std::find(deeds.begin(), deeds.end(), row.what) != deeds.end();
}

TEST(LongSession, OneHolderAtATimeAndARecordThatMakesItAgain) {
  const int minutes = asked_number("SLACKWATER_SESSION_MINUTES", 6);
  SessionUnderWay run(fleet(minutes), {times_as_fast});
  std::vector<std::unique_ptr<Restless>> people;
  people.push_back(std::make_unique<Restless>(run, Role::drives, "Ann"));
  people.push_back(std::make_unique<Restless>(run, Role::drives, "Bob"));
  people.push_back(std::make_unique<Restless>(run, Role::supervises, "Sue"));
  // A little less than the run takes: who acts on is refused, and would wait for an answer.
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::duration<double>(0.9 * 60 * minutes / times_as_fast);
  while (std::chrono::steady_clock::now() < end && !HasFatalFailure())
    for (auto& person : people) {
      person->act();
      std::this_thread::sleep_for(40ms);  // a station says ten orders a second at most
    }
  const api::ScenarioResult& result = run.ended();
  std::map<std::size_t, const twin::Command*> last;
  std::size_t hand_overs = 0;
  for (const twin::Command& command : result.commands) {
    const twin::Command* before = std::exchange(last[command.agent], &command);
    if (before == nullptr || before->source == command.source) continue;
    ++hand_overs;
    const std::string& vehicle = result.file.names[command.agent];
    const bool is_told =
        std::any_of(result.actions.begin(), result.actions.end(), [&](const people::Action& row) {
          return row.vehicle == vehicle && hands_over(row) && row.step + 2 >= before->step &&
                 row.step <= command.step;
        });
    EXPECT_TRUE(is_told) << vehicle << " changed hands at step " << command.step
                         << " without a row of the record";
  }
  // A third of what three people who do as above come to on an idle machine.
  EXPECT_GT(hand_overs, static_cast<std::size_t>(minutes / 4));
  std::printf("%zu commands, %zu actions, %zu hand-overs in %.0f minutes of the run\n",
              result.commands.size(), result.actions.size(), hand_overs, result.account.ran_s / 60);
  const TemporaryFolder folder;
  ingest::write_trajectories(result.file, folder / "log.nc");
  for (const std::size_t threads : {1U, 2U}) {
    api::RunChoice choice;
    choice.threads = threads;
    const api::ReplayResult again =
        api::replay(folder / "log.nc", folder / "store", std::nullopt, choice);
    EXPECT_TRUE(again.is_identical) << threads << ": " << again.difference;
  }
}

}  // namespace
}  // namespace slackwater::tests::long_session_test
