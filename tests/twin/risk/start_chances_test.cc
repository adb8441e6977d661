#include "twin/risk/start_chances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/numbers/random.h"
#include "twin/risk/start_windows.h"

namespace slackwater::tests::start_chances_test {
namespace {

using twin::Bound;
using twin::BoundSide;
using twin::StartChance;
using twin::StartQuestion;
using twin::WatchedLimit;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

WatchedLimit at_most(double bound, const std::vector<double>& values, twin::StepRanges when) {
  WatchedLimit watched;
  watched.bound = {BoundSide::at_most, bound};
  watched.when = std::move(when);
  watched.members = {values};
  return watched;
}

StartQuestion question_of(std::vector<WatchedLimit> watched, std::size_t starts,
                          std::size_t members = 1) {
  StartQuestion question;
  question.steps = watched.front().members.front().size();
  question.members = members;
  question.starts = {0, 1, starts};
  for (const WatchedLimit& one : watched)
    question.limits = std::max(question.limits, one.limit + 1);
  question.watched = std::move(watched);
  return question;
}

/// twin/docs/operations.md, section 3: 1 h steps, 1.5 m, 3 h.
TEST(StartChances, OfTheReferenceAreItsThreeWorkableStarts) {
  const std::vector<double> height_m{1.2, 1.2, 1.2, 1.8, 1.0, 1.0, 1.0, 1.0, 1.9};
  const auto chances = twin::start_chances(question_of({at_most(1.5, height_m, {{0, 3}})}, 7));
  std::vector<std::uint8_t> marks;
  for (const StartChance& chance : chances) marks.push_back(chance.by_threshold ? 1 : 0);
  EXPECT_EQ(marks, (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 1, 0}));
  const auto windows = twin::windows_of(chances, std::vector<double>(marks.size(), 1), marks);
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0].first, 0U);
  EXPECT_EQ(windows[0].last, 0U);
  EXPECT_EQ(windows[1].first, 4U);
  EXPECT_EQ(windows[1].last, 5U);
  // What stops a start is where it says: begun at 1 the sea of step 3 is too high.
  ASSERT_TRUE(chances[1].binding);
  EXPECT_TRUE(chances[1].binding->is_exceeded);
  EXPECT_EQ(chances[1].binding->step, 3U);
  EXPECT_DOUBLE_EQ(chances[1].binding->share, 1.8 / 1.5);
  EXPECT_FALSE(chances[0].binding->is_exceeded);
  EXPECT_DOUBLE_EQ(chances[0].binding->share, 1.2 / 1.5);
}

TEST(StartChances, TheFactorOfPracticeTakesAwayWhatIsNearTheLimit) {
  const std::vector<double> height_m{1.05, 1.05, 1.06, 1.05, 1.05};
  auto watched = at_most(1.5, height_m, {{0, 1}});
  watched.alpha.assign(5, 0.705);  // 1.0575 m
  const auto chances = twin::start_chances(question_of({watched}, 5));
  EXPECT_EQ(chances[1].by_alpha, true);
  EXPECT_EQ(chances[2].by_alpha, false);
  EXPECT_TRUE(chances[2].by_threshold);
  watched.alpha[3] = unknown;
  EXPECT_EQ(twin::start_chances(question_of({watched}, 5))[3].by_alpha, std::nullopt);
  watched.alpha.clear();
  EXPECT_EQ(twin::start_chances(question_of({watched}, 5))[1].by_alpha, std::nullopt);
}

TEST(StartChances, PracticeDoesNotForgiveALimitThatHasNoFactor) {
  const std::vector<double> height_m{0.5, 0.5}, wind_m_s{9, 11};
  auto waves = at_most(1.5, height_m, {{0, 1}});
  waves.alpha.assign(2, 0.7);
  auto wind = at_most(10, wind_m_s, {{0, 1}});
  wind.limit = 1;
  const auto chances = twin::start_chances(question_of({waves, wind}, 2));
  EXPECT_EQ(chances[0].by_alpha, true);
  EXPECT_EQ(chances[1].by_alpha, false);
}

