#include <gtest/gtest.h>

#include "tests/twin/clearance/encounter.h"

// Ten thousand encounters (210 under sanitizers, where each takes ten times as long): the same with
// the rule and without it.

namespace slackwater::tests::encounters_test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int encounters_each = 30;
#else
constexpr int encounters_each = 1430;
#endif

struct Tally {
  int all = 0;
  int nearer = 0;          ///< than the bound, with no alarm
  int nearer_alarmed = 0;  ///< than the bound, and it was said that it is not promised
  int late = 0;            ///< not all at their goals by 60 s and eight times the straight way
  int nearer_without = 0;  ///< where nobody keeps clear
};

Tally tally_of(Meeting kind) {
  Tally tally;
  for (int i = 0; i < encounters_each; ++i) {
    const int number = meetings * i + static_cast<int>(kind);
    const Encounter e = random_encounter(1, number);
    const double most_s = 60 + 8 * e.straight_s;
    const Outcome with = outcome_of(e, true, most_s), without = outcome_of(e, false, most_s);
    ++tally.all;
    const bool is_nearer = with.least_slack_m < 0;
    tally.nearer += is_nearer && with.alarms == 0 ? 1 : 0;
    tally.nearer_alarmed += is_nearer && with.alarms > 0 ? 1 : 0;
    tally.late += with.all_arrived ? 0 : 1;
    tally.nearer_without += without.least_slack_m < 0 ? 1 : 0;
    EXPECT_FALSE(is_nearer && with.alarms == 0)
        << "encounter " << number << ": " << with.least_slack_m << " m";
  }
  return tally;
}

class Encounters : public testing::TestWithParam<Meeting> {};

TEST_P(Encounters, KeepTheStandOffAndReachTheirGoalsAndWouldNotWithoutTheRule) {
  const Tally tally = tally_of(GetParam());
  EXPECT_EQ(tally.nearer, 0);
  // Vessels of traffic meet a third of those that cross before them; all others nearly always.
  EXPECT_GT(tally.nearer_without, (GetParam() == Meeting::traffic ? 0.3 : 0.6) * tally.all);
  // Few are nearer though nobody promised otherwise: who is to leave a vessel's way is barred from
  // it by a structure, a line or another vehicle. In the gap between a line and a structure a few
  // go to and fro for ever, as any rule without a plan may.
  const bool is_easy = GetParam() != Meeting::all_of_it && GetParam() != Meeting::traffic;
  EXPECT_LE(tally.nearer_alarmed, is_easy ? 0 : 1 + 0.005 * tally.all);
  EXPECT_LE(tally.late, is_easy ? 1 + 0.002 * tally.all : 1 + 0.01 * tally.all);
  RecordProperty("nearer_alarmed", tally.nearer_alarmed);
  RecordProperty("late", tally.late);
  RecordProperty("nearer_without", tally.nearer_without);
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, Encounters,
                         testing::Values(Meeting::head_on, Meeting::crossing, Meeting::overtaking,
                                         Meeting::structures, Meeting::line, Meeting::traffic,
                                         Meeting::all_of_it));

}  // namespace
}  // namespace slackwater::tests::encounters_test
