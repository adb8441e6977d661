// The scorecard of a session as it was: people at real sockets in a real run, read off its log.
#include <gtest/gtest.h>

#include "api/log/score.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/http_client.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::people_score_session_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;

const std::string rov_at_pile =
    calm_head(0.05) +
    "  - {name: rov, model: bluerov2_heavy, start: {north_m: 10, east_m: 0, depth_m: 10}, tasks: "
    "[{do: hold}], conduct: {autonomy: shared, envelope: {stand_off_m: 20}}}\n"
    "structures:\n  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, "
    "top_height_m: 20, bottom_depth_m: 60}\n";

const api::HelmScore& helm_of(const api::PeopleScore& score, const std::string& name) {
  for (const api::PersonScore& person : score.people)
    if (person.name == name) return person.helms.at(0);
  throw std::runtime_error("nobody of that name");
}

TEST(PeopleScoreOfASession, IsWhatPeopleDid) {
  SessionUnderWay run(rov_at_pile);
  StationClient ann(run, run.token(Role::drives)), bob(run, run.token(Role::drives));
  StationClient sue(run, run.token(Role::supervises)), gus(run, run.token(Role::looks_on));
  (void)ann.hello("Ann"), (void)bob.hello("Bob"), (void)sue.hello("Sue"), (void)gus.hello("Gus");
  const auto taken = [](const json& answer) { return answer.value("taken", false); };
  const json ask{{"do", "ask"}, {"vehicle", 0}};
  ASSERT_TRUE(taken(ann.asks(ask)));
  ann.listen(200ms);
  for (int i = 0; i < 5; ++i)
    ASSERT_TRUE(taken(ann.asks(ann.command("stick", 0, {{"velocity", {0, 0, 0.1, 0}}}))));
  for (int i = 0; i < 3; ++i)
    ASSERT_FALSE(taken(bob.asks(bob.command("stick", 0, {{"velocity", {0, 0, 0, 0}}}))));
  ASSERT_TRUE(taken(bob.asks(ask)));
  ann.listen(500ms);
  ASSERT_TRUE(taken(ann.asks({{"do", "grant"}, {"vehicle", 0}})));
  ASSERT_TRUE(taken(bob.asks(bob.command("home", 0))));
  bob.listen(1500ms);
  ASSERT_TRUE(taken(sue.asks(sue.command("hold", 0))));
  sue.listen(300ms);
  const TemporaryFolder folder;
  ingest::write_trajectories(run.ended().file, folder / "log.nc");
  const api::PeopleScore score =
      api::scorecard_of(ingest::read_trajectories(folder / "log.nc")).people;
  ASSERT_EQ(score.people.size(), 4U);
  EXPECT_EQ(score.people[3].role, "spectator");
  EXPECT_TRUE(score.people[3].helms.empty());
  const api::HelmScore &anns = helm_of(score, "Ann"), &bobs = helm_of(score, "Bob"),
                       &sues = helm_of(score, "Sue");
  EXPECT_EQ(anns.asked_to_had_s, std::vector<double>{0});
  ASSERT_EQ(anns.had_to_command_s.size(), 1U);
  EXPECT_GE(anns.had_to_command_s[0], 0.15);
  EXPECT_EQ(anns.commands, 5U);
  EXPECT_EQ(anns.off_mission, 1U);
  ASSERT_EQ(bobs.asked_to_had_s.size(), 1U);
  EXPECT_GE(bobs.asked_to_had_s[0], 0.45);
  EXPECT_LT(bobs.asked_to_had_s[0], 9);
  EXPECT_EQ(bobs.commands, 1U);
  EXPECT_EQ(bobs.refused_for, (std::map<std::string, std::uint64_t>{{"unauthorised", 3}}));
  EXPECT_GE(bobs.at_helm_s, 1.2);
  EXPECT_EQ(sues.taken_over, 1U);
  EXPECT_EQ(sues.off_helm, 1U);
  ASSERT_TRUE(sues.hold_in_force_s);
  ASSERT_EQ(sues.hold_in_force_s->size(), 1U);
  EXPECT_LE(sues.hold_in_force_s->front(), 0.1) << "two steps";
  EXPECT_LE(anns.at_helm_s + bobs.at_helm_s + sues.at_helm_s, score.ran_s + 1e-9);
  ASSERT_TRUE(bobs.at_limits);
  EXPECT_NEAR(*bobs.at_limits->nearest_structure_m, 7, 1);
  // The one is counted by the log's rows, of which the helm's first may be the next.
  EXPECT_NEAR(bobs.at_limits->inside_stand_off_s, bobs.at_helm_s, 0.1 + 1e-9);
  EXPECT_EQ(bobs.at_limits->stand_off_breaches, 0U) << "it never was outside";
}