TEST(StartChances, WhatNobodyKnowsIsNotWorkableUnlessItMayBeMissing) {
  const std::vector<double> values{1, unknown, 1};
  auto watched = at_most(2, values, {{0, 1}});
  EXPECT_FALSE(twin::start_chances(question_of({watched}, 3))[1].by_threshold);
  watched.may_be_missing = true;
  const auto chances = twin::start_chances(question_of({watched}, 3));
  EXPECT_TRUE(chances[1].by_threshold);
  EXPECT_EQ(chances[1].held, 1U);
}

TEST(StartChances, ALimitOfALaterPhaseBindsWhenThatPhaseRuns) {
  // It counts two steps after the start alone.
  const std::vector<double> values{9, 9, 1, 1, 9, 1};
  const auto chances = twin::start_chances(question_of({at_most(2, values, {{2, 3}})}, 4));
  EXPECT_TRUE(chances[0].by_threshold);
  EXPECT_TRUE(chances[1].by_threshold);
  EXPECT_FALSE(chances[2].by_threshold);
  EXPECT_EQ(chances[2].binding->step, 4U);
  EXPECT_TRUE(chances[3].by_threshold);
}

TEST(StartChances, WhatComesBeforeAStartIsCountedBackFromIt) {
  Rng random(3, "before a start");
  constexpr std::size_t steps = 60, before = 4, starts = 40, members = 5;
  for (int round = 0; round < 50; ++round) {
    std::vector<std::vector<double>> values(members, std::vector<double>(steps));
    for (auto& member : values)
      for (double& value : member) value = random.uniform();
    WatchedLimit watched = at_most(0.8, values.front(), {{0, 2}, {5, 6}});
    watched.before = before;
    watched.members.assign(values.begin(), values.end());
    StartQuestion question = question_of({watched}, starts, members);
    question.starts = {before, 1, starts};
    const auto chances = twin::start_chances(question);
    for (std::size_t s = 0; s < starts; ++s) {
      // Step `before + s` is that of the start; four before it are s, the next but four s + 1.
      std::size_t held = 0;
      for (const auto& member : values)
        held += member[s] <= 0.8 && member[s + 1] <= 0.8 && member[s + 5] <= 0.8 ? 1 : 0;
      EXPECT_EQ(chances[s].held, held);
      const double highest = std::max({values[0][s], values[0][s + 1], values[0][s + 5]});
      EXPECT_DOUBLE_EQ(chances[s].binding->share, highest / 0.8);
    }
  }
}

TEST(StartChances, AGateShutsAndIsNeverTheNearest) {
  const std::vector<double> open{1, 1, 0, 1}, values{1, 1, 1, 1};
  WatchedLimit gate;
  gate.limit = 1;
  gate.bound = {BoundSide::at_least, 1};
  gate.is_gate = true;
  gate.when = {{0, 1}};
  gate.members = {open};
  const auto chances = twin::start_chances(question_of({at_most(4, values, {{0, 1}}), gate}, 4));
  EXPECT_TRUE(chances[1].by_threshold);
  EXPECT_EQ(chances[1].binding->limit, 0U);
  EXPECT_FALSE(chances[2].by_threshold);
  EXPECT_EQ(chances[2].binding->limit, 1U);
  EXPECT_TRUE(std::isnan(chances[2].binding->share));
}

