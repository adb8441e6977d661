// CBC behind its door.
#include "api/ask/plan/branch_and_cut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::tests::branch_and_cut_test {
namespace {

using namespace slackwater::api;

TEST(BranchAndCut, FillsKnapsacksAsTryingAllOfThemDoes) {
  Rng random(2025, "plan/knapsacks");
  for (int i = 0; i < 40; ++i) {
    LinearModel model;
    LinearTerms weight, volume;
    std::vector<double> w, v;
    for (std::size_t c = 0; c < 10; ++c) {
      model.add({random.uniform(1, 10), 0, 1, true});
      w.push_back(random.uniform(1, 10));
      v.push_back(random.uniform(1, 10));
      weight.push_back({c, w.back()});
      volume.push_back({c, v.back()});
    }
    model.at_most(weight, 25);
    model.at_most(volume, 30);
    double best = 0;
    for (unsigned mask = 0; mask < 1024; ++mask) {
      double worth = 0, sum_w = 0, sum_v = 0;
      for (std::size_t c = 0; c < 10; ++c) {
        if ((mask >> c & 1U) == 0) continue;
        worth += model.columns[c].worth;
        sum_w += w[c];
        sum_v += v[c];
      }
      if (sum_w <= 25 && sum_v <= 30) best = std::max(best, worth);
    }
    const LinearAnswer answer = maximise(model, 60);
    ASSERT_TRUE(answer.is_proven);
    EXPECT_NEAR(answer.bound, best, 1e-6);
  }
}

TEST(BranchAndCut, TakesEverythingWhereNothingBinds) {
  LinearModel model;
  model.add({3, 0, 1, true});
  model.add({-2, 0, 1, true});
  const LinearAnswer answer = maximise(model, 1);
  EXPECT_EQ(answer.values, (std::vector<double>{1, 0}));
  EXPECT_EQ(answer.bound, 3);
  EXPECT_TRUE(answer.is_proven);
}

TEST(BranchAndCut, IsSilent) {
  LinearModel model;
  model.add({1, 0, 1, true});
  model.at_most({{0, 2}}, 1);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const LinearAnswer answer = maximise(model, 1);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_NEAR(answer.bound, 0, 1e-9);
}

TEST(BranchAndCut, WithoutTimeIsABug) {
  EXPECT_THROW(static_cast<void>(maximise({}, 0)), ContractViolation);
}

}  // namespace
}  // namespace slackwater::tests::branch_and_cut_test
