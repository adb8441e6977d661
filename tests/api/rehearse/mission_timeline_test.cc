#include "api/rehearse/mission_timeline.h"

#include <gtest/gtest.h>

namespace slackwater::tests {
namespace {

using namespace api;

/// The first holds for a wave, goes on and finishes; the second is called home; the third is at
/// work when the log ends.
const std::vector<MissionEvent> events{
    {0, 0, "phase_began", "none", "launch"},
    {0, 60, "phase_began", "none", "work"},
    {0, 100, "hold_began", "limit", "holds: limit: waves at most 1 m, found 1.2"},
    {0, 160, "went_back", "limit", "goes back to where it left off"},
    {0, 170, "resumed", "limit", "resumes"},
    {0, 300, "phase_began", "none", "return"},
    {0, 400, "finished", "none", "finished"},
    {1, 0, "phase_began", "none", "work"},
    {1, 50, "turned_for_home", "reserve", "comes home: energy for the way home"},
    {1, 50, "phase_began", "none", "return"},
    {1, 90, "finished", "reserve", "finished"},
    {2, 0, "phase_began", "none", "work"},
};

ingest::TrajectoryFile log_of_three() {
  ingest::TrajectoryFile log;
  log.names = {"eye", "cam", "dog", "plain"};
  log.epoch = parse_utc("2025-03-10T06:00:00Z");
  log.t_s = {0, 250, 500};
  return log;
}

TEST(MissionTimeline, StretchesFollowEachOtherFromTheFirstEventToTheEnd) {
  const auto eye = stretches_of(events, 0, 500);
  ASSERT_EQ(eye.size(), 6U);
  double before_s = 0;
  for (const MissionStretch& s : eye) {
    EXPECT_EQ(s.from_s, before_s);
    EXPECT_GT(s.to_s, s.from_s);
    before_s = s.to_s;
  }
  EXPECT_EQ(before_s, 400);
  EXPECT_EQ(eye[0].phase, "launch");
  EXPECT_EQ(eye[2].phase, "work");
  EXPECT_EQ(eye[2].doing, "holds");
  EXPECT_EQ(eye[3].doing, "goes back");
  EXPECT_EQ(eye[4].doing, "") << "at its task again";
  EXPECT_EQ(eye[5].phase, "return");
  const auto cam = stretches_of(events, 1, 500);
  ASSERT_EQ(cam.size(), 2U);
  EXPECT_EQ(cam[1].doing, "comes home");
  EXPECT_EQ(cam[1].phase, "return");
  EXPECT_EQ(stretches_of(events, 2, 500).back().to_s, 500);
  EXPECT_TRUE(stretches_of(events, 3, 500).empty());
}

TEST(MissionTimeline, TheHeadlineNamesWhoIsNotDoneAndWhyFirst) {
  bool is_done = true;
  EXPECT_EQ(mission_headline(log_of_three(), events, is_done),
            "Not done: cam: comes home: energy for the way home (ended 06:01 UTC); dog: was still "
            "at work (ended 06:08 UTC). Done: eye by 06:06 UTC.");
  EXPECT_FALSE(is_done);
  EXPECT_EQ(mission_headline(log_of_three(), {events.begin(), events.begin() + 7}, is_done),
            "Done: eye by 06:06 UTC.");
  EXPECT_TRUE(is_done);
  EXPECT_EQ(mission_headline(log_of_three(), {}, is_done), "");
}

}  // namespace
}  // namespace slackwater::tests
