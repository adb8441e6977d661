#include "twin/risk/workability/step_range.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::step_range_test {
namespace {

/// Marks that change on average every `run` steps.
std::vector<std::uint8_t> random_marks(Rng& random, std::size_t steps, double run) {
  std::vector<std::uint8_t> marks(steps);
  std::uint8_t mark = random.uniform() < 0.5 ? 1 : 0;
  for (std::uint8_t& one : marks) {
    if (random.uniform() < 1 / run) mark = mark == 0 ? 1 : 0;
    one = mark;
  }
  return marks;
}

std::vector<std::uint8_t> marks_of(const StepRanges& ranges, std::size_t steps) {
  std::vector<std::uint8_t> marks(steps, 0);
  for (const StepRange& range : ranges)
    for (std::size_t i = range.begin; i < range.end; ++i) ++marks[i];
  return marks;
}

TEST(StepRanges, RunsAreMaximalAndHoldTheMarkedStepsAndNoOther) {
  Rng random(5, "step_range");
  for (int trial = 0; trial < 300; ++trial) {
    const auto steps = static_cast<std::size_t>(random.uniform(0, 200));
    const auto marks = random_marks(random, steps, random.uniform(1, 30));
    const StepRanges runs = runs_of(marks);
    EXPECT_EQ(marks_of(runs, steps), marks);
    for (std::size_t i = 1; i < runs.size(); ++i)
      EXPECT_GT(runs[i].begin, runs[i - 1].end) << "two runs that touch are one";
    for (const StepRange& run : runs) EXPECT_GT(run.steps(), 0U);
  }
}

TEST(StepRanges, OutsideAndCommonAreThoseOfSets) {
  Rng random(6, "step_range");
  for (int trial = 0; trial < 300; ++trial) {
    const auto steps = static_cast<std::size_t>(random.uniform(1, 200));
    const auto a = random_marks(random, steps, random.uniform(1, 30));
    const auto b = random_marks(random, steps, random.uniform(1, 30));
    auto not_a = a;
    auto both = a;
    for (std::size_t i = 0; i < steps; ++i) {
      not_a[i] = a[i] == 0 ? 1 : 0;
      both[i] = a[i] != 0 && b[i] != 0 ? 1 : 0;
    }
    EXPECT_EQ(marks_of(outside(runs_of(a), steps), steps), not_a);
    EXPECT_EQ(marks_of(common_to(runs_of(a), runs_of(b)), steps), both);
    EXPECT_EQ(steps_in(runs_of(a)), static_cast<std::size_t>(std::count(a.begin(), a.end(), 1)));
  }
}

}  // namespace
}  // namespace slackwater::twin::step_range_test
