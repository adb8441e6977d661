// What is counted of recorded decisions, and how it is said.
#include <gtest/gtest.h>

#include "api/ask/decisions/decisions.h"
#include "api/show/decisions/decision_words.h"

namespace slackwater::tests::record_test {
namespace {

using namespace slackwater::api;
using std::chrono::days;
using std::chrono::hours;

const UtcTime dawn = parse_utc("2025-03-10T06:00:00Z");
const UtcTime later = parse_utc("2025-06-01T00:00:00Z");

DecisionAnswer one(const std::string& task, UtcTime start, store::Decided decided, Came came) {
  DecisionAnswer answer;
  answer.row.task = task;
  answer.row.start = start;
  answer.row.decided = decided;
  answer.row.recorded_at = start - hours(2);
  answer.what.came = came;
  return answer;
}
DecisionAnswer go(const std::string& task, UtcTime start, Came came) {
  return one(task, start, store::Decided::go, came);
}
DecisionAnswer no_go(const std::string& task, UtcTime start, Came came) {
  return one(task, start, store::Decided::no_go, came);
}
std::string text_of(const std::vector<DecisionAnswer>& decisions) {
  return record_text(record_of(decisions, later));
}

TEST(DecisionsRecord, SaysOfHowManyGoesHowManyHeldAndHowManyDaysWereLost) {
  std::vector<DecisionAnswer> decisions;
  for (int d = 0; d < 40; ++d)
    decisions.push_back(go("survey", dawn + days(d), d < 38 ? Came::held : Came::did_not_hold));
  for (int d = 40; d < 46; ++d) decisions.push_back(no_go("survey", dawn + days(d), Came::held));
  decisions.push_back(no_go("survey", dawn + days(46), Came::did_not_hold));
  EXPECT_EQ(text_of(decisions), "of 40 goes 38 held; 6 workable days were lost");
}

TEST(DecisionsRecord, ClaimsNothingOfWhatIsNotKnown) {
  const std::vector<DecisionAnswer> decisions{go("survey", dawn, Came::not_known_yet),
                                              go("survey", dawn + days(1), Came::cannot_be_known),
                                              go("survey", dawn + days(2), Came::held),
                                              no_go("survey", dawn + days(3), Came::not_known_yet)};
  const DecisionsRecord record = record_of(decisions, later);
  EXPECT_EQ(record.goes_known, 1U);
  EXPECT_EQ(record.goes_held, 1U);
  EXPECT_EQ(record.goes_open, 2U);
  EXPECT_EQ(record.days_lost, 0U);
  EXPECT_EQ(record.days_open, 1U);
  EXPECT_EQ(record_text(record),
            "of 1 go 1 held; what came of 2 goes and 1 day with a no-go is not known so far");
  EXPECT_EQ(text_of({go("survey", dawn, Came::not_known_yet)}),
            "what came of 1 go is not known so far");
}

TEST(DecisionsRecord, LosesNoDayOnWhichTheTaskWasAGo) {
  const auto lost = [](const std::vector<DecisionAnswer>& decisions) {
    return record_of(decisions, later).days_lost;
  };
  const DecisionAnswer morning = no_go("survey", dawn, Came::held);
  EXPECT_EQ(lost({morning}), 1U);
  EXPECT_EQ(lost({morning, no_go("survey", dawn + hours(4), Came::held)}), 1U) << "one day";
  EXPECT_EQ(lost({morning, no_go("survey", dawn + hours(4), Came::not_known_yet)}), 1U);
  EXPECT_EQ(lost({morning, go("survey", dawn + hours(4), Came::did_not_hold)}), 0U);
  EXPECT_EQ(lost({morning, go("survey", dawn + days(1), Came::held)}), 1U) << "another day";
  EXPECT_EQ(lost({morning, go("scan", dawn, Came::held)}), 1U) << "another task";
}

TEST(DecisionsRecord, OfSeveralTasksCountsTheDaysOfEach) {
  EXPECT_EQ(text_of({no_go("survey", dawn, Came::held), no_go("scan", dawn, Came::held)}),
            "2 workable days of a task were lost");
  EXPECT_EQ(text_of({no_go("survey", dawn, Came::held)}), "1 workable day was lost");
}

TEST(DecisionsRecord, CountsNeitherWhatWasReplacedNorWhatWasRecordedLater) {
  DecisionAnswer replaced = go("survey", dawn, Came::did_not_hold);
  replaced.counts = false;
  DecisionAnswer from_later = go("survey", dawn + days(1), Came::held);
  from_later.row.recorded_at = later + hours(1);
  EXPECT_EQ(text_of({replaced, from_later}), "");
  EXPECT_EQ(text_of({}), "");
  EXPECT_EQ(text_of({no_go("survey", dawn, Came::did_not_hold)}),
            "no go was decided, and no workable day was lost");
}

TEST(DecisionWords, SayWhatCameOfAGoAndWhatWouldHaveCome) {
  DecisionAnswer held = go("survey", dawn, Came::held);
  held.what.not_checked = {"eye: visibility", "eye: roll"};
  EXPECT_EQ(came_text(held), "held (2 limits not checked)");
  EXPECT_EQ(came_text(no_go("survey", dawn, Came::held)), "would have held");
  DecisionAnswer broken = no_go("survey", dawn, Came::did_not_hold);
  broken.what.broken = "eye: waves at most 1.5 m";
  broken.what.broken_at = dawn + hours(1);
  EXPECT_EQ(came_text(broken),
            "would not have held: eye: waves at most 1.5 m, not kept at 2025-03-10 07:00 UTC");
  EXPECT_EQ(came_text(go("survey", dawn, Came::not_known_yet)), "not known yet");
}

}  // namespace
}  // namespace slackwater::tests::record_test
