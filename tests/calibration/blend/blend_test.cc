#include "calibration/blend/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::blend_test {
namespace {

using Eigen::MatrixXd;

/// Candidates a (prior 1, no baseline), b, c (baselines).
std::vector<Candidate> three() {
  return {{Method::forecast, true, 1.0, false},
          {Method::reference_slab, true, 0.0, true},
          {Method::persistence, true, 0.0, true}};
}

PastPair pair_with(const MatrixXd& gram, double age_days) {
  PastPair pair;
  pair.age_days = age_days;
  pair.values = 96;
  pair.gram = gram;
  pair.present.assign(static_cast<std::size_t>(gram.rows()), true);
  return pair;
}

MatrixXd independent_errors(std::initializer_list<double> mean_squares) {
  MatrixXd gram = MatrixXd::Zero(static_cast<Eigen::Index>(mean_squares.size()),
                                 static_cast<Eigen::Index>(mean_squares.size()));
  Eigen::Index c = 0;
  for (const double square : mean_squares) gram(c, c) = square, ++c;
  return gram;
}

std::vector<PastPair> same_every_day(const MatrixXd& gram, int days) {
  std::vector<PastPair> past;
  for (int day = 0; day < days; ++day) past.push_back(pair_with(gram, day));
  return past;
}

std::vector<double> weights_of(const Blend& blend) {
  std::vector<double> weights;
  for (const CandidateShare& share : blend.share) weights.push_back(share.weight);
  return weights;
}

TEST(Blend, WithoutAPairWeightsAreThoseOfTheOthers) {
  // Some days are better for one candidate, some for another; none is out of keeping.
  std::vector<PastPair> past;
  for (int day = 0; day < 8; ++day)
    past.push_back(pair_with(independent_errors({1.0 + 0.1 * day, 1.6 - 0.1 * day, 1.2}), day));
  const Blend all = blend_of(three(), past);
  ASSERT_EQ(all.without_pair.size(), past.size());
  for (std::size_t i = 0; i < past.size(); ++i) {
    std::vector<PastPair> others = past;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const std::vector<double> expected = weights_of(blend_of(three(), others));
    for (std::size_t c = 0; c < expected.size(); ++c)
      EXPECT_NEAR(all.without_pair[i][c], expected[c], 1e-9) << i << " " << c;
    EXPECT_NE(all.without_pair[i], weights_of(all)) << i;
  }
  past.resize(4);
  for (const auto& weights : blend_of(three(), past).without_pair)
    EXPECT_EQ(weights, (std::vector<double>{1.0, 0.0, 0.0})) << "the prior learns from none";
}

TEST(Blend, WithFewerThanFivePairsThePriorRules) {
  const auto gram = independent_errors({1.0, 0.01, 0.01});
  for (int days = 0; days < 5; ++days) {
    const Blend blend = blend_of(three(), same_every_day(gram, days));
    EXPECT_FALSE(blend.earned);
    EXPECT_EQ(weights_of(blend), (std::vector<double>{1.0, 0.0, 0.0}));
    EXPECT_EQ(blend.pairs, static_cast<std::size_t>(days));
    EXPECT_NE(blend.provenance.find("prior"), std::string::npos);
    EXPECT_FALSE(blend.fell_back_to);
  }
  EXPECT_TRUE(blend_of(three(), same_every_day(gram, 5)).earned);
}

TEST(Blend, ThePriorIsOurForecastMergedWithTheProvidersWhereItIsPresent) {
  auto candidates = standard_candidates();
  Blend blend = blend_of(candidates, {});
  EXPECT_EQ(blend.share[0].weight, 0.2);
  EXPECT_EQ(blend.share.back().method, Method::merged);
  EXPECT_EQ(blend.share.back().weight, 0.8);
  candidates[1].available = false;
  candidates.back().available = false;
  blend = blend_of(candidates, {});
  EXPECT_EQ(blend.share[0].weight, 1.0);
  candidates[0].available = false;
  blend = blend_of(candidates, {});
  EXPECT_EQ(blend.share[2].method, Method::reference_slab);
  EXPECT_EQ(blend.share[2].weight, 1.0);
}

TEST(Blend, MinimisesThePastErrorAndThePullOfThePriorExactly) {
  BlendSettings settings;
  settings.least_weight = 0.0;
  const double a = 0.04;
  const double b = 0.02;
  const auto past = same_every_day(independent_errors({a, b, 10.0}), 30);
  auto candidates = three();
  candidates[2].available = false;
  double g = 0;
  for (int day = 0; day < 30; ++day) g += std::exp(-day / 14.0);
  // d_1 = min(a + b, b) = b; our own forecast has d = 0. Minimum over w_1 = w of
  // g [a (1-w)^2 + b w^2] + 2 b w^2.
  const double w = g * a / (g * (a + b) + 2.0 * b);
  const Blend blend = blend_of(candidates, past, settings);
  EXPECT_NEAR(blend.share[1].weight, w, 1e-5);  // the ridge
  EXPECT_NEAR(blend.share[0].weight, 1.0 - w, 1e-5);
  EXPECT_NEAR(*blend.share[0].past_rmse_m_s, 0.2, 1e-12);
  EXPECT_NEAR(*blend.share[1].past_rmse_m_s, std::sqrt(b), 1e-12);
}

TEST(Blend, UnitsDoNotMatter) {
  Rng random(1, "units");
  std::vector<PastPair> past;
  std::vector<PastPair> in_cm;
  for (int day = 0; day < 20; ++day) {
    MatrixXd errors(3, 8);
    for (double& value : errors.reshaped()) value = 0.05 * random.normal();
    past.push_back(pair_with(errors * errors.transpose(), day));
    in_cm.push_back(pair_with(1e4 * (errors * errors.transpose()), day));
  }
  const auto weights = weights_of(blend_of(three(), past));
  const auto again = weights_of(blend_of(three(), in_cm));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(weights[c], again[c], 1e-9);
}

TEST(Blend, TheOrderOfThePastDoesNotMatter) {
  Rng random(1, "order");
  std::vector<PastPair> past;
  for (int day = 0; day < 20; ++day) {
    MatrixXd errors(3, 8);
    for (double& value : errors.reshaped()) value = random.normal();
    past.push_back(pair_with(errors * errors.transpose(), day));
  }
  const auto weights = weights_of(blend_of(three(), past));
  std::reverse(past.begin(), past.end());
  EXPECT_EQ(weights, weights_of(blend_of(three(), past)));
}

TEST(Blend, IdenticalCandidatesShareAndDoNotBlowUp) {
  // b and c are one forecast, better than a, independent of it.
  MatrixXd gram(3, 3);
  gram << 0.04, 0.0, 0.0, 0.0, 0.02, 0.02, 0.0, 0.02, 0.02;
  const Blend blend = blend_of(three(), same_every_day(gram, 20));
  EXPECT_NEAR(blend.share[1].weight, blend.share[2].weight, 1e-6);
  EXPECT_GT(blend.share[1].weight, 0.2);
  EXPECT_GT(blend.share[0].weight, 0.2);
  // All three the same: the prior stays.
  const Blend same = blend_of(three(), same_every_day(MatrixXd::Constant(3, 3, 0.03), 20));
  EXPECT_NEAR(same.share[0].weight, 1.0, 1e-6);
}

TEST(Blend, WhatIsNotFiniteIsAbsent) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto good = same_every_day(independent_errors({0.04, 0.02, 0.03}), 20);
  auto spoilt = good;
  auto absent = good;
  for (std::size_t i = 0; i < 20; i += 3) {
    spoilt[i].gram.row(2).setConstant(nan);
    spoilt[i].gram.col(2).setConstant(nan);
    absent[i].present[2] = false;
  }
  const Blend blend = blend_of(three(), spoilt);
  EXPECT_EQ(weights_of(blend), weights_of(blend_of(three(), absent)));
  EXPECT_EQ(blend.share[2].pairs, 13u);
  auto never = good;
  for (PastPair& pair : never) pair.gram(2, 2) = nan;
  EXPECT_EQ(blend_of(three(), never).share[2].weight, 0.0);
  EXPECT_FALSE(blend_of(three(), never).share[2].past_rmse_m_s);
}