// What somebody looks at is kept where that is asked for, and told to nobody else.
TEST(PeopleScoreOfASession, HasWhatSomebodyLookedAtWhoWantedItKept) {
  SessionUnderWay run(rov_at_pile);
  StationClient ann(run, run.token(Role::looks_on)), bob(run, run.token(Role::looks_on));
  (void)ann.hello("Ann"), (void)bob.hello("Bob");
  const auto attends = [&](const std::string& on, const std::string& by) {
    expect_taken(ann.asks({{"do", "attend"}, {"on", on}, {"by", by}}));
  };
  attends("rov", "pointer");
  ann.listen(600ms);
  attends("", "head");
  ann.listen(300ms);
  attends("structure 1", "head");
  ann.listen(300ms);
  attends("", "off");
  ann.listen(400ms);
  bob.listen(100ms);
  StationClient late(run, run.token(Role::looks_on));
  const json welcome = late.hello("Cid");
  for (const json& row : welcome.at("actions")) EXPECT_NE(row["what"], "attend");
  for (const StationClient* client : {&ann, &bob})
    for (const json& is : client->messages)
      EXPECT_TRUE(is["is"] != "action" || is["what"] != "attend") << is;
  attends("rov", "pointer");
  const HttpReply record = HttpClient(run.port())
                               .get("/sessions/run/actions",
                                    "Authorization: Bearer " + run.token(Role::looks_on) + "\r\n")
                               .value();
  ASSERT_EQ(record.status, 200);
  EXPECT_EQ(record.body.find("attend"), std::string::npos) << "nor who asks for the record";
  ann.hang_up();
  bob.listen(300ms);
  const TemporaryFolder folder;
  ingest::write_trajectories(run.ended().file, folder / "log.nc");
  const api::PeopleScore score =
      api::scorecard_of(ingest::read_trajectories(folder / "log.nc")).people;
  ASSERT_EQ(score.people.size(), 3U);
  EXPECT_FALSE(score.people[1].attention) << "Bob did not ask for it";
  ASSERT_TRUE(score.people[0].attention);
  const api::Attention& kept = *score.people[0].attention;
  EXPECT_NEAR(kept.on_s.at("rov"), 0.6, 0.25);
  EXPECT_NEAR(kept.on_s.at(""), 0.3, 0.15);
  EXPECT_NEAR(kept.on_s.at("structure 1"), 0.3, 0.15);
  EXPECT_NEAR(kept.kept_s, 1.2, 0.4) << "not while it was off, nor after the link was cut";
}

TEST(PeopleScoreOfASession, AttentionByNothingKnownIsRefused) {
  SessionUnderWay run(rov_at_pile);
  StationClient ann(run, run.token(Role::looks_on));
  (void)ann.hello("Ann");
  const json answer = ann.asks({{"do", "attend"}, {"on", "rov"}, {"by", "nose"}});
  expect_refused(answer, "unreadable", "expected head, pointer or off");
}

}  // namespace
}  // namespace slackwater::tests::people_score_session_test
