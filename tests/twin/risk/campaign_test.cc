#include "twin/risk/workability/campaign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"
#include "tests/twin/risk/window_oracle.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::twin::campaign_test {
namespace {

using Marks = std::vector<std::uint8_t>;

Marks random_weather(Rng& random, std::size_t steps) {
  Marks marks(steps);
  const double run = random.uniform(2, 20);
  std::uint8_t mark = 1;
  for (std::uint8_t& one : marks) {
    if (random.uniform() < 1 / run) mark = mark == 0 ? 1 : 0;
    one = mark;
  }
  return marks;
}

/// Split work an hour at a time: in each run that is long enough, counted from where one stands, go
/// out, work, and go on in the next run.
std::optional<std::size_t> end_of_split_work(const Marks& usable, std::size_t from,
                                             std::size_t work, TaskHistory::Visits visits) {
  std::size_t done = 0;
  for (std::size_t t = from; t < usable.size();) {
    std::size_t end = t;
    while (end < usable.size() && usable[end] != 0) ++end;
    if (end - t >= visits.shortest) {
      for (std::size_t i = t + visits.lost; i < end; ++i)
        if (++done == work) return i + 1;
    }
    t = std::max(end, t + 1);
  }
  return std::nullopt;
}

TEST(TaskHistory, WholeWorkIsWhatASimulationStepByStepGives) {
  Rng random(11, "campaign");
  for (int trial = 0; trial < 100; ++trial) {
    const Marks usable = random_weather(random, 300);
    const auto work = static_cast<std::size_t>(random.uniform(1, 12));
    const std::size_t needed = work + static_cast<std::size_t>(random.uniform(0, 4));
    const TaskHistory task = TaskHistory::whole(workable_starts(runs_of(usable), needed), work);
    const Marks starts = oracle::starts(usable, needed, Marks(usable.size(), 1));
    for (std::size_t t = 0; t < usable.size(); ++t) {
      const auto wait = oracle::wait(starts, t);
      const auto done = task.done_from(t);
      ASSERT_EQ(done.has_value(), wait.has_value());
      if (!done) continue;
      EXPECT_EQ(*done, (StepRange{t + *wait, t + *wait + work}));
    }
    EXPECT_FALSE(task.done_from(usable.size()));
  }
}

TEST(TaskHistory, SplitWorkIsWhatASimulationStepByStepGives) {
  Rng random(12, "campaign");
  int ends = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Marks usable = random_weather(random, 300);
    const auto work = static_cast<std::size_t>(random.uniform(1, 60));
    TaskHistory::Visits visits;
    visits.lost = static_cast<std::size_t>(random.uniform(0, 3));
    visits.shortest = visits.lost + 1 + static_cast<std::size_t>(random.uniform(0, 4));
    const TaskHistory task = TaskHistory::split(runs_of(usable), work, visits);
    for (std::size_t t = 0; t < usable.size(); ++t) {
      const auto expected = end_of_split_work(usable, t, work, visits);
      const auto done = task.done_from(t);
      ASSERT_EQ(done.has_value(), expected.has_value()) << trial << " " << t;
      if (!done) continue;
      ++ends;
      EXPECT_EQ(done->end, *expected);
      EXPECT_GE(done->begin, t);
      EXPECT_EQ(usable[done->begin], 1);
    }
  }
  EXPECT_GT(ends, 1000);
}

TEST(TaskHistory, SplittingNeverTakesLonger) {
  Rng random(13, "campaign");
  for (int trial = 0; trial < 100; ++trial) {
    const StepRanges windows = runs_of(random_weather(random, 300));
    const auto work = static_cast<std::size_t>(random.uniform(1, 12));
    const TaskHistory whole = TaskHistory::whole(workable_starts(windows, work), work);
    const TaskHistory split = TaskHistory::split(windows, work, {});
    for (std::size_t t = 0; t < 300; ++t) {
      const auto at_once = whole.done_from(t);
      if (!at_once) continue;
      EXPECT_LE(split.done_from(t)->end, at_once->end);
    }
  }
}

/// Two tasks by hand. Calm from 2 to 7 and 9 to 20: the first, 3 h, from 2 to 5; the second, 4 h,
/// does not fit before 7 and runs from 9 to 13, its repetition from 13 to 17.
TEST(Campaign, TasksFollowEachOther) {
  const StepRanges calm{{2, 7}, {9, 20}};
  std::vector<CampaignTask> tasks{{TaskHistory::whole(workable_starts(calm, 3), 3), 1},
                                  {TaskHistory::whole(workable_starts(calm, 4), 4), 2}};
  EXPECT_EQ(end_of(tasks, 0), 17U);
  EXPECT_EQ(end_of(tasks, 12), std::nullopt);
  // One after the other and never out of order, from a later beginning never earlier.
  std::optional<std::size_t> before;
  for (std::size_t begin = 0; begin < 12; ++begin) {
    const auto end = end_of(tasks, begin);
    if (before && end) {
      EXPECT_GE(*end, *before);
    }
    before = end;
  }
}