TEST(Blend, AbsenceIsNoEvidenceForOrAgainst) {
  // The baseline is missing on the bad days; its own error must not look better for it.
  std::vector<PastPair> past;
  for (int day = 0; day < 24; ++day) {
    const double severity = day % 2 == 0 ? 1.0 : 100.0;
    past.push_back(pair_with(severity * independent_errors({0.01, 0.04, 0.04}), day));
    if (day % 2 == 1) past.back().present[1] = false;
  }
  const Blend blend = blend_of(three(), past);
  EXPECT_GT(blend.share[0].weight, 0.6);
  EXPECT_NEAR(*blend.share[1].past_rmse_m_s, 0.2, 1e-12);
  EXPECT_FALSE(blend.fell_back_to);
}

TEST(Blend, ANewBaselineEarnsNothingBeforeFivePairsOfItsOwn) {
  auto past = same_every_day(independent_errors({0.04, 0.04, 1e-6}), 20);
  for (std::size_t i = 4; i < past.size(); ++i) past[i].present[2] = false;
  EXPECT_EQ(blend_of(three(), past).share[2].weight, 0.0);
  past[4].present[2] = true;
  EXPECT_GT(blend_of(three(), past).share[2].weight, 0.3);
}

TEST(Blend, WhatIsNotAvailableTodayGetsNothing) {
  auto candidates = three();
  candidates[1].available = false;
  const Blend blend = blend_of(candidates, same_every_day(independent_errors({1, 0.001, 1}), 20));
  EXPECT_EQ(blend.share[1].weight, 0.0);
  EXPECT_NEAR(blend.share[0].weight + blend.share[2].weight, 1.0, 1e-14);
}

