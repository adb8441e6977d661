// `slackwater live --people` as its users begin it, end it, and lose it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/api/door/live/live_records.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/keep_secret.h"
#include "tests/support/refusal.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::people_command_test {
namespace {

using nlohmann::json;

const std::string ann = "ann-0123456789abcdef", sue = "sue-0123456789abcdef";

std::string text_in(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A live run with people, in a process of its own.
struct PeopleCommand : testing::Test {
  PeopleCommand() {
    std::ofstream(folder / "run.yaml")
        << calm_head(0.05)
        << "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
           "tasks: [{do: hold}]}\n";
    std::ofstream(folder / "people.yaml")
        << "people:\n  - {name: Ann, role: operator, token: " << ann
        << ", until: 2100-01-01T00:00:00Z}\n  - {name: Sue, role: supervisor, token: " << sue
        << ", until: 2100-01-01T00:00:00Z}\n";
    keep_secret(folder / "people.yaml");
    program.emplace(start_program(
        {"live", folder / "run.yaml", "--people", "0", "--people-file", folder / "people.yaml",
         "--store", folder / "store", "--out", folder / "log.nc", "--record", folder / "live.mcap"},
        {}, folder / "out", folder / "err"));
    EXPECT_TRUE(comes_true([&] { return contains_port(); }, std::chrono::seconds(60)));
  }
  bool contains_port() {
    const std::string err = text_in(folder / "err");
    const std::string before = "people: http://127.0.0.1:";
    const std::size_t at = err.find(before);
    if (at == std::string::npos || err.find("vehicle rov 1") == std::string::npos) return false;
    port = static_cast<std::uint16_t>(std::stoi(err.substr(at + before.size())));
    return true;
  }
  [[nodiscard]] ProgramResult slackwater(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--store", folder / "store"});
    return run_program(arguments);
  }
  /// Takes the helm and drives; how many rows of the record that leaves.
  static std::size_t drive(StationClient& station) {
    EXPECT_TRUE(station.hello("Ann").is_object());
    EXPECT_EQ(station.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
    for (int i = 0; i < 10; ++i)
      EXPECT_EQ(station.asks(station.command("stick", 0, {{"velocity", {0.2, 0, 0, 0}}}))["taken"],
                true);
    EXPECT_EQ(station.asks(station.command("hold", 0))["taken"], true);
    return 5;  // join, ask, stick, stick_end, hold
  }

  TemporaryFolder folder;
  std::optional<StartedProgram> program;
  std::uint16_t port = 0;
};

TEST_F(PeopleCommand, LeavesALogThatReplaysAndARecordThatIsListed) {
  StationClient station(port, ann);
  const std::size_t rows = drive(station);
  ASSERT_EQ(program->end(SIGTERM), 0) << text_in(folder / "err");
  EXPECT_EQ(station.closed(), 4000);
  EXPECT_FALSE(contains(text_in(folder / "err"), ann)) << "a token is in no log";
  EXPECT_TRUE(contains(text_in(folder / "out"),
                       "to watch it again: slackwater watch " + (folder / "log.nc").string()));
  const ProgramResult replayed = slackwater({"replay", folder / "log.nc"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err << replayed.out;
  const ProgramResult listed = slackwater({"sessions"});
  EXPECT_TRUE(contains(listed.out, "test"));
  const ProgramResult shown =
      slackwater({"sessions", "1", "--json", "--csv", folder / "actions.csv"});
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_GE(json::parse(shown.out)["actions"].size(), rows);
  EXPECT_TRUE(contains(text_in(folder / "actions.csv"), "Ann,operator,hold,rov 1,held,hold,1,,,1"));
  const json score = json::parse(slackwater({"score", folder / "log.nc", "--json"}).out);
  EXPECT_EQ(score["people"][0]["name"], "Ann");
  EXPECT_EQ(score["runs"][0]["people"]["seats"][0]["vehicles"][0]["commands"], 11);
  EXPECT_TRUE(contains(slackwater({"score", folder / "log.nc"}).out, "11 commands taken"));
  expect_refusal(slackwater({"sessions", "7"}), 4, {"session 7 is not in the store"});
}

/// What a bag tells of a session: when, and the row.
std::vector<std::pair<std::int64_t, json>> actions_in_bag(const std::filesystem::path& path) {
  std::vector<std::pair<std::int64_t, json>> actions;
  for (const LiveMessage& message : messages_of(path))
    if (message.topic == "/slackwater/session/actions")
      // A string of CDR: its length, its letters, a zero.
      actions.emplace_back(
          message.log_time_ns,
          json::parse(std::string(message.payload.begin() + 8, message.payload.end() - 1)));
  return actions;
}

TEST_F(PeopleCommand, ABagHoldsWhatPeopleDidLiveMadeAgainAndExported) {
  StationClient station(port, ann);
  const std::size_t rows = drive(station);
  station.listen(std::chrono::milliseconds(500));
  EXPECT_EQ(station.asks(station.command("home", 0))["taken"], true);
  ASSERT_EQ(program->end(SIGTERM), 0) << text_in(folder / "err");
  ASSERT_EQ(slackwater({"sessions", "1", "--bag", folder / "actions.mcap"}).exit_code, 0);
  const ProgramResult again =
      slackwater({"replay", folder / "log.nc", "--record", folder / "again.mcap"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const json record = json::parse(slackwater({"sessions", "1", "--json"}).out)["actions"];
  ASSERT_GE(record.size(), rows);
  const auto exported = actions_in_bag(folder / "actions.mcap"),
             live = actions_in_bag(folder / "live.mcap"),
             made_again = actions_in_bag(folder / "again.mcap");
  ASSERT_EQ(exported.size(), record.size());
  ASSERT_EQ(live.size(), record.size());
  EXPECT_GT(record.back()["time_s"].get<double>(), 0);
  EXPECT_EQ(made_again, live);
  for (std::size_t i = 0; i < record.size(); ++i) {
    EXPECT_EQ(exported[i].second, record[i]);
    EXPECT_EQ(live[i].second, record[i]);
    // The run's own time, from the start that water without a date has.
    EXPECT_NEAR(static_cast<double>(live[i].first - 946'684'800'000'000'000),
                1e9 * record[i]["time_s"].get<double>(), 1'000);
    const UtcTime at = parse_utc(record[i]["at"].get<std::string>());
    EXPECT_EQ(exported[i].first, std::chrono::nanoseconds(at.time_since_epoch()).count());
  }
  expect_refusal(slackwater({"sessions", "1", "--bag", folder / "actions.mcap"}), 3,
                 {"actions.mcap"});
  expect_refusal(slackwater({"sessions", "1", "--bag", folder / "actions.csv"}), 2, {".mcap"});
  expect_refusal(slackwater({"sessions", "--bag", folder / "more.mcap"}), 2,
                 {"--bag: found no session", "sessions 1 --bag"});
}

// The server is killed: what people did until then is on record, and the store is sound.
TEST_F(PeopleCommand, ThatIsKilledLeavesAWholeRecord) {
  StationClient station(port, ann);
  const std::size_t rows = drive(station);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_EQ(program->end(SIGKILL), 128 + SIGKILL);
  const ProgramResult shown = slackwater({"sessions", "1", "--json"});
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  const json actions = json::parse(shown.out)["actions"];
  ASSERT_GE(actions.size(), rows);
  EXPECT_EQ(actions[4]["what"], "hold");
  for (std::size_t i = 0; i < actions.size(); ++i) EXPECT_EQ(actions[i]["number"], i + 1);
  const ProgramResult checked = slackwater({"store", "check"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
}

TEST_F(PeopleCommand, ServesThePageItsListAndTheCheckOfATokenAndNothingToStrangers) {
  HttpClient client(port);
  const auto page = client.get("/session");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_TRUE(contains(page->field("content-security-policy"), "default-src 'none'"));
  const auto list = client.get("/sessions");
  EXPECT_EQ(json::parse(list->body)["sessions"][0]["id"], "run");
  EXPECT_FALSE(contains(list->body, ann));
  EXPECT_EQ(client.get("/sessions/run/check", "Authorization: Bearer " + ann + "\r\n")->status,
            204);
  for (const char* const path : {"/sessions/run/check", "/sessions/run/actions"}) {
    EXPECT_EQ(client.get(path)->status, 401) << path;
    EXPECT_EQ(client.get(path, "Authorization: Bearer x\r\n")->status, 401) << path;
  }
  EXPECT_EQ(client.get("/sessions/run/socket")->status, 426);
}

}  // namespace
}  // namespace slackwater::tests::people_command_test
