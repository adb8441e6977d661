#include "twin/risk/held_without.h"

#include <gtest/gtest.h>

#include <limits>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::held_without_test {
namespace {

using twin::BoundSide;
using twin::StartQuestion;
using twin::WatchedLimit;

/// Three limits on made-up values, each at two places, in seven futures.
struct MadeUp {
  explicit MadeUp(Rng& rng) {
    question.steps = 60;
    question.members = 7;
    question.limits = 3;
    question.starts = {0, 2, 20};
    for (std::size_t i = 0; i < 6; ++i) {
      WatchedLimit watched;
      watched.limit = i % 3;
      watched.bound = {i % 3 == 2 ? BoundSide::at_least : BoundSide::at_most,
                       i % 3 == 2 ? 0.1 : 0.9};
      watched.when = {{i, i + 4}};
      const std::size_t series = i < 2 ? 1 : question.members;
      for (std::size_t m = 0; m < series; ++m) {
        auto& own = values.emplace_back(question.steps);
        for (double& value : own) value = rng.uniform();
      }
      question.watched.push_back(std::move(watched));
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t m = 0; m < (i < 2 ? 1 : question.members); ++m)
        question.watched[i].members.emplace_back(values[next++]);
  }
  StartQuestion question;
  std::vector<std::vector<double>> values;
};

/// A bound that nothing exceeds is as good as none.
StartQuestion with_endless_bound(StartQuestion question, std::size_t limit) {
  for (WatchedLimit& watched : question.watched)
    if (watched.limit == limit)
      watched.bound.value *= watched.bound.side == BoundSide::at_least ? -1e9 : 1e9;
  return question;
}

std::vector<std::size_t> held_of(const StartQuestion& question) {
  std::vector<std::size_t> held;
  for (const auto& chance : twin::start_chances(question)) held.push_back(chance.held);
  return held;
}

TEST(HeldWithout, IsWhatABoundThatNothingExceedsHolds) {
  Rng rng(2026, "held_without_test");
  std::size_t gained = 0;
  for (int made = 0; made < 50; ++made) {
    const MadeUp one(rng);
    const auto as_is = held_of(one.question);
    for (std::size_t limit = 0; limit < 3; ++limit) {
      const auto held = twin::held_without(one.question, limit);
      EXPECT_EQ(held, held_of(with_endless_bound(one.question, limit)));
      for (std::size_t s = 0; s < held.size(); ++s) {
        EXPECT_GE(held[s], as_is[s]);
        gained += held[s] - as_is[s];
      }
    }
  }
  EXPECT_GT(gained, 1000U) << "nothing was at stake";
}

TEST(HeldWithout, OfTheOnlyLimitIsEveryMember) {
  Rng rng(2027, "held_without_test");
  MadeUp one(rng);
  std::erase_if(one.question.watched,
                [](const WatchedLimit& watched) { return watched.limit > 0; });
  EXPECT_EQ(twin::held_without(one.question, 0), std::vector<std::size_t>(20, 7));
}

}  // namespace
}  // namespace slackwater::tests::held_without_test
