// Several sessions of one server, by scripted stations at raw sockets: each by itself, begun and
// ended by a supervisor alone.
#include "api/door/sessions/session_host.h"

#include <gtest/gtest.h>

#include "api/door/http/server.h"
#include "api/door/sessions/host_routes.h"
#include "api/log/action_tables.h"
#include "data/store/store.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/api/door/sessions/operators_for_tests.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"

namespace slackwater::tests::session_host_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

const std::string& ann = tokens_for_tests().at("Ann");
const std::string& bob = tokens_for_tests().at("Bob");
const std::string& sue = tokens_for_tests().at("Sue");

UtcTime wall() {
  return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

/// A server of four sessions, two at once.
struct ServeSessions : testing::Test {
  ServeSessions() {
    std::filesystem::create_directories(folder / "logs");
    write_file(folder / "one.yaml", rovs_yaml("one rov", {"rov 1"}));
    write_file(folder / "two.yaml", rovs_yaml("two boats", {"east", "west"}));
    write_file(folder / "mission.yaml",
               "{name: Scour at A02, site: example_farm, tasks: [scour_survey], turbines: [A02], "
               "seed: 1, duration: 3h, water: {made_up: {depth_m: 60}}}\n");
    write_file(folder / "sessions.yaml",
               "sessions:\n  - {id: a, scenario: one.yaml}\n  - {id: b, scenario: two.yaml}\n"
               "  - {id: a-2, scenario: one.yaml}\n"
               "  - {id: scour, mission: mission.yaml, real_time_factor: 10}\n"
               "most_at_once: 2\nlogs: logs\n" +
                   people_yaml());
    host = std::make_shared<sessions::SessionHost>(
        sessions::read_operator_file(folder / "sessions.yaml", folder / "store"), folder / "store",
        wall);
    api::http::Router router;
    sessions::add_routes(router, host);
    api::http::ServerOptions options;
    options.read_only = true;
    options.guards_itself = sessions::is_for_supervisors;
    options.methods_at = [router](const std::string& path) { return router.methods_at(path); };
    server = std::make_unique<api::http::Server>(options, router);
    server->start();
    port = server->port();
  }
  [[nodiscard]] bool is_in(const std::string& id, const std::string& state) const {
    return comes_true([&] { return listed_session(port, id).value("state", "") == state; }, 60s);
  }
  void begin(const std::string& offer, const std::string& id) const {
    const HttpReply reply = begin_session(port, offer);
    ASSERT_EQ(reply.status, 201) << reply.body;
    EXPECT_EQ(json::parse(reply.body)["id"], id);
    EXPECT_EQ(reply.field("location"), "/sessions/" + id);
    ASSERT_TRUE(is_in(id, "running")) << listed_sessions(port);
  }
  void end(const std::string& id) const {
    const HttpReply reply = post(port, "/sessions/" + id + "/end", sue);
    EXPECT_EQ(reply.status, 202) << reply.body;
    ASSERT_TRUE(is_in(id, "over")) << listed_sessions(port);
  }
  [[nodiscard]] StationClient station(const std::string& id, const std::string& token) const {
    return StationClient(port, token, {}, id);
  }
  [[nodiscard]] std::vector<std::filesystem::path> logs() const {
    std::vector<std::filesystem::path> all;
    for (const auto& file : std::filesystem::directory_iterator(folder / "logs"))
      all.push_back(file.path());
    std::sort(all.begin(), all.end());
    return all;
  }

  TemporaryFolder folder;
  std::shared_ptr<sessions::SessionHost> host;
  std::unique_ptr<api::http::Server> server;
  std::uint16_t port = 0;
};

TEST_F(ServeSessions, ListsWhatMayBeBegunAndThatNothingIsYet) {
  const json listed = listed_sessions(port);
  EXPECT_EQ(listed["sessions"], json::array());
  EXPECT_EQ(listed["may_begin"][1], (json{{"id", "b"}, {"name", "two boats"}}));
  EXPECT_EQ(listed["most_at_once"], 2);
  EXPECT_EQ(listed["under_way"], 0);
  EXPECT_EQ(HttpClient(port).get("/session")->status, 200);
}

TEST_F(ServeSessions, AtOnceDoNotSeeEachOtherAndEachHasItsOwnRecordAndLog) {
  begin("a", "a");
  begin("b", "b");
  StationClient anns = station("a", ann), bobs = station("b", bob);
  const json seen_by_ann = anns.hello("Ann"), seen_by_bob = bobs.hello("Bob");
  ASSERT_EQ(seen_by_ann["vehicles"].size(), 1U);
  EXPECT_EQ(seen_by_ann["vehicles"][0]["name"], "rov 1");
  EXPECT_EQ(seen_by_ann["session"], "a");
  EXPECT_EQ(seen_by_ann["title"], "one rov");
  ASSERT_EQ(seen_by_bob["vehicles"].size(), 2U);
  EXPECT_EQ(seen_by_bob["vehicles"][1]["name"], "west");
  EXPECT_EQ(seen_by_bob["seats"].size(), 1U);
  EXPECT_EQ(anns.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  EXPECT_EQ(anns.asks(anns.command("stick", 0, {{"velocity", {0.3, 0, 0, 0}}}))["taken"], true);
  EXPECT_EQ(anns.asks({{"do", "say"}, {"text", "for my session alone"}})["taken"], true);
  bobs.listen(500ms);
  for (const json& told : bobs.messages) {
    EXPECT_NE(told["is"], "said") << told;
    if (told["is"] == "helm") EXPECT_EQ(told["state"], "free") << told;
  }
  // The seat of one opens nothing in the other, and the same person may sit in both.
  EXPECT_EQ(station("b", seen_by_ann["resume"]).status(), 401);
  StationClient also = station("b", ann);
  EXPECT_EQ(also.hello("Ann")["seats"].size(), 2U);
  EXPECT_EQ(also.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  end("a");
  EXPECT_EQ(anns.closed(), 4000);
  EXPECT_EQ(bobs.asks({{"do", "ask"}, {"vehicle", 1}})["taken"], true) << "the other one goes on";
  end("b");
  ASSERT_EQ(logs().size(), 2U);
  store::Store store = store::Store::open(folder / "store", store::OpenMode::read_only);
  std::map<std::string, std::vector<people::Action>> filed;
  for (const store::SessionRow& row : store.list_sessions())
    filed[row.name] = store.find_actions(row.id);
  ASSERT_EQ(filed.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string id = i == 0 ? "a" : "b";
    EXPECT_EQ(logs()[i].filename().string().find(id + "-2"), 0U) << logs()[i];
    EXPECT_EQ(logs()[i].filename().string().size(), std::string("a-20250310T050002Z.nc").size());
    const auto in_log = api::actions_in(ingest::read_trajectories(logs()[i]));
    EXPECT_EQ(in_log, filed[id]) << id;
    EXPECT_GE(in_log.size(), 3U);
    for (const people::Action& row : in_log)
      if (i == 0) EXPECT_EQ(row.who, "Ann") << "Bob was in the other one";
  }
}

TEST_F(ServeSessions, OfAMissionAreFlownByPeopleAndMadeAgainFromTheirLog) {
  begin("scour", "scour");
  StationClient anns = station("scour", ann);
  const json seen = anns.hello("Ann");
  EXPECT_EQ(seen["title"], "Scour at A02");
  ASSERT_GE(seen["vehicles"].size(), 1U);
  EXPECT_EQ(anns.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  EXPECT_EQ(anns.asks(anns.command("hold", 0))["taken"], true);
  end("scour");
  ASSERT_EQ(logs().size(), 1U);
  const api::ReplayResult again = api::replay(logs()[0], folder / "store", std::nullopt, {});
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST_F(ServeSessions, GoOnToAsManyAsMayBeAtOnceAndTheNextRunHasAnIdOfItsOwn) {
  begin("a", "a");
  begin("a", "a-3");  // a-2 is another one
  const HttpReply third = begin_session(port, "b");
  EXPECT_EQ(third.status, 409);
  EXPECT_TRUE(contains(third.body, "found 2 sessions under way"));
  EXPECT_EQ(listed_sessions(port)["under_way"], 2);
  end("a");
  EXPECT_EQ(
      HttpClient(port).get("/sessions/a/check", "Authorization: Bearer " + ann + "\r\n")->status,
      410);
  begin("b", "b");
  EXPECT_EQ(post(port, "/sessions/a/end", sue).status, 202) << "what is over may be ended again";
  EXPECT_EQ(listed_session(port, "a")["state"], "over");
}

TEST_F(ServeSessions, RefuseEachRequestWithItsOwnStatusAndShowNoToken) {
  begin("a", "a");
  const std::string json_type = "Content-Type: application/json\r\n";
  const std::string begin_b = R"({"begin": "b"})";
  struct Case {
    std::string path, token, body, fields;
    int status;
    std::string words;
  };
  const std::string wrong = "wrong-0123456789abcdef";
  const std::vector<Case> cases{
      {"/sessions", "", begin_b, json_type, 401, "of a supervisor"},
      {"/sessions", wrong, begin_b, json_type, 401, "found no token"},
      {"/sessions", tokens_for_tests().at("Old"), begin_b, json_type, 401, "ended at 2020"},
      {"/sessions", ann, begin_b, json_type, 403, "your role is operator"},
      {"/sessions", tokens_for_tests().at("Gus"), begin_b, json_type, 403, "spectator"},
      {"/sessions", sue, R"({"begin": "c"})", json_type, 404, "expected one of a, b, a-2"},
      {"/sessions", sue, begin_b, "", 415, "expected application/json"},
      {"/sessions", sue, begin_b, "Content-Type: text/plain\r\n", 415, "text/plain"},
      {"/sessions", sue, begin_b, "Content-Type: application/jsonp\r\n", 415, "jsonp"},
      {"/sessions", sue, "", json_type, 400, "expected {"},
      {"/sessions", sue, "{", json_type, 400, ""},
      {"/sessions", sue, "[]", json_type, 400, ""},
      {"/sessions", sue, R"("b")", json_type, 400, ""},
      {"/sessions", sue, R"({"begin": 7})", json_type, 400, ""},
      {"/sessions", sue, R"({"begin": "b", "factor": 9})", json_type, 400, ""},
      {"/sessions", sue, std::string(100'000, '['), json_type, 400, ""},
      {"/sessions", sue, begin_b, json_type + "Origin: https://evil.example\r\n", 403,
       "another origin"},
      {"/sessions", sue, begin_b, json_type + "Origin: null\r\n", 403, "another origin"},
      {"/sessions/a/end", "", "", "", 401, "of a supervisor"},
      {"/sessions/a/end", ann, "", "", 403, "operator"},
      {"/sessions/a/end", sue, "", "Origin: https://evil.example\r\n", 403, "another origin"},
      {"/sessions/b/end", sue, "", "", 404, "found no session 'b', expected a"},
      {"/sessions/a", sue, "", "", 405, "not served"},
      {"/sessions/a/check", sue, "", "", 405, "not served"},
      {"/session", sue, "", "", 405, "not served"},
      {"/", sue, "", "", 405, "not served"}};
  for (const Case& one : cases) {
    const HttpReply reply = post(port, one.path, one.token, one.body, one.fields);
    EXPECT_EQ(reply.status, one.status) << one.path << " " << one.fields << one.body.substr(0, 40);
    EXPECT_TRUE(contains(reply.body, one.words));
    EXPECT_LT(reply.body.size(), 1'000U);
    for (const auto& [name, token] : tokens_for_tests())
      EXPECT_EQ(reply.body.find(token), std::string::npos);
    EXPECT_EQ(reply.body.find(wrong), std::string::npos);
    if (one.status == 401) EXPECT_EQ(reply.field("www-authenticate"), "Bearer");
  }
  EXPECT_EQ(listed_session(port, "a")["state"], "running");
  EXPECT_EQ(listed_sessions(port)["sessions"].size(), 1U) << "nothing was begun";
  const std::string own = "Origin: http://127.0.0.1\r\nContent-Type: application/json; x=y\r\n";
  EXPECT_EQ(post(port, "/sessions", sue, begin_b, own).status, 201) << "but by its own page";
  HttpClient client(port);
  for (const char* const path :
       {"/sessions/c/check", "/sessions/c/actions", "/sessions/c/socket", "/sessions/c"}) {
    const auto reply = client.get(path);
    EXPECT_EQ(reply->status, 404) << path;
    EXPECT_TRUE(contains(reply->body, "expected a, b")) << path;
  }
  EXPECT_EQ(client.get("/sessions/a/actions")->status, 401);
  EXPECT_EQ(json::parse(client.get("/sessions/a")->body)["of"], "a");
}

// What is wrong with one run is said in the list, and is no other's trouble.
TEST_F(ServeSessions, ThatCannotRunFailWithTheReasonAndTheOthersGoOn) {
  begin("b", "b");
  StationClient bobs = station("b", bob);
  ASSERT_TRUE(bobs.hello("Bob").is_object());
  write_file(folder / "one.yaml", "name: one rov\nseed: many\n");
  EXPECT_EQ(begin_session(port, "a").status, 201);
  ASSERT_TRUE(is_in("a", "failed")) << listed_sessions(port);
  EXPECT_TRUE(contains(listed_session(port, "a")["why"], "one.yaml:2: seed"));
  std::string water = rovs_yaml("one rov", {"rov 1"});
  water.replace(water.find("{made_up: {depth_m: 60}}"), 24, "{forecast: {site: nowhere}}");
  write_file(folder / "one.yaml", water);
  EXPECT_EQ(begin_session(port, "a").status, 201);
  ASSERT_TRUE(is_in("a-3", "failed")) << listed_sessions(port);
  EXPECT_TRUE(contains(listed_session(port, "a-3")["why"], "nowhere"));
  EXPECT_EQ(station("a-3", ann).status(), 410);
  EXPECT_EQ(bobs.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  EXPECT_EQ(listed_sessions(port)["under_way"], 1);
}

TEST_F(ServeSessions, WhoseLogCannotBeWrittenFailAndKeepTheirRecord) {
  begin("a", "a");
  StationClient anns = station("a", ann);
  ASSERT_TRUE(anns.hello("Ann").is_object());
  std::filesystem::remove(folder / "logs");
  EXPECT_EQ(post(port, "/sessions/a/end", sue).status, 202);
  ASSERT_TRUE(is_in("a", "failed")) << listed_sessions(port);
  EXPECT_TRUE(contains(listed_session(port, "a")["why"], "its log: "));
  store::Store store = store::Store::open(folder / "store", store::OpenMode::read_only);
  EXPECT_GE(store.find_actions(1).size(), 1U);
}

TEST_F(ServeSessions, EndWithTheServerAndBeginNoMore) {
  begin("a", "a");
  begin("b", "b");
  StationClient anns = station("a", ann);
  ASSERT_TRUE(anns.hello("Ann").is_object());
  host->stop();
  EXPECT_EQ(listed_session(port, "a")["state"], "over");
  EXPECT_EQ(listed_session(port, "b")["state"], "over");
  EXPECT_EQ(logs().size(), 2U);
  EXPECT_FALSE(anns.told("bye").is_null());
  EXPECT_EQ(begin_session(port, "a").status, 503);
}

// Who comes and goes for weeks leaves a short list.
TEST_F(ServeSessions, ThatAreOverAreForgottenTheOldestFirst) {
  begin("b", "b");
  for (std::size_t i = 0; i < sessions::SessionHost::most_ended + 2; ++i) {
    const HttpReply reply = begin_session(port, "a");
    ASSERT_EQ(reply.status, 201) << reply.body;
    const std::string id = json::parse(reply.body)["id"];
    EXPECT_EQ(post(port, "/sessions/" + id + "/end", sue).status, 202);
    ASSERT_TRUE(is_in(id, "over")) << listed_sessions(port);
  }
  EXPECT_LE(listed_sessions(port)["sessions"].size(), sessions::SessionHost::most_ended + 2);
  EXPECT_TRUE(listed_session(port, "a").is_null());
  EXPECT_EQ(listed_session(port, "b")["state"], "running") << "what runs is never forgotten";
}

}  // namespace
}  // namespace slackwater::tests::session_host_test
