#include "twin/account/mission_event.h"

#include <gtest/gtest.h>

#include "twin/state/conduct_state.h"

namespace slackwater::tests::mission_event_test {
namespace {

using twin::Cause;
using twin::MissionEvent;
using twin::MissionStretch;
using Kind = twin::ConductEventKind;

/// Holds for a wave, goes on and finishes.
const std::vector<MissionEvent> eye{
    {0, Kind::phase_began, Cause::none, "launch"},
    {60, Kind::phase_began, Cause::none, "work"},
    {100, Kind::hold_began, Cause::limit, "holds: limit: waves at most 1 m, found 1.2"},
    {160, Kind::went_back, Cause::limit, "goes back to where it left off"},
    {170, Kind::resumed, Cause::limit, "resumes"},
    {300, Kind::phase_began, Cause::none, "return"},
    {400, Kind::finished, Cause::none, "finished"}};
/// Is called home.
const std::vector<MissionEvent> cam{
    {0, Kind::phase_began, Cause::none, "work"},
    {50, Kind::turned_for_home, Cause::reserve, "comes home: energy for the way home"},
    {50, Kind::phase_began, Cause::none, "return"},
    {90, Kind::finished, Cause::reserve, "finished"}};
/// Is at work when the run ends.
const std::vector<MissionEvent> dog{{0, Kind::phase_began, Cause::none, "work"}};

TEST(MissionEvents, StretchesFollowEachOtherFromTheFirstEventToTheEnd) {
  const auto stretches = twin::stretches_of(eye, 500);
  ASSERT_EQ(stretches.size(), 6U);
  double before_s = 0;
  for (const MissionStretch& s : stretches) {
    EXPECT_EQ(s.from_s, before_s);
    EXPECT_GT(s.to_s, s.from_s);
    before_s = s.to_s;
  }
  EXPECT_EQ(before_s, 400);
  EXPECT_EQ(stretches[0].phase, "launch");
  EXPECT_EQ(stretches[2].phase, "work");
  EXPECT_EQ(stretches[2].doing, "holds");
  EXPECT_EQ(stretches[3].doing, "goes back");
  EXPECT_EQ(stretches[4].doing, "") << "at its task again";
  EXPECT_EQ(stretches[5].phase, "return");
  const auto home = twin::stretches_of(cam, 500);
  ASSERT_EQ(home.size(), 2U);
  EXPECT_EQ(home[1].doing, "comes home");
  EXPECT_EQ(home[1].phase, "return");
  EXPECT_EQ(twin::stretches_of(dog, 500).back().to_s, 500);
  EXPECT_TRUE(twin::stretches_of({}, 500).empty());
}

TEST(MissionEvents, TellWhoIsStillOut) {
  EXPECT_FALSE(twin::are_out(eye));
  EXPECT_FALSE(twin::are_out(cam));
  EXPECT_TRUE(twin::are_out(dog));
  EXPECT_FALSE(twin::are_out({}));
  std::vector<MissionEvent> deck = dog;
  deck.push_back({10, Kind::came_aboard, Cause::none, "aboard"});
  EXPECT_FALSE(twin::are_out(deck));
  deck.push_back({20, Kind::launched, Cause::none, "launched"});
  EXPECT_TRUE(twin::are_out(deck));
}

TEST(MissionEvents, TellHowAMissionEndedAndWhy) {
  const auto end = twin::mission_end_of(eye, 500);
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->is_done);
  EXPECT_EQ(end->t_s, 400);
  EXPECT_EQ(twin::mission_end_of(cam, 500)->why, "comes home: energy for the way home");
  EXPECT_EQ(twin::mission_end_of(dog, 500)->why, "was still at work");
  EXPECT_EQ(twin::mission_end_of(dog, 500)->t_s, 500);
  EXPECT_FALSE(twin::mission_end_of({}, 500));
}

TEST(MissionEvents, InterventionsAreTimesAwayFromTheTask) {
  const twin::Interventions held = twin::interventions_of(eye, 500);
  EXPECT_EQ(held.count, 1U);
  EXPECT_EQ(held.limit_violations, 1U);
  EXPECT_EQ(held.away_s, 70);
  const twin::Interventions home = twin::interventions_of(cam, 500);
  EXPECT_EQ(home.count, 1U);
  EXPECT_EQ(home.limit_violations, 0U);
  EXPECT_EQ(home.away_s, 40);
  EXPECT_EQ(twin::interventions_of({cam.begin(), 2}, 500).away_s, 450) << "until the run ends";
}

}  // namespace
}  // namespace slackwater::tests::mission_event_test
