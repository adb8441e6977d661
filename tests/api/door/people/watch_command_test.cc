// `slackwater watch` as its users begin it, are refused, and end it.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::watch_command_test {
namespace {

using nlohmann::json;

/// A log that `simulate` wrote, watched in a process of its own.
struct WatchCommand : testing::Test {
  WatchCommand() {
    std::string yaml = calm_head(0.05);
    yaml.replace(yaml.find("30min"), 5, "1min");
    std::ofstream(folder / "run.yaml")
        << yaml
        << "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, "
           "tasks: [{do: hold}]}\n";
    const ProgramResult made =
        run_program({"simulate", folder / "run.yaml", "--out", log, "--store", folder / "store"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
  }
  [[nodiscard]] std::string out() const {
    std::ostringstream text;
    text << std::ifstream(folder / "out").rdbuf();
    return text.str();
  }
  /// @return its port
  std::uint16_t begin() {
    program.emplace(start_program({"watch", log, "--port", "0"}, {}, folder / "out"));
    const std::string before = "watch: http://127.0.0.1:";
    EXPECT_TRUE(comes_true([&] { return contains(out(), "Ctrl-C"); }, std::chrono::seconds(60)));
    return static_cast<std::uint16_t>(std::stoi(out().substr(out().find(before) + before.size())));
  }

  TemporaryFolder folder;
  std::filesystem::path log = folder / "log.nc";
  std::optional<StartedProgram> program;
};

TEST_F(WatchCommand, ServesThePageAndPlaysTheLogUntilItIsInterrupted) {
  const std::uint16_t port = begin();
  EXPECT_TRUE(contains(out(), "/session (60 s, 0 actions)")) << out();
  HttpClient client(port);
  EXPECT_EQ(client.get("/session")->status, 200);
  EXPECT_EQ(json::parse(client.get("/sessions")->body)["sessions"][0]["state"], "recorded");
  StationClient station{StationClient::AtLog{port}};
  const json welcome = station.hello("");
  EXPECT_EQ(welcome["vehicles"][0]["kind"], "rov");
  EXPECT_EQ(welcome["playback"]["to_s"], 60.0);
  EXPECT_EQ(welcome["water"], json({{"forecast", nullptr}})) << "made up";
  EXPECT_EQ(welcome["bed"]["up_m"][0], -60.0);
  EXPECT_EQ(station.asks({{"do", "play"}, {"rate", 10}})["taken"], true);
  EXPECT_EQ(program->end(SIGINT), 0);
  EXPECT_EQ(station.closed(), 4000) << "those who watch are told";
}

TEST_F(WatchCommand, RefusesWhatIsNoLogInOneLine) {
  expect_refusal(run_program({"watch", folder / "nothing.nc"}), 4, {"nothing.nc"});
  expect_refusal(run_program({"watch", folder / "run.yaml"}), 3, {"run.yaml"});
  std::filesystem::resize_file(log, std::filesystem::file_size(log) / 2);
  expect_refusal(run_program({"watch", log}), 3, {"log.nc"});
  EXPECT_EQ(run_program({"watch"}).exit_code, 2);
}

TEST_F(WatchCommand, SaysThatItsPortIsTaken) {
  const std::uint16_t port = begin();
  expect_refusal(run_program({"watch", log, "--port", std::to_string(port)}), 5,
                 {std::to_string(port)});
}

}  // namespace
}  // namespace slackwater::tests::watch_command_test
