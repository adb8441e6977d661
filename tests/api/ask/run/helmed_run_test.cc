// Runs that people and programs take part in: what they do is in the log, and the log makes the run
// again.
#include <gtest/gtest.h>

#include <thread>

#include "api/log/command_tables.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "tests/api/ask/run/logged_runs.h"
#include "twin/run/command_numbers.h"

namespace slackwater::tests::helmed_run_test {
namespace {

using namespace api;
using twin::Command;

const std::string yaml = R"(name: helmed
seed: 5
duration: 1min
step_s: 0.05
log_every_s: 0.5
log: {sensors: true}
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.3, north_m_s: 0.1}],
                  wind: {speed_m_s: 5, from_deg: 200}}}
waves: {components: 16, partitions: [{significant_height_m: 0.5, peak_period_s: 5, from_deg: 200}]}
gusts: dryden
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 12},
     tasks: [{do: hold}]}
  - {name: second, model: bluerov2_heavy, start: {north_m: 20, east_m: 0, depth_m: 12},
     conduct: {}, tasks: [{do: route, waypoints: [{north_m: 40, east_m: 0, depth_m: 12}]}]}
  - {name: usv, model: wamv16, start: {north_m: -90, east_m: 0, depth_m: 0},
     tasks: [{do: hold}]}
)";

/// Three clients, at each opening: one renews a velocity and then falls silent, one sends lists,
/// one is refused and gets a vehicle of its own.
class Guests {
 public:
  void join(const RunInHand& hand) {
    arbiter_ = &hand.arbiter;
    hand.run.at_opening([this](const twin::StepTime& time) { act(time); });
    hand.run.at_barrier([this](const twin::StepTime&) { ++barriers; });
    EXPECT_EQ(hand.origin.latitude_deg(), 55);
    EXPECT_EQ(hand.scenario.name, "helmed");
  }
  int barriers = 0;

 private:
  void say(const std::string& client, std::size_t vehicle, twin::CommandWhat what, double t_s) {
    (void)arbiter_->submit(client, {0, vehicle, std::move(what), "", ++sequence_, t_s}, t_s);
  }
  void act(const twin::StepTime& time) {
    const double t_s = time.start_s;
    if (t_s < 20 && time.step % 5 == 0)
      say("dds 01.0f", 0, twin::SetVelocity{{0.3, 0.1, 0, 0.1}}, t_s);
    if (time.step == 100)
      say("http 7", 1, twin::Reroute{{{{22, 3, 14}, 0.3}, {{20, 0, 13}, 0}}}, t_s);
    if (time.step % 100 == 50) say("mavlink 255", 0, twin::HoldHere{}, t_s);
    if (time.step >= 200 && time.step % 10 == 0)
      say("mavlink 255", 2, twin::SetThrusters{{0.2, 0.1}}, t_s);
    if (time.step == 900) say("http 7", 1, twin::Resume{}, t_s);
  }
  twin::CommandArbiter* arbiter_ = nullptr;
  std::uint64_t sequence_ = 0;
};

class HelmedRun : public LoggedRuns {
 protected:
  HelmedRun() : LoggedRuns(yaml) {}
  Made make_with_guests(const std::string& name, RunChoice choice = {}) {
    choice.on_ready = [this](const RunInHand& hand) { guests_.join(hand); };
    return make(name, choice);
  }

  Guests guests_;
};

TEST_F(HelmedRun, TheLogHoldsWhatWasDoneAndMakesTheRunAgain) {
  const Made made = make_with_guests("run.nc");
  EXPECT_EQ(guests_.barriers, 1200);
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  EXPECT_EQ(log.attribute("log_format"), "6");
  const std::vector<Command> commands = commands_in(log);
  ASSERT_EQ(commands.size(), made.result.commands.size());
  EXPECT_GT(commands.size(), 150U);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const Command &was = made.result.commands[i], &is = commands[i];
    ASSERT_EQ(is.step, was.step);
    ASSERT_EQ(is.agent, was.agent);
    ASSERT_EQ(is.source, was.source);
    ASSERT_EQ(is.sequence, was.sequence);
    ASSERT_EQ(is.received_s, was.received_s);
    ASSERT_EQ(is.what.index(), was.what.index());
    ASSERT_EQ(twin::numbers_of(is.what), twin::numbers_of(was.what));
  }
  const std::vector<twin::RefusalCount> refusals = refusals_in(log);
  ASSERT_EQ(refusals, made.result.refusals);
  ASSERT_EQ(refusals.size(), 1U) << "mavlink was refused the vehicle that dds held";
  EXPECT_EQ(refusals[0].source, "mavlink 255");
  EXPECT_EQ(refusals[0].reason, twin::RefusalReason::unauthorised);
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const ReplayResult again = replayed(made.log, threads, is_batch);
      EXPECT_TRUE(again.is_identical) << again.difference;
    }
}

