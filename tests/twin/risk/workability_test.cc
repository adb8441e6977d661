#include "twin/risk/workability/workability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/numbers/random.h"
#include "tests/twin/risk/window_oracle.h"
#include "twin/risk/bound.h"
#include "twin/risk/workability/workable_starts.h"

namespace slackwater::twin::workability_test {
namespace {

using Marks = std::vector<std::uint8_t>;

const UtcTime new_year = parse_utc("2002-01-01T00:00:00Z");
constexpr Duration hour = std::chrono::hours(1);

AccessHistory history_of(const Marks& accessible, const Marks& missing, const StepClock& clock) {
  AccessHistory history;
  history.steps = accessible.size();
  history.step_h = clock.step_h();
  history.windows = runs_of(accessible);
  history.missing = runs_of(missing);
  history.months = months_of(clock, std::nullopt);
  return history;
}

AccessHistory history_of(const Marks& accessible, const StepClock& clock) {
  return history_of(accessible, Marks(accessible.size(), 0), clock);
}

/// twin/docs/operations.md, section 3: dt 1 h, limit 1.5 m, D 3 h.
TEST(Workability, TheWorkedExample) {
  const std::vector<double> height_m{1.2, 1.2, 1.2, 1.8, 1.0, 1.0, 1.0, 1.0, 1.9};
  Marks accessible(height_m.size(), 1);
  keep_within({BoundSide::at_most, 1.5}, height_m, accessible);
  const AccessHistory history = history_of(accessible, {new_year, hour, height_m.size()});
  EXPECT_EQ(history.windows, (StepRanges{{0, 3}, {4, 8}}));
  const WindowNeed need{steps_needed(std::chrono::hours(3), hour)};
  EXPECT_EQ(starts_for(history, need), (StepRanges{{0, 1}, {4, 6}}));
  const WindowStatistics found = workability_of(history, need).overall;
  EXPECT_DOUBLE_EQ(found.accessibility(), 7.0 / 9);
  EXPECT_DOUBLE_EQ(found.workability(), 3.0 / 9);
  EXPECT_DOUBLE_EQ(found.persistence(), 3.0 / 7);
  EXPECT_EQ(found.windows, 2U);
  EXPECT_EQ(found.workable_windows, 2U);
  EXPECT_DOUBLE_EQ(found.mean_window_h(), 3.5);
  EXPECT_EQ(found.longest_window_steps, 4U);
  EXPECT_EQ(found.storms, 2U);
  EXPECT_DOUBLE_EQ(found.mean_storm_h(), 1);
  // From steps 0 to 8 one waits 0 3 2 1 0 0, and 6 to 8 have no start after them.
  EXPECT_EQ(found.waiting.censored, 3U);
  EXPECT_DOUBLE_EQ(found.waiting.mean_h, 1);
  EXPECT_DOUBLE_EQ(found.waiting.p50_h, 0.5);
  EXPECT_DOUBLE_EQ(found.waiting.p90_h, 2.5);
}

TEST(Workability, AWindowOfNStepsHasAsManyStartsAsTheFormulaSays) {
  for (std::size_t n = 1; n < 30; ++n) {
    for (int minutes = 10; minutes <= 1000; minutes += 10) {
      const std::size_t needed = steps_needed(std::chrono::minutes(minutes), hour);
      const auto by_formula =
          static_cast<long>(std::floor((60.0 * static_cast<double>(n) - minutes) / 60.0) + 1);
      EXPECT_EQ(static_cast<long>(steps_in(workable_starts({{7, 7 + n}}, needed))),
                std::max(by_formula, 0L));
    }
  }
}

TEST(Workability, NoBoundHoldsForWhatIsMissing) {
  const std::vector<double> values{1, std::numeric_limits<double>::quiet_NaN(), 3};
  for (const BoundSide side :
       {BoundSide::at_most, BoundSide::below, BoundSide::at_least, BoundSide::above}) {
    Marks marks(3, 1);
    keep_within({side, 2}, values, marks);
    EXPECT_EQ(marks[1], 0);
    EXPECT_EQ(marks[0] + marks[2], 1);
    EXPECT_FALSE((Bound{side, 2}.holds(values[1])));
  }
  Marks equal(1, 1);
  keep_within({BoundSide::at_most, 3}, std::vector<double>{3}, equal);
  EXPECT_EQ(equal[0], 1) << "what equals a limit is within it";
  keep_within({BoundSide::below, 3}, std::vector<double>{3}, equal);
  EXPECT_EQ(equal[0], 0);
}

/// A season of weather that comes and goes, with gaps.
struct MadeUp {
  StepClock clock;
  Marks accessible;
  Marks missing;
  Marks may_start;
};

MadeUp made_up(Rng& random) {
  MadeUp made;
  const int step_min =
      std::vector<int>{10, 30, 60, 180}[static_cast<std::size_t>(random.uniform(0, 4))];
  const auto steps = static_cast<std::size_t>(random.uniform(1, 3000));
  made.clock = {new_year + std::chrono::minutes(static_cast<int>(random.uniform(0, 500000))),
                std::chrono::minutes(step_min), steps};
  made.accessible.resize(steps);
  made.missing.assign(steps, 0);
  const double run = random.uniform(1, 60);
  std::uint8_t mark = 1;
  for (std::size_t i = 0; i < steps; ++i) {
    if (random.uniform() < 1 / run) mark = mark == 0 ? 1 : 0;
    made.accessible[i] = mark;
    if (random.uniform() < 0.01) {
      made.missing[i] = 1;
      made.accessible[i] = 0;
    }
  }
  made.may_start.assign(steps, 1);
  return made;
}

/// All of the statistics of the steps that a month holds (or all), a step at a time.
void expect_as_counted(const MadeUp& made, std::size_t needed, const Marks& here,
                       const WindowStatistics& found) {
  const std::size_t steps = made.accessible.size();
  const Marks starts = oracle::starts(made.accessible, needed, made.may_start);
  const Marks lasting = oracle::starts(made.accessible, needed, Marks(steps, 1));
  const double step_h = made.clock.step_h();
  std::size_t count = 0, missing = 0, accessible = 0, workable = 0, lasts = 0;
  std::size_t windows = 0, workable_windows = 0, window_steps = 0, longest = 0;
  std::size_t storms = 0, storm_steps = 0, censored = 0;
  std::vector<std::size_t> waits;
  for (std::size_t t = 0; t < steps; ++t) {
    if (here[t] == 0) continue;
    ++count;
    missing += made.missing[t];
    accessible += made.accessible[t];
    workable += starts[t];
    lasts += lasting[t];
    if (const auto wait = oracle::wait(starts, t))
      waits.push_back(*wait);
    else
      ++censored;
    if (t > 0 && made.accessible[t] == made.accessible[t - 1]) continue;  // begins before
    std::size_t end = t;
    bool has_start = false;
    while (end < steps && made.accessible[end] == made.accessible[t]) {
      has_start = has_start || starts[end] != 0;
      ++end;
    }
    if (made.accessible[t] != 0) {
      ++windows;
      workable_windows += has_start ? 1 : 0;
      window_steps += end - t;
      longest = std::max(longest, end - t);
    } else {
      ++storms;
      storm_steps += end - t;
    }
  }
  EXPECT_EQ(found.steps, count);
  EXPECT_EQ(found.missing_steps, missing);
  EXPECT_EQ(found.accessible_steps, accessible);
  EXPECT_EQ(found.workable_starts, workable);
  EXPECT_EQ(found.lasting_steps, lasts);
  EXPECT_EQ(found.windows, windows);
  EXPECT_EQ(found.workable_windows, workable_windows);
  EXPECT_EQ(found.window_steps, window_steps);
  EXPECT_EQ(found.longest_window_steps, longest);
  EXPECT_EQ(found.storms, storms);
  EXPECT_EQ(found.storm_steps, storm_steps);
  EXPECT_EQ(found.waiting.censored, censored);
  EXPECT_EQ(found.waiting.counted, waits.size());
  if (waits.empty()) {
    EXPECT_TRUE(std::isnan(found.waiting.mean_h) && std::isnan(found.waiting.p50_h));
    return;
  }
  double sum = 0;
  for (const std::size_t wait : waits) sum += static_cast<double>(wait);
  EXPECT_EQ(found.waiting.mean_h, sum / static_cast<double>(waits.size()) * step_h);
  EXPECT_EQ(found.waiting.p10_h, oracle::percentile(waits, 10) * step_h);
  EXPECT_EQ(found.waiting.p50_h, oracle::percentile(waits, 50) * step_h);
  EXPECT_EQ(found.waiting.p80_h, oracle::percentile(waits, 80) * step_h);
  EXPECT_EQ(found.waiting.p90_h, oracle::percentile(waits, 90) * step_h);
}

TEST(Workability, IsToTheLastDigitWhatCountingStepByStepGives) {
  Rng random(7, "workability");
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    MadeUp made = made_up(random);
    const std::size_t steps = made.accessible.size();
    const auto needed = static_cast<std::size_t>(random.uniform(1, 25));
    WindowNeed need{needed};
    if (trial % 2 == 1) {  // only at some hours
      need.may_start = steps_at(made.clock, parse_day_hours("6-18"), std::nullopt);
      made.may_start.assign(steps, 0);
      for (const StepRange& range : *need.may_start)
        std::fill(made.may_start.begin() + static_cast<std::ptrdiff_t>(range.begin),
                  made.may_start.begin() + static_cast<std::ptrdiff_t>(range.end), 1);
    }
    const AccessHistory history = history_of(made.accessible, made.missing, made.clock);
    const Workability found = workability_of(history, need);
    expect_as_counted(made, needed, Marks(steps, 1), found.overall);
    for (const MonthStatistics& month : found.by_month) {
      Marks here(steps, 0);
      for (std::size_t t = 0; t < steps; ++t) {
        const std::chrono::year_month_day date{day_of(made.clock.time_of(t))};
        here[t] = static_cast<int>(static_cast<unsigned>(date.month())) == month.month ? 1 : 0;
      }
      SCOPED_TRACE(month.month);
      expect_as_counted(made, needed, here, month.statistics);
    }
    for (const YearStatistics& year : found.by_year) {
      Marks here(steps, 0);
      for (std::size_t t = 0; t < steps; ++t) {
        const std::chrono::year_month_day date{day_of(made.clock.time_of(t))};
        here[t] = static_cast<int>(date.year()) == year.year ? 1 : 0;
      }
      SCOPED_TRACE(year.year);
      expect_as_counted(made, needed, here, year.statistics);
    }
  }
}

TEST(Workability, MonthsAndYearsAddUpToTheWhole) {
  Rng random(8, "workability");
  for (int trial = 0; trial < 20; ++trial) {
    const MadeUp made = made_up(random);
    const AccessHistory history = history_of(made.accessible, made.missing, made.clock);
    const Workability found = workability_of(history, {6});
    WindowStatistics months, years;
    const auto add = [](WindowStatistics& sum, const WindowStatistics& one) {
      sum.steps += one.steps;
      sum.workable_starts += one.workable_starts;
      sum.windows += one.windows;
      sum.window_steps += one.window_steps;
      sum.waiting.counted += one.waiting.counted;
    };
    for (const MonthStatistics& one : found.by_month) add(months, one.statistics);
    for (const YearStatistics& one : found.by_year) add(years, one.statistics);
    for (const WindowStatistics& sum : {months, years}) {
      EXPECT_EQ(sum.steps, found.overall.steps);
      EXPECT_EQ(sum.workable_starts, found.overall.workable_starts);
      EXPECT_EQ(sum.windows, found.overall.windows);
      EXPECT_EQ(sum.window_steps, found.overall.accessible_steps);
      EXPECT_EQ(sum.waiting.counted, found.overall.waiting.counted);
    }
  }
}

/// One window over the new year: it counts in December, its steps where they lie, the wait of
/// December's last hours runs into January.
TEST(Workability, AWindowOverTheYearsEndIsOneWindow) {
  const StepClock clock{parse_utc("2002-12-31T20:00:00Z"), hour, 10};
  const AccessHistory history = history_of({0, 0, 1, 1, 1, 1, 1, 0, 0, 0}, clock);
  const Workability found = workability_of(history, {4});
  EXPECT_EQ(found.overall.windows, 1U);
  ASSERT_EQ(found.by_month.size(), 2U);
  const WindowStatistics& january = found.by_month[0].statistics;
  const WindowStatistics& december = found.by_month[1].statistics;
  EXPECT_EQ(december.windows, 1U);
  EXPECT_EQ(december.longest_window_steps, 5U);
  EXPECT_EQ(december.accessible_steps, 2U);
  EXPECT_EQ(december.workable_starts, 2U);
  EXPECT_EQ(january.windows, 0U);
  EXPECT_EQ(january.accessible_steps, 3U);
  EXPECT_EQ(january.workable_starts, 0U);
  EXPECT_TRUE(std::isnan(january.mean_window_h()));
  EXPECT_EQ(january.waiting.censored, 6U);
  ASSERT_EQ(found.by_year.size(), 2U);
  EXPECT_EQ(found.by_year[0].year, 2002);
  EXPECT_EQ(found.by_year[0].statistics.waiting.counted, 4U);
}

TEST(Workability, FallsWithTheDurationAndNeverExceedsAccessibility) {
  Rng random(9, "workability");
  for (int trial = 0; trial < 20; ++trial) {
    const MadeUp made = made_up(random);
    const AccessHistory history = history_of(made.accessible, made.missing, made.clock);
    double before = 1;
    for (std::size_t needed = 1; needed < 40; ++needed) {
      const WindowStatistics found = workability_of(history, {needed}).overall;
      EXPECT_LE(found.workability(), found.accessibility());
      EXPECT_LE(found.workability(), before);
      before = found.workability();
    }
    EXPECT_EQ(workability_of(history, {1}).overall.workable_starts, steps_in(history.windows));
  }
}

TEST(Workability, NeverIsNoWaitAtAll) {
  const StepClock clock{new_year, hour, 50};
  const WindowStatistics found = workability_of(history_of(Marks(50, 0), clock), {3}).overall;
  EXPECT_EQ(found.waiting.censored, 50U);
  EXPECT_TRUE(std::isnan(found.waiting.mean_h));
  EXPECT_TRUE(std::isnan(found.mean_window_h()));
  EXPECT_EQ(found.workability(), 0);
  const WindowStatistics always = workability_of(history_of(Marks(50, 1), clock), {50}).overall;
  EXPECT_EQ(always.workable_starts, 1U);
  EXPECT_EQ(always.waiting.censored, 49U);
}

}  // namespace
}  // namespace slackwater::twin::workability_test