TEST(StartChances, MostMembersDecideWhatBinds) {
  // Two futures are stopped by the second limit, one, earlier, by the first.
  const std::vector<double> a0{1, 1, 1}, a1{9, 1, 1}, b0{1, 1, 9}, b1{1, 9, 9};
  WatchedLimit a = at_most(2, a0, {{0, 3}}), b = at_most(2, b0, {{0, 3}});
  a.members = {a0, a1, a0};
  b.limit = 1;
  b.members = {b0, b1, b1};
  const auto chances = twin::start_chances(question_of({a, b}, 1, 3));
  EXPECT_EQ(chances[0].held, 0U);
  ASSERT_TRUE(chances[0].binding);
  EXPECT_EQ(chances[0].binding->limit, 1U);
  EXPECT_EQ(chances[0].binding->members, 2U);
  EXPECT_EQ(chances[0].binding->step, 1U) << "the lower median of 1 and 2";
}

// A step at a time, as one would count by hand.

struct Counted {
  bool by_threshold = false;
  std::optional<bool> by_alpha;
  std::size_t held = 0;
  std::optional<std::size_t> binding;
  std::size_t binding_members = 0;
  std::optional<std::size_t> nearest;
  double share = -1;
};

bool stops(const WatchedLimit& watched, double value) {
  if (std::isnan(value)) return !watched.may_be_missing;
  return !watched.bound.holds(value);
}

const std::vector<double>& member_of(const std::vector<std::vector<double>>& values,
                                     std::size_t member) {
  return values[values.size() == 1 ? 0 : member];
}

struct RandomCase {
  std::vector<std::vector<std::vector<double>>> values;  // of each watched limit
  StartQuestion question;
};

Counted counted(const RandomCase& one, std::size_t start) {
  const StartQuestion& q = one.question;
  const std::size_t at = q.starts.step_of(start);
  Counted out;
  std::vector<std::size_t> first_by_limit(q.limits, 0);
  for (std::size_t m = 0; m < q.members; ++m) {
    std::size_t earliest = q.steps, limit = q.limits;
    for (std::size_t w = 0; w < q.watched.size(); ++w)
      for (const twin::StepRange& when : q.watched[w].when)
        for (std::size_t i = at + when.begin; i < at + when.end; ++i)
          if (stops(q.watched[w], member_of(one.values[w], m)[i]) && i < earliest) {
            earliest = i;
            limit = q.watched[w].limit;
          }
    if (limit == q.limits) {
      ++out.held;
      if (m == 0) out.by_threshold = true;
    } else {
      ++first_by_limit[limit];
    }
  }
  for (std::size_t l = 0; l < q.limits; ++l)
    if (first_by_limit[l] > out.binding_members) {
      out.binding_members = first_by_limit[l];
      out.binding = l;
    }
  bool has_alpha = false, allows = out.by_threshold;
  for (std::size_t w = 0; w < q.watched.size(); ++w) {
    const WatchedLimit& watched = q.watched[w];
    if (!watched.alpha.empty()) has_alpha = true;
    for (const twin::StepRange& when : watched.when)
      for (std::size_t i = at + when.begin; i < at + when.end; ++i) {
        const double value = one.values[w][0][i];
        if (std::isnan(value)) continue;
        if (!watched.alpha.empty()) allows &= value <= watched.bound.value * watched.alpha[start];
        const double share = watched.bound.side == BoundSide::at_most ? value / watched.bound.value
                                                                      : watched.bound.value / value;
        if (share > out.share) {
          out.share = share;
          out.nearest = watched.limit;
        }
      }
  }
  if (has_alpha) out.by_alpha = allows;
  return out;
}

