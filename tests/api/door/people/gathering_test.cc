// What people of a session show each other: where they look, notes at places, alarms that somebody
// has seen to.
#include "api/door/people/gathering.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/contains.h"

namespace slackwater::tests::gathering_test {
namespace {

using nlohmann::json;
using people::Gathering;
using people::Role;
using people::Said;
using people::Seat;
using people::StationSays;

Seat seat_of(unsigned number, const std::string& name, Role role) {
  Seat seat;
  seat.number = number;
  seat.name = name;
  seat.role = role;
  return seat;
}
const Seat ann = seat_of(1, "Ann", Role::drives), bob = seat_of(2, "Bob", Role::drives),
           sue = seat_of(3, "Sue", Role::supervises), gus = seat_of(4, "Gus", Role::looks_on);

json note_at(double east_m, const std::string& text) {
  return {{"do", "note"},
          {"text", text},
          {"at", {{"east_m", east_m}, {"north_m", 2}, {"up_m", -12.5}}}};
}

/// Two vehicles, the second with an alarm about a tug.
people::RunNow run_with_alarm() {
  people::RunNow run;
  run.vehicles.resize(2);
  people::AlarmNow alarm;
  alarm.alarm.id = 211000001;
  alarm.name = "TUG";
  run.vehicles[1].alarms.push_back(alarm);
  return run;
}

struct Gathered : testing::Test {
  Gathering gathering;
  people::RunNow run = run_with_alarm();
  Said says(const Seat& seat, const json& message) {
    return gathering.handle(seat, StationSays(message.dump()), run);
  }
};

TEST_F(Gathered, NotesAreToldAndTakenAwayByTheirOwnersAndSupervisors) {
  const Said put = says(ann, note_at(1, "loose anode"));
  EXPECT_FALSE(put.refused);
  EXPECT_EQ(put.after, "loose anode at 1.0 m east, 2.0 m north, -12.5 m up");
  (void)says(bob, note_at(5, "rope"));
  EXPECT_EQ(gathering.notes_json(),
            json({{{"note", 1},
                   {"seat", 1},
                   {"who", "Ann"},
                   {"text", "loose anode"},
                   {"at", {{"east_m", 1.0}, {"north_m", 2.0}, {"up_m", -12.5}}}},
                  {{"note", 2},
                   {"seat", 2},
                   {"who", "Bob"},
                   {"text", "rope"},
                   {"at", {{"east_m", 5.0}, {"north_m", 2.0}, {"up_m", -12.5}}}}}));
  const Said others = says(bob, {{"do", "unnote"}, {"note", 1}});
  ASSERT_TRUE(others.refused);
  EXPECT_EQ(others.refused->text, "note 1 is of Ann, who takes it away, or a supervisor");
  EXPECT_FALSE(says(sue, {{"do", "unnote"}, {"note", 1}}).refused);
  EXPECT_FALSE(says(bob, {{"do", "unnote"}, {"note", 2}}).refused);
  EXPECT_TRUE(gathering.notes_json().empty());
  ASSERT_TRUE(says(bob, {{"do", "unnote"}, {"note", 2}}).refused) << "it is gone";
}

TEST_F(Gathered, ThereIsAnEndToNotes) {
  for (std::size_t i = 0; i < Gathering::most_notes; ++i)
    ASSERT_FALSE(says(ann, note_at(1, "again")).refused);
  const Said one_more = says(ann, note_at(1, "again"));
  ASSERT_TRUE(one_more.refused);
  EXPECT_TRUE(contains(one_more.refused->text, "take one away"));
}

TEST_F(Gathered, WhoOnlyLooksOnWritesNothing) {
  for (const json& message : {note_at(1, "mine"), json{{"do", "unnote"}, {"note", 1}},
                              json{{"do", "acknowledge"}, {"vehicle", 1}, {"mmsi", 211000001}}}) {
    const Said said = says(gus, message);
    ASSERT_TRUE(said.refused);
    EXPECT_TRUE(contains(said.refused->text, "role of operator"));
  }
}

TEST_F(Gathered, WhatCannotBeReadIsRefusedAndChangesNothing) {
  EXPECT_THROW((void)says(ann, {{"do", "note"}, {"text", "no place"}}), Error);
  EXPECT_THROW((void)says(ann, note_at(2e6, "too far")), Error);
  EXPECT_THROW((void)says(ann, note_at(1, std::string(201, 'x'))), Error);
  EXPECT_THROW(gathering.look(ann, StationSays(R"({"do": "look", "from": 7})")), Error);
  EXPECT_TRUE(gathering.notes_json().empty());
  EXPECT_TRUE(gathering.looks_json().empty());
}

TEST_F(Gathered, WhereSomebodyLooksIsToldUntilHeGoes) {
  gathering.look(gus, StationSays(R"({"do": "look", "from": {"east_m": 1.25, "north_m": 2,
    "up_m": 3}, "heading_deg": 90.4, "tilt_deg": -10, "point": {"east_m": 4, "north_m": 5,
    "up_m": -6}})"));
  gathering.look(ann, StationSays(R"({"do": "look", "from": {"east_m": 0, "north_m": 0, "up_m": 0},
    "heading_deg": 0, "tilt_deg": 0})"));
  const json looks = gathering.looks_json();
  ASSERT_EQ(looks.size(), 2U);
  EXPECT_TRUE(looks[0]["point"].is_null());
  EXPECT_EQ(looks[1], json({{"seat", 4},
                            {"from", {{"east_m", 1.25}, {"north_m", 2.0}, {"up_m", 3.0}}},
                            {"heading_deg", 90},
                            {"tilt_deg", -10},
                            {"point", {{"east_m", 4.0}, {"north_m", 5.0}, {"up_m", -6.0}}}}));
  gathering.gone(4);
  EXPECT_EQ(gathering.looks_json().size(), 1U);
  gathering.look(ann, StationSays(R"({"do": "look"})"));
  EXPECT_TRUE(gathering.looks_json().empty()) << "closed the scene";
}

TEST_F(Gathered, AnAlarmIsSeenToOnceUntilItIsOver) {
  const json acknowledge{{"do", "acknowledge"}, {"vehicle", 1}, {"mmsi", 211000001}};
  EXPECT_TRUE(says(ann, {{"do", "acknowledge"}, {"vehicle", 0}, {"mmsi", 211000001}}).refused);
  const Said said = says(ann, acknowledge);
  EXPECT_FALSE(said.refused);
  EXPECT_EQ(said.after, "TUG");
  gathering.mind(run);
  EXPECT_EQ(run.vehicles[1].alarms[0].acknowledged_by, "Ann");
  const Said again = says(bob, acknowledge);
  ASSERT_TRUE(again.refused);
  EXPECT_EQ(again.refused->text, "found it acknowledged by Ann; nothing is left to do");
  // The vessel goes, and comes back: somebody has to see to it anew.
  people::RunNow calm;
  calm.vehicles.resize(2);
  gathering.mind(calm);
  run = run_with_alarm();
  gathering.mind(run);
  EXPECT_EQ(run.vehicles[1].alarms[0].acknowledged_by, "");
}

// Over the wire: others see it, it is in the record, and who comes later has it in his welcome.
TEST(GatheringOfASession, IsSharedByItsStations) {
  SessionUnderWay run(R"(name: gathering
seed: 7
duration: 30min
step_s: 0.05
log_every_s: 0.5
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}],
                  wind: {speed_m_s: 4, from_deg: 200}}}
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10},
     tasks: [{do: hold}]}
)");
  StationClient one(run, run.token(Role::drives)), other(run, run.token(Role::looks_on));
  (void)one.hello("Ann");
  (void)other.hello("Gus");
  expect_taken(one.asks(note_at(3, "look here")));
  const json row = other.told("action", [](const json& is) { return is["what"] == "note"; });
  ASSERT_FALSE(row.is_null());
  EXPECT_TRUE(contains(row["after"].get<std::string>(), "look here at 3.0 m east"));
  const json notes = other.told("notes");
  ASSERT_FALSE(notes.is_null());
  EXPECT_EQ(notes["notes"][0]["text"], "look here");
  one.says({{"do", "look"},
            {"from", {{"east_m", 1}, {"north_m", 2}, {"up_m", 3}}},
            {"heading_deg", 45},
            {"tilt_deg", 0}});
  const json looks = other.told("looks");
  ASSERT_FALSE(looks.is_null());
  EXPECT_EQ(looks["looks"][0]["heading_deg"], 45);
  StationClient late(run, run.token(Role::looks_on));
  const json welcome = late.hello("Lea");
  EXPECT_EQ(welcome["notes"].size(), 1U);
  EXPECT_EQ(welcome["looks"].size(), 1U);
  expect_refused(other.asks(note_at(3, "mine")), "unauthorised", "role of operator");
  one.hang_up();
  EXPECT_FALSE(other.told("looks", [](const json& is) { return is["looks"].empty(); }).is_null());
}

}  // namespace
}  // namespace slackwater::tests::gathering_test