/// A drive of an hour: what the tables of its log hold is not bounded by what is usual in a minute.
TEST_F(HelmedRun, ALogOfALongDriveIsReadAsItWasWritten) {
  std::vector<Command> commands;
  for (std::uint64_t i = 0; i < 40'000; ++i) {
    twin::CommandWhat what = twin::SetVelocity{{0.001 * static_cast<double>(i), 0, 0, 0.1}};
    if (i % 3 == 1) what = twin::HoldHere{};
    if (i % 3 == 2) what = twin::SetThrusters{{0.25, -0.5}};
    commands.push_back({2 * i, i % 3, what, "dds " + std::to_string(i * i % 2000), i, 0.1});
  }
  for (std::uint64_t i = 0; i < 2000; ++i)
    commands.push_back({80'000, 0, twin::HoldHere{}, "http " + std::to_string(i), i, 4000});
  std::vector<twin::RefusalCount> refusals;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    refusals.push_back({"http " + std::to_string(i), "rov", twin::RefusalReason::unauthorised,
                        i + 1, 0.5, std::string(103, 'x') + std::to_string(1000 + i)});
  }
  ingest::TrajectoryFile log = make("run.nc", {}).result.file;
  log.tables = command_tables(commands, refusals, 0.05);
  const std::filesystem::path path = folder_.path() / "long.nc";
  ingest::write_trajectories(log, path);
  const ingest::TrajectoryFile read = ingest::read_trajectories(path);
  EXPECT_GT(read.find_table("client")->rows(), 2000U);
  const std::vector<Command> is = commands_in(read);
  ASSERT_EQ(is.size(), commands.size());
  for (std::size_t i = 0; i < is.size(); ++i) {
    ASSERT_EQ(is[i].step, commands[i].step);
    ASSERT_EQ(is[i].source, commands[i].source);
    ASSERT_EQ(is[i].what.index(), commands[i].what.index());
    ASSERT_EQ(twin::numbers_of(is[i].what), twin::numbers_of(commands[i].what));
  }
  EXPECT_EQ(refusals_in(read), refusals);
}

TEST_F(HelmedRun, OfTenThousandCommandsTheLogMakesTheRunAgain) {
  RunChoice choice;
  std::uint64_t sequence = 0;
  choice.on_ready = [&](const RunInHand& hand) {
    hand.run.at_opening([&, arbiter = &hand.arbiter](const twin::StepTime& time) {
      for (int i = 0; i < 9; ++i) {
        const twin::SetVelocity what{{0.3, 0.01 * i, 0, 0.1}};
        (void)arbiter->submit("dds 01.0f", {0, 0, what, "", ++sequence, time.start_s},
                              time.start_s);
      }
    });
  };
  const Made made = make("run.nc", choice);
  EXPECT_GT(made.result.commands.size(), 10'000U);
  const ReplayResult again = replayed(made.log);
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST_F(HelmedRun, ARunThatNobodyTookPartInHasNoneOfIt) {
  const Made made = make("run.nc", {});
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  for (const char* table : {"client", "command", "content", "refusal"})
    EXPECT_EQ(log.find_table(table), nullptr) << table;
  EXPECT_EQ(log.attribute("stopped_at_step"), "");
  EXPECT_TRUE(replayed(made.log).is_identical);
  // Nor has one that somebody only looked at.
  RunChoice choice;
  choice.on_ready = [](const RunInHand&) {};
  const Made watched = make("watched.nc", choice);
  EXPECT_EQ(sha256_of_file(watched.log), sha256_of_file(made.log));
}

TEST_F(HelmedRun, ACheckpointOnTheWayLeavesTheSameLog) {
  const Made whole = make_with_guests("whole.nc");
  RunChoice choice;
  choice.checkpoint = folder_.path() / "half.checkpoint";
  choice.checkpoint_at_s = 8;
  guests_ = {};
  (void)make_with_guests("first.nc", choice);
  // The rest by its record: the queue has it from there on.
  RunChoice rest;
  rest.restore = choice.checkpoint;
  rest.threads = 2;
  for (const Command& command : whole.result.commands)
    if (command.step >= 160) rest.record.commands.push_back(command);
  const Made second = make("second.nc", rest);
  EXPECT_EQ(second.result.commands.size(), whole.result.commands.size());
  // Commands that were refused after that time are not in a record of those that were taken.
  ASSERT_EQ(second.result.refusals.size(), 1U);
  EXPECT_LT(second.result.refusals[0].count, whole.result.refusals[0].count);
  EXPECT_GT(second.result.refusals[0].count, 0U);
  const auto tracks = [](const Made& made) {
    return std::pair{made.result.log.t_s, made.result.log.rows};
  };
  EXPECT_EQ(std::memcmp(tracks(second).second[0].data(), tracks(whole).second[0].data(),
                        8 * tracks(whole).second[0].size()),
            0);
  rest.record.refusals = whole.result.refusals;
  EXPECT_EQ(sha256_of_file(make("second.nc", rest).log), sha256_of_file(whole.log));
}

TEST_F(HelmedRun, OneThatWasEndedFromOutsideIsEndedThereAgain) {
  twin::RunControl control;
  bool is_over = false;
  RunChoice choice;
  choice.control = &control;
  choice.on_ready = [&](const RunInHand& hand) {
    guests_.join(hand);
    EXPECT_EQ(&hand.control, &control);
    hand.run.at_barrier([&](const twin::StepTime& time) {
      if (time.step == 332) control.stop();
    });
  };
  choice.on_over = [&] { is_over = true; };
  const Made made = make("run.nc", choice);
  EXPECT_TRUE(is_over);
  EXPECT_EQ(made.result.stopped_at_step, 333U);
  EXPECT_NEAR(made.result.account.ran_s, 16.65, 1e-9);
  const ReplayResult again = replayed(made.log);
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST_F(HelmedRun, WhoTookPartIsToldThatItIsOverEvenWhereItFails) {
  bool is_over = false;
  RunChoice choice;
  choice.on_ready = [](const RunInHand&) { throw Error(ErrorKind::unavailable, "no domain"); };
  choice.on_over = [&] { is_over = true; };
  EXPECT_THROW((void)run_scenario(scenario_, water_, choice), Error);
  EXPECT_TRUE(is_over);
}

TEST_F(HelmedRun, ARunThatWasChangedInItsRecordIsTold) {
  const Made made = make_with_guests("run.nc");
  ingest::TrajectoryFile changed = ingest::read_trajectories(made.log);
  for (ingest::TrajectoryTable& table : changed.tables)
    if (table.name == "content") table.columns[0].values[0] += 1e-9;
  const std::filesystem::path other = folder_.path() / "changed.nc";
  ingest::write_trajectories(changed, other);
  const ReplayResult again = replayed(other);
  EXPECT_FALSE(again.is_identical);
  EXPECT_NE(again.difference.find("rov"), std::string::npos) << again.difference;
}

TEST_F(HelmedRun, ARecordThatCannotBeIsRefusedWithOneSentence) {
  const Made made = make_with_guests("run.nc");
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  const auto with = [&](const char* table, const char* column, double value) {
    ingest::TrajectoryFile changed = log;
    for (ingest::TrajectoryTable& t : changed.tables)
      for (auto& c : t.columns)
        if (t.name == table && c.name == column) c.values[0] = value;
    return changed;
  };
  for (const auto& [table, column, value] :
       {std::tuple{"command", "vehicle", 3.0}, std::tuple{"command", "client", -1.0},
        std::tuple{"command", "step", 0.5}, std::tuple{"command", "numbers", 1e9},
        std::tuple{"command", "numbers", 3.0}, std::tuple{"command", "sequence", 1e300}})
    EXPECT_THROW((void)commands_in(with(table, column, value)), Error) << column;
  const std::filesystem::path other = folder_.path() / "changed.nc";
  ingest::write_trajectories(with("content", "value", std::nan("")), other);
  EXPECT_THROW((void)replayed(other), Error);
}

}  // namespace
}  // namespace slackwater::tests::helmed_run_test