/// Hour by hour: whoever is free takes the next task and waits for its first workable start.
std::optional<std::size_t> end_hour_by_hour(const std::vector<CampaignTask>& tasks,
                                            const std::vector<Marks>& starts,
                                            const std::vector<std::size_t>& work, std::size_t begin,
                                            std::size_t teams) {
  struct Team {
    std::optional<std::size_t> waits_for;  ///< a task
    std::size_t busy_until = 0;
  };
  std::vector<Team> all(teams);
  std::vector<std::size_t> queue;
  for (std::size_t i = 0; i < tasks.size(); ++i) queue.insert(queue.end(), tasks[i].times, i);
  std::size_t next = 0;
  std::size_t last = begin;
  for (std::size_t hour = begin; hour <= starts.front().size(); ++hour) {
    for (Team& team : all) {
      if (team.busy_until > hour) continue;
      if (!team.waits_for && next < queue.size()) team.waits_for = queue[next++];
    }
    for (Team& team : all) {
      if (team.busy_until > hour || !team.waits_for) continue;
      if (hour == starts.front().size() || starts[*team.waits_for][hour] == 0) continue;
      team.busy_until = hour + work[*team.waits_for];
      last = std::max(last, team.busy_until);
      team.waits_for.reset();
    }
  }
  const bool is_done = next == queue.size() && std::none_of(all.begin(), all.end(), [](auto& team) {
                         return team.waits_for.has_value();
                       });
  return is_done ? std::optional(last) : std::nullopt;
}

TEST(Campaign, SeveralTeamsEndWhenASimulationHourByHourDoes) {
  Rng random(14, "campaign");
  int ends = 0;
  int sooner = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Marks usable = random_weather(random, 400);
    std::vector<CampaignTask> tasks;
    std::vector<Marks> starts;
    std::vector<std::size_t> work;
    for (std::size_t i = 0; i < 3; ++i) {
      work.push_back(static_cast<std::size_t>(random.uniform(1, 9)));
      starts.push_back(oracle::starts(usable, work.back(), Marks(usable.size(), 1)));
      tasks.push_back(
          {TaskHistory::whole(workable_starts(runs_of(usable), work.back()), work.back()),
           static_cast<std::size_t>(random.uniform(1, 5))});
    }
    const auto begin = static_cast<std::size_t>(random.uniform(0, 200));
    std::optional<std::size_t> of_fewer;
    for (std::size_t teams = 1; teams <= 4; ++teams) {
      const auto end = end_of(tasks, begin, teams);
      ASSERT_EQ(end, end_hour_by_hour(tasks, starts, work, begin, teams)) << trial << " " << teams;
      // More teams never end later.
      if (of_fewer) {
        ASSERT_TRUE(end.has_value());
        EXPECT_LE(*end, *of_fewer);
        sooner += *end < *of_fewer ? 1 : 0;
      }
      ends += end ? 1 : 0;
      of_fewer = end;
    }
  }
  EXPECT_GT(ends, 100);
  EXPECT_GT(sooner, 100);
}

/// Weather that is calm from the n-th day of each April on: the campaign of a year takes n days and
/// its own length, and the percentiles are those of these numbers.
TEST(Campaign, ASeasonCountsEveryYearOnce) {
  const StepClock clock{parse_utc("2001-01-01T00:00:00Z"), std::chrono::hours(1), 24 * 365 * 6};
  StepRanges calm;
  const std::vector<int> calm_after_days{4, 0, 10, 2, 6};
  for (std::size_t i = 0; i < calm_after_days.size(); ++i) {
    const UtcTime april = std::chrono::sys_days(std::chrono::year(2001 + static_cast<int>(i)) /
                                                std::chrono::April / 1);
    const auto begin = static_cast<std::size_t>((april - clock.first) / clock.step) +
                       static_cast<std::size_t>(24 * calm_after_days[i]);
    calm.push_back({begin, begin + 24 * 30});
  }
  const std::vector<CampaignTask> tasks{{TaskHistory::whole(workable_starts(calm, 24), 24), 3}};
  const CampaignSeason season = season_of(tasks, clock, std::chrono::April / 1, std::nullopt);
  ASSERT_EQ(season.years.size(), 6U);
  EXPECT_EQ(season.censored, 1U) << "2006 has no calm";
  EXPECT_DOUBLE_EQ(season.p50_h, 24 * (4 + 3));
  EXPECT_DOUBLE_EQ(season.p10_h, 24 * (0.4 * 2 + 3));
  EXPECT_DOUBLE_EQ(season.p90_h, 24 * (6 + 0.6 * 4 + 3));
  EXPECT_EQ(season.years[1].year, 2002);
  EXPECT_EQ(*season.years[1].end - season.years[1].begin, 72U);
}

}  // namespace
}  // namespace slackwater::twin::campaign_test
