#include "api/show/rehearse/account_text.h"

#include <gtest/gtest.h>

#include "api/show/rehearse/inspection_report.h"

namespace slackwater::tests::account_text_test {
namespace {

using namespace api;
using twin::Cause;
using Kind = twin::ConductEventKind;

/// One that finishes, one that is called home, one at work when the run ends, one without mission.
twin::RunAccount account_of_four() {
  twin::RunAccount account;
  account.start = parse_utc("2025-03-10T06:00:00Z");
  account.ran_s = 500;
  const auto add = [&](const char* name, std::vector<twin::MissionEvent> events) {
    twin::VehicleAccount& vehicle = account.vehicles.emplace_back();
    vehicle.name = name;
    vehicle.mission = std::move(events);
  };
  add("eye", {{0, Kind::phase_began, Cause::none, "work"},
              {400, Kind::finished, Cause::none, "finished"}});
  add("cam", {{0, Kind::phase_began, Cause::none, "work"},
              {50, Kind::turned_for_home, Cause::reserve, "comes home: energy for the way home"},
              {90, Kind::finished, Cause::reserve, "finished"}});
  add("dog", {{0, Kind::phase_began, Cause::none, "work"}});
  add("plain", {});
  return account;
}

TEST(AccountText, TheHeadlineNamesWhoIsNotDoneAndWhyFirst) {
  twin::RunAccount account = account_of_four();
  EXPECT_EQ(mission_headline(account),
            "Not done: cam: comes home: energy for the way home (ended 06:01 UTC); dog: was still "
            "at work (ended 06:08 UTC). Done: eye by 06:06 UTC.");
  EXPECT_FALSE(all_missions_done(account));
  account.vehicles.resize(1);
  EXPECT_EQ(mission_headline(account), "Done: eye by 06:06 UTC.");
  EXPECT_TRUE(all_missions_done(account));
  account.vehicles.clear();
  EXPECT_EQ(mission_headline(account), "");
}

TEST(AccountText, TheHeadlineSaysDoneAndSeenApart) {
  twin::RunAccount account = account_of_four();
  account.vehicles.resize(1);
  twin::InspectionOutcome& seen = account.vehicles[0].inspection.emplace();
  twin::InspectionOutcome::Part& part = seen.parts.emplace_back();
  part.area_m2 = 10;
  EXPECT_EQ(mission_headline(account), "Done: eye by 06:06 UTC.") << "nothing is asked";
  EXPECT_EQ(covered_text(seen), "0 of 10 m2 covered (0 %)");
  part.asked = 0.9;
  seen.left = "less than 90 % covered by the Eye";
  EXPECT_EQ(mission_headline(account),
            "Done: eye by 06:06 UTC. Not seen: eye: less than 90 % covered by the Eye.");
  EXPECT_EQ(covered_text(seen),
            "0 of 10 m2 covered (0 %), NOT SEEN as asked: less than 90 % covered by the Eye");
  EXPECT_TRUE(all_missions_done(account));
  EXPECT_FALSE(all_seen(account));
  part.covered_m2 = 9.5;
  seen.left = "";
  EXPECT_EQ(mission_headline(account), "Done: eye by 06:06 UTC. Seen as asked: eye.");
  EXPECT_TRUE(all_seen(account));
}

TEST(AccountText, WhomSomethingBefellIsNamedWithItAndNotTwice) {
  twin::RunAccount account = account_of_four();
  account.vehicles[2].fate = {{twin::Fate::battery_empty, 100.0},
                              {twin::Fate::fell, std::nullopt},
                              {twin::Fate::struck_sea, 104.5}};
  EXPECT_EQ(fates_text(account),
            "dog: battery empty at 06:01:40Z \u2192 fell \u2192 struck the sea at 06:01:44Z");
  EXPECT_EQ(mission_headline(account).find("dog"), std::string::npos);
  EXPECT_FALSE(all_missions_done(account));
}

TEST(AccountText, WhoIsNotRecoveredIsToldOfWithTheReason) {
  twin::RunAccount account = account_of_four();
  account.vehicles[2].fate = {{twin::Fate::not_recovered, 500.0}};
  EXPECT_EQ(fates_text(account), "dog: not recovered at 06:08:20Z");
  EXPECT_NE(mission_headline(account).find("dog: was still at work"), std::string::npos);
}

TEST(AccountText, AlarmsAreCountedByTheirCause) {
  twin::ClearanceAccount clearance;
  EXPECT_EQ(alarms_text(clearance), "none");
  clearance.alarms_from = {0, 1, 0, 0, 2, 0};
  EXPECT_EQ(alarms_text(clearance), "3 (structure 1, vessel without warning 2)");
}

}  // namespace
}  // namespace slackwater::tests::account_text_test
