// `slackwater serve --sessions` as its operators begin it and end it.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "tests/api/door/people/station_for_tests.h"
#include "tests/api/door/sessions/operators_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/started_program.h"

namespace slackwater::tests::serve_sessions_command_test {
namespace {

using nlohmann::json;

const std::string& ann = tokens_for_tests().at("Ann");
const std::string& sue = tokens_for_tests().at("Sue");

std::string text_in(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct ServeSessionsCommand : testing::Test {
  ServeSessionsCommand() {
    std::filesystem::create_directories(folder / "logs");
    write_file(folder / "one.yaml", rovs_yaml("one rov", {"rov 1"}));
    write_file(folder / "sessions.yaml",
               "sessions:\n  - {id: dawn, scenario: one.yaml, begins: at_start}\n"
               "  - {id: dusk, scenario: one.yaml}\nlogs: logs\n" +
                   people_yaml());
  }
  void start() {
    program.emplace(start_program({"serve", "--sessions", folder / "sessions.yaml", "--port", "0",
                                   "--store", folder / "store", "--json"},
                                  {}, folder / "out", folder / "err"));
    ASSERT_TRUE(comes_true([&] { return text_in(folder / "out").ends_with("\n"); },
                           std::chrono::seconds(60)))
        << text_in(folder / "err");
    port = json::parse(text_in(folder / "out"))["port"];
  }
  [[nodiscard]] bool runs(const std::string& id) const {
    return comes_true([&] { return listed_session(port, id).value("state", "") == "running"; },
                      std::chrono::seconds(60));
  }

  TemporaryFolder folder;
  std::optional<StartedProgram> program;
  std::uint16_t port = 0;
};

TEST_F(ServeSessionsCommand, ThatIsTerminatedLeavesWholeLogsOfAllRunsAndTellsTheirStations) {
  ASSERT_NO_FATAL_FAILURE(start());
  ASSERT_TRUE(runs("dawn")) << "it begins with the server";
  ASSERT_EQ(begin_session(port, "dusk").status, 201);
  ASSERT_TRUE(runs("dusk"));
  StationClient dawn(port, ann, {}, "dawn"), dusk(port, ann, {}, "dusk");
  StationClient supervisor(port, sue, {}, "dusk");
  for (StationClient* const station : {&dawn, &dusk}) {
    ASSERT_TRUE(station->hello("Ann").is_object());
    EXPECT_EQ(station->asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(
          station->asks(station->command("stick", 0, {{"velocity", {0.2, 0, 0, 0}}}))["taken"],
          true);
  }
  // One of them is paused, which keeps nobody.
  ASSERT_TRUE(supervisor.hello("Sue").is_object());
  EXPECT_EQ(supervisor.asks({{"do", "pause"}})["taken"], true);
  ASSERT_EQ(program->end(SIGTERM), 0) << text_in(folder / "err");
  for (StationClient* const station : {&dawn, &dusk, &supervisor}) {
    EXPECT_EQ(station->closed(), 4000);
    EXPECT_TRUE(std::any_of(station->messages.begin(), station->messages.end(),
                            [](const json& told) { return told["is"] == "bye"; }));
  }
  std::size_t logs = 0;
  for (const auto& log : std::filesystem::directory_iterator(folder / "logs")) {
    ++logs;
    const ProgramResult replayed = run_program({"replay", log.path(), "--store", folder / "store"});
    EXPECT_EQ(replayed.exit_code, 0) << log.path() << replayed.err << replayed.out;
  }
  EXPECT_EQ(logs, 2U);
  for (int session = 1; session <= 2; ++session) {
    const ProgramResult shown =
        run_program({"sessions", std::to_string(session), "--json", "--store", folder / "store"});
    ASSERT_EQ(shown.exit_code, 0) << shown.err;
    EXPECT_GE(json::parse(shown.out)["actions"].size(), 3U);
  }
  const ProgramResult listed = run_program({"sessions", "--store", folder / "store"});
  EXPECT_TRUE(contains(listed.out, "dawn"));
  EXPECT_TRUE(contains(listed.out, "dusk"));
  const std::string said = text_in(folder / "err") + text_in(folder / "out");
  EXPECT_TRUE(contains(said, "session begun session=dawn by=\"the server\""));
  EXPECT_TRUE(contains(said, "session begun session=dusk by=Sue"));
  EXPECT_TRUE(contains(said, "session over session=dusk"));
  for (const auto& [name, token] : tokens_for_tests())
    EXPECT_EQ(said.find(token), std::string::npos) << "a token is in no log";
}

TEST_F(ServeSessionsCommand, OfAFileThatCannotBeReadIsRefused) {
  const auto serve = [&] {
    return run_program({"serve", "--sessions", folder / "sessions.yaml", "--port", "0", "--store",
                        folder / "store"});
  };
  write_file(folder / "one.yaml", "name: x\n");
  expect_refusal(serve(), 3, {"sessions.yaml:2: sessions[0].scenario: ", "one.yaml"});
  std::filesystem::remove(folder / "sessions.yaml");
  expect_refusal(serve(), 4, {"sessions.yaml"});
}

// Forecasts are still served, and nothing of them is written to.
TEST_F(ServeSessionsCommand, ServesForecastsBesideAndWritesNothingElse) {
  ASSERT_NO_FATAL_FAILURE(start());
  HttpClient client(port);
  EXPECT_EQ(client.get("/collections")->status, 200);
  EXPECT_EQ(post(port, "/collections", sue, "{}").status, 405);
  EXPECT_EQ(post(port, "/sessions/dawn/end", ann).status, 403);
  EXPECT_TRUE(contains(client.get("/metrics")->body,
                       R"(route="/sessions/{session}/end",method="POST",status="403"} 1)"));
  EXPECT_EQ(program->end(SIGTERM), 0);
}

// The kernel chooses which thread gets a signal; OpenBLAS begins some of its own before `main`.
TEST_F(ServeSessionsCommand, EndsInOrderWhicheverThreadGetsTheSignal) {
  ASSERT_NO_FATAL_FAILURE(start());
  const std::filesystem::path threads = "/proc/" + std::to_string(program->process()) + "/task";
  std::vector<pid_t> all;
  for (const auto& entry : std::filesystem::directory_iterator(threads))
    all.push_back(std::stoi(entry.path().filename()));
  EXPECT_GT(all.size(), 2U) << "there are others beside the one that waits for it";
  for (const pid_t thread : all)
    if (thread != program->process())
      (void)::syscall(SYS_tgkill, program->process(), thread, SIGTERM);
  EXPECT_EQ(program->end(SIGTERM), 0) << text_in(folder / "err");
}

/// Of a JSON value all that is named by "$ref".
void add_references(const json& value, std::vector<std::string>& all) {
  if (value.is_object() && value.contains("$ref")) all.push_back(value["$ref"]);
  if (value.is_structured())
    for (const json& part : value) add_references(part, all);
}

TEST_F(ServeSessionsCommand, DescribesTheRoutesOfSessionsBesideThoseOfForecasts) {
  ASSERT_NO_FATAL_FAILURE(start());
  HttpClient client(port);
  const json document = json::parse(client.get("/api?f=json")->body);
  const json& paths = document["paths"];
  EXPECT_TRUE(paths.contains("/collections/{collectionId}/position"));
  EXPECT_TRUE(paths["/sessions"]["post"]["responses"].contains("409"));
  EXPECT_TRUE(paths["/sessions/{sessionId}/end"]["post"].contains("security"));
  std::vector<std::string> references;
  add_references(document, references);
  EXPECT_GT(references.size(), 100U);
  for (const std::string& one : references)
    EXPECT_TRUE(document.contains(json::json_pointer(one.substr(1)))) << one;
  const auto page = client.get("/api?f=html");
  EXPECT_TRUE(contains(page->body, "<h2>POST /sessions</h2>"));
  EXPECT_TRUE(contains(page->body, "<h2>GET /collections</h2>"));
}

}  // namespace
}  // namespace slackwater::tests::serve_sessions_command_test
