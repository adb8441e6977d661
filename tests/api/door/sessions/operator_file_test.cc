// What an operator's file of sessions says, and how it is refused.
#include "api/door/sessions/operator_file.h"

#include <gtest/gtest.h>

#include "fields/base/text.h"
#include "tests/api/door/sessions/operators_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"

namespace slackwater::tests::operator_file_test {
namespace {

using sessions::OperatorFile;

struct ServeSessionsFile : testing::Test {
  ServeSessionsFile() {
    std::filesystem::create_directories(folder / "scenarios");
    std::filesystem::create_directories(folder / "logs");
    write_file(folder / "scenarios/one.yaml", rovs_yaml("one rov", {"rov 1"}));
    write_file(folder / "scenarios/broken.yaml", "name: broken\nseed: many\n");
    write_file(folder / "mission.yaml",
               "{name: Scour at A02, site: example_farm, tasks: [scour_survey], turbines: [A02], "
               "seed: 1, duration: 3h}\n");
  }
  [[nodiscard]] OperatorFile read(const std::string& yaml) const {
    write_file(folder / "sessions.yaml", yaml);
    return sessions::read_operator_file(folder / "sessions.yaml", folder / "store");
  }

  TemporaryFolder folder;
};

TEST_F(ServeSessionsFile, SaysWhatMayBeBegunByWhomAndHowOften) {
  const OperatorFile file = read(
      "sessions:\n  - {id: night-cp, scenario: scenarios/one.yaml}\n"
      "  - {id: fast, scenario: scenarios/one.yaml, real_time_factor: 0, begins: at_start}\n"
      "  - {id: scour, mission: mission.yaml, real_time_factor: 2.5}\n"
      "most_at_once: 2\nlogs: logs\n" +
      people_yaml());
  ASSERT_EQ(file.offers.size(), 3U);
  EXPECT_EQ(file.offers[0].id, "night-cp");
  EXPECT_EQ(file.offers[0].name, "one rov");
  EXPECT_EQ(file.offers[0].real_time_factor, 1);
  EXPECT_FALSE(file.offers[0].begins_at_start);
  EXPECT_EQ(file.offers[1].real_time_factor, 0);
  EXPECT_TRUE(file.offers[1].begins_at_start);
  EXPECT_TRUE(file.offers[2].is_mission);
  EXPECT_EQ(file.offers[2].name, "Scour at A02");
  EXPECT_EQ(file.most_at_once, 2U);
  EXPECT_EQ(file.logs, std::filesystem::absolute(folder / "logs"));
  EXPECT_EQ(file.people.grants().size(), 5U);
}

TEST_F(ServeSessionsFile, LeavesNoLogsAndBeginsFourAtMostWhereItSaysNothing) {
  const OperatorFile file =
      read("sessions: [{id: a, scenario: scenarios/one.yaml}]\n" + people_yaml());
  EXPECT_EQ(file.most_at_once, 4U);
  EXPECT_TRUE(file.logs.empty());
}

TEST_F(ServeSessionsFile, IsRefusedWithItsPlaceAndWhatToDo) {
  const std::string one = "sessions:\n  - {id: a, scenario: scenarios/one.yaml}\n";
  const auto with = [](const std::string& entry) { return "sessions:\n  - {" + entry + "}\n"; };
  struct Case {
    std::string yaml;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases{
      {"most_at_once: 2\n" + people_yaml(), {"sessions: found none, expected a list"}},
      {one + "people: []\n", {"people: found nobody"}},
      {one + "most_at_one: 2\n" + people_yaml(), {":3:", "most_at_one", "most_at_once"}},
      {one + "most_at_once: 17\n" + people_yaml(), {":3:", "most_at_once", "17", "16"}},
      {one + "most_at_once: 0\n" + people_yaml(), {"most_at_once", "0"}},
      {one + "logs: nowhere\n" + people_yaml(), {":3: logs: found no folder", "make it first"}},
      {with("id: a b, scenario: scenarios/one.yaml") + people_yaml(), {":2:", "id: found 'a b'"}},
      {with("id: -a, scenario: scenarios/one.yaml") + people_yaml(), {"id: found '-a'"}},
      {with("id: " + std::string(41, 'a') + ", scenario: scenarios/one.yaml") + people_yaml(),
       {"1 to 40 letters"}},
      {with("id: ../a, scenario: scenarios/one.yaml") + people_yaml(), {"id: found '../a'"}},
      {with("id: a") + people_yaml(), {":2:", "found neither of scenario and mission"}},
      {with("id: a, scenario: scenarios/one.yaml, mission: mission.yaml") + people_yaml(),
       {"found both of scenario and mission"}},
      {with("id: a, scenario: scenarios/none.yaml") + people_yaml(),
       {":2: sessions[0].scenario: ", "scenarios/none.yaml"}},
      {with("id: a, scenario: scenarios/broken.yaml") + people_yaml(),
       {":2: sessions[0].scenario: ", "broken.yaml:2: seed"}},
      {with("id: a, mission: scenarios/one.yaml") + people_yaml(), {":2: sessions[0].mission: "}},
      {with("id: a, scenario: scenarios/one.yaml, begins: later") + people_yaml(),
       {":2: sessions[0].begins: found 'later', expected by_supervisor or at_start"}},
      {with("id: a, scenario: scenarios/one.yaml, real_time_factor: 0.05") + people_yaml(),
       {"real_time_factor: found 0.05, expected 0"}},
      {with("id: a, scenario: scenarios/one.yaml, real_time_factor: -1") + people_yaml(),
       {"real_time_factor", "-1"}},
      {with("id: a, scenario: scenarios/one.yaml, real_time: 2") + people_yaml(),
       {"real_time", "real_time_factor"}},
      {one + "  - {id: a, scenario: scenarios/one.yaml}\n" + people_yaml(),
       {":3: sessions[1].id: 'a' stands twice"}},
      {with("id: a, scenario: scenarios/one.yaml, begins: at_start") +
           "  - {id: b, scenario: scenarios/one.yaml, begins: at_start}\nmost_at_once: 1\n" +
           people_yaml(),
       {"sessions: found 2 that begin at_start, expected 1 at most"}},
      {one + "people: [{role: operator, token: 0123456789abcdef, until: 2100-01-01T00:00:00Z}]\n",
       {"people: found no supervisor"}},
  };
  for (const Case& one_case : cases) {
    const std::string said = error_of([&] { return read(one_case.yaml); });
    for (const std::string& word : one_case.words) EXPECT_TRUE(contains(said, word));
    EXPECT_TRUE(contains(said, "sessions.yaml:")) << one_case.yaml;
    for (const auto& [name, token] : tokens_for_tests())
      EXPECT_EQ(said.find(token), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace slackwater::tests::operator_file_test