/// A baseline that is better than our forecast by the same factor every day, the errors otherwise
/// the same: all that the blend adds to it is error.
std::vector<PastPair> clearly_better_baseline(int days, std::string_view stream) {
  Rng random(2, stream);
  std::vector<PastPair> past;
  for (int day = 0; day < days; ++day) {
    const double severity = std::exp(0.4 * random.normal());
    MatrixXd gram(3, 3);
    gram << 0.04, 0.02, 0.02, 0.02, 0.01, 0.01, 0.02, 0.01, 0.25;
    past.push_back(pair_with(severity * gram, day));
  }
  return past;
}

/// A prior so strong that the weights alone would hold on to it.
BlendSettings stubborn() {
  BlendSettings settings;
  settings.prior_pairs = 40.0;
  settings.least_weight = 0.0;
  return settings;
}

TEST(Fallback, ABaselineThatEarnsAllTheWeightIsIssuedAlone) {
  const Blend blend = blend_of(three(), clearly_better_baseline(12, "clear"));
  EXPECT_EQ(blend.fell_back_to, 1u);
  EXPECT_EQ(weights_of(blend), (std::vector<double>{0.0, 1.0, 0.0}));
}

TEST(Fallback, ABaselineThatBeatsTheBlendDayByDayIsIssuedAlone) {
  const Blend blend = blend_of(three(), clearly_better_baseline(25, "clear"), stubborn());
  ASSERT_TRUE(blend.fell_back_to);
  EXPECT_EQ(*blend.fell_back_to, 1u);
  EXPECT_EQ(weights_of(blend), (std::vector<double>{0.0, 1.0, 0.0}));
  EXPECT_NE(blend.provenance.find("reference-slab alone"), std::string::npos);
}

TEST(Fallback, NeverOnOneLuckyDay) {
  // Alike on all days but one, on which the baseline is perfect and all else terrible.
  Rng random(3, "lucky");
  for (int round = 0; round < 50; ++round) {
    std::vector<PastPair> past;
    for (int day = 0; day < 30; ++day) {
      MatrixXd errors(3, 6);
      for (double& value : errors.reshaped()) value = 0.05 * random.normal();
      past.push_back(pair_with(errors * errors.transpose(), day));
    }
    MatrixXd lucky = independent_errors({9.0, 0.0, 9.0});
    past[static_cast<std::size_t>(round % 30)] = pair_with(lucky, round % 30);
    const Blend blend = blend_of(three(), past);
    EXPECT_FALSE(blend.fell_back_to) << "round " << round;
    EXPECT_LT(blend.share[1].weight, 0.75) << "round " << round;
    EXPECT_FALSE(blend_of(three(), past, stubborn()).fell_back_to) << "round " << round;
  }
}

TEST(Fallback, NotToABaselineThatIsWorseHoweverSteadily) {
  // Ours is the better one every day; the prior, turned round, holds on to the other.
  auto candidates = three();
  std::vector<PastPair> past = clearly_better_baseline(20, "worse");
  std::swap(candidates[0].prior_weight, candidates[1].prior_weight);
  for (PastPair& pair : past) {
    pair.gram.row(0).swap(pair.gram.row(1));
    pair.gram.col(0).swap(pair.gram.col(1));
  }
  const Blend blend = blend_of(candidates, past, stubborn());
  EXPECT_FALSE(blend.fell_back_to);
}

TEST(Fallback, NotOnFewPairs) {
  EXPECT_FALSE(blend_of(three(), clearly_better_baseline(7, "few"), stubborn()).fell_back_to);
}

TEST(Blend, ABugIsRefused) {
  EXPECT_THROW((void)blend_of({}, {}), ContractViolation);
  auto candidates = three();
  EXPECT_THROW((void)blend_of(candidates, same_every_day(MatrixXd::Identity(2, 2), 1)),
               ContractViolation);
  auto future = same_every_day(MatrixXd::Identity(3, 3), 1);
  future[0].age_days = -1;
  EXPECT_THROW((void)blend_of(candidates, future), ContractViolation);
  candidates[1].prior_weight = -0.1;
  EXPECT_THROW((void)blend_of(candidates, {}), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::blend_test