TEST(StartChances, AreThoseOfAStepByStepCountOnRandomCases) {
  Rng random(7, "start_chances_test");
  std::size_t held = 0, stopped = 0, unlike = 0;
  for (int round = 0; round < 400; ++round) {
    RandomCase one;
    StartQuestion& q = one.question;
    q.steps = 20 + random.bits() % 30;
    q.members = 1 + random.bits() % 5;
    q.starts = {random.bits() % 3, 1 + random.bits() % 3, 0};
    const std::size_t longest = 1 + random.bits() % 10;
    while (q.starts.step_of(q.starts.count) + longest <= q.steps) ++q.starts.count;
    const std::size_t watched = 1 + random.bits() % 4;
    q.limits = 1 + random.bits() % watched;
    one.values.resize(watched);
    for (std::size_t w = 0; w < watched; ++w) {
      WatchedLimit limit;
      limit.limit = random.bits() % q.limits;
      limit.bound = {random.uniform() < 0.7 ? BoundSide::at_most : BoundSide::at_least, 1.0};
      limit.may_be_missing = random.uniform() < 0.3;
      const std::size_t begin = random.bits() % longest;
      const std::size_t end = begin + 1 + random.bits() % (longest - begin);
      limit.when = {{begin, end}};
      if (end + 1 < longest && random.uniform() < 0.5) limit.when.push_back({end + 1, longest});
      one.values[w].resize(random.uniform() < 0.3 ? 1 : q.members);
      const bool is_upper = limit.bound.side == BoundSide::at_most;
      for (std::vector<double>& values : one.values[w])
        for (std::size_t i = 0; i < q.steps; ++i) {
          // Mostly within, and now and then the bound itself.
          const double value =
              (is_upper ? 0.9 : 1.1) + (is_upper ? 1 : -1) * 0.15 * random.normal();
          const double kind = random.uniform();
          values.push_back(kind < 0.03 ? unknown : kind < 0.06 ? 1.0 : std::max(0.05, value));
        }
      if (is_upper && random.uniform() < 0.5)
        for (std::size_t s = 0; s < q.starts.count; ++s)
          limit.alpha.push_back(0.8 + 0.2 * random.uniform());
      q.watched.push_back(limit);
    }
    for (std::size_t w = 0; w < watched; ++w)
      for (const std::vector<double>& values : one.values[w])
        q.watched[w].members.emplace_back(values);
    const auto chances = twin::start_chances(q);
    ASSERT_EQ(chances.size(), q.starts.count);
    for (std::size_t s = 0; s < chances.size(); ++s) {
      SCOPED_TRACE("round " + std::to_string(round) + ", start " + std::to_string(s));
      const Counted expected = counted(one, s);
      const StartChance& found = chances[s];
      EXPECT_EQ(found.by_threshold, expected.by_threshold);
      EXPECT_EQ(found.by_alpha, expected.by_alpha);
      EXPECT_EQ(found.held, expected.held);
      held += expected.held;
      if (expected.binding) {
        ++stopped;
        ASSERT_TRUE(found.binding);
        // Of two limits that stop at the same step either is the first: counts tell.
        EXPECT_TRUE(found.binding->is_exceeded);
        if (found.binding->limit != *expected.binding) ++unlike;
      } else if (expected.nearest) {
        ASSERT_TRUE(found.binding);
        EXPECT_FALSE(found.binding->is_exceeded);
        EXPECT_DOUBLE_EQ(found.binding->share, expected.share);
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(held, 500U) << "the cases hold and stop";
  EXPECT_GT(stopped, 500U);
  EXPECT_LT(unlike, stopped / 10) << "but for ties the same limit binds";
}

/// Visits as one would make them: from the start on, in every run of usable steps that is long
/// enough.
bool is_done_in_visits(const std::vector<std::uint8_t>& usable, std::size_t start,
                       const twin::SplitWork& split) {
  std::size_t worked = 0;
  bool begins_at_once = false;
  for (std::size_t i = start; i < split.by_step;) {
    std::size_t end = i;
    while (end < split.by_step && usable[end] == 1) ++end;
    if (end - i >= split.visits.shortest) {
      if (i == start) begins_at_once = true;
      worked += end - i - split.visits.lost;
    }
    i = end + 1;
  }
  return begins_at_once && worked >= split.work;
}

TEST(StartChances, OfSplitWorkAreThoseOfVisitsMadeOneByOne) {
  Rng random(9, "start_chances_test/split");
  std::size_t kept = 0, refused = 0, too_late = 0;
  for (int round = 0; round < 300; ++round) {
    const std::size_t steps = 60, members = 3;
    std::vector<std::vector<double>> height, wind;
    for (std::size_t m = 0; m < members; ++m) {
      height.emplace_back();
      wind.emplace_back();
      double rough = 0;
      for (std::size_t i = 0; i < steps; ++i) {
        rough = 0.9 * rough + 0.4 * random.normal();
        height.back().push_back(1 + 0.4 * rough);
        wind.back().push_back(8 + random.normal());
      }
    }
    WatchedLimit waves, gusts;
    waves.bound = {BoundSide::at_most, 1.5};
    gusts.bound = {BoundSide::at_most, 10};
    gusts.limit = 1;
    waves.when = gusts.when = {{0, 4}};
    for (std::size_t m = 0; m < members; ++m) {
      waves.members.emplace_back(height[m]);
      gusts.members.emplace_back(wind[m]);
    }
    StartQuestion question;
    question.steps = steps;
    question.members = members;
    question.limits = 3;
    question.starts = {0, 2, 25};
    waves.alpha.assign(question.starts.count, 0.8);
    question.watched = {waves, gusts};
    twin::SplitWork split;
    split.work = 5 + random.bits() % 20;
    split.visits = {4, 1};
    split.by_step = 55;
    split.limit = 2;
    question.split = split;
    const auto chances = twin::start_chances(question);
    for (std::size_t s = 0; s < chances.size(); ++s) {
      const std::size_t from = question.starts.step_of(s);
      std::size_t held = 0;
      bool central = false, practice = false;
      for (std::size_t m = 0; m < members; ++m) {
        std::vector<std::uint8_t> usable, careful;
        for (std::size_t i = 0; i < steps; ++i) {
          usable.push_back(height[m][i] <= 1.5 && wind[m][i] <= 10 ? 1 : 0);
          careful.push_back(height[m][i] <= 0.8 * 1.5 && wind[m][i] <= 10 ? 1 : 0);
        }
        const bool done = is_done_in_visits(usable, from, split);
        held += done ? 1 : 0;
        if (m == 0) central = done;
        if (m == 0) practice = is_done_in_visits(careful, from, split);
      }
      EXPECT_EQ(chances[s].held, held) << "round " << round << ", start " << s;
      EXPECT_EQ(chances[s].by_threshold, central);
      EXPECT_EQ(chances[s].by_alpha, practice);
      kept += held;
      refused += members - held;
      if (chances[s].binding->is_exceeded && chances[s].binding->limit == 2) ++too_late;
    }
  }
  EXPECT_GT(kept, 1000U);
  EXPECT_GT(refused, 1000U);
  EXPECT_GT(too_late, 10U) << "time alone may be too short";
}

TEST(StartWindows, CountWhatTheRulesSayWithinThem) {
  std::vector<StartChance> chances(5);
  const std::vector<double> probability{0.2, 0.8, 0.95, 0.6, 0.9};
  chances[1].by_threshold = chances[2].by_threshold = true;
  chances[2].by_alpha = true;
  const auto windows =
      twin::windows_of(chances, probability, std::vector<std::uint8_t>{0, 1, 1, 0, 1});
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_DOUBLE_EQ(windows[0].least, 0.8);
  EXPECT_DOUBLE_EQ(windows[0].mean, 0.875);
  EXPECT_DOUBLE_EQ(windows[0].most, 0.95);
  EXPECT_EQ(windows[0].best, 2U);
  EXPECT_EQ(windows[0].by_threshold, 2U);
  EXPECT_EQ(windows[0].by_alpha, 1U);
  EXPECT_EQ(windows[1].starts(), 1U);
  EXPECT_EQ(twin::verdict_of(0.9, {}), twin::Verdict::go);
  EXPECT_EQ(twin::verdict_of(0.89, {}), twin::Verdict::marginal);
  EXPECT_EQ(twin::verdict_of(0.49, {}), twin::Verdict::no_go);
}

}  // namespace
}  // namespace slackwater::tests::start_chances_test
