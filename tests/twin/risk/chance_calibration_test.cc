// What past mornings make of a probability: truths that are drawn from a known distortion.
#include "twin/risk/chance_calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"
#include "twin/risk/past_verdicts.h"

namespace slackwater::tests::chance_calibration_test {
namespace {

using twin::ChanceCalibration;
using twin::PastStarts;

double logit(double p) { return std::log(p / (1 - p)); }
double logistic(double x) { return 1 / (1 + std::exp(-x)); }

/// Mornings of starts whose chance is logistic(shift + slope logit(said)); those of one morning
/// share their luck, as they share its weather.
std::vector<PastStarts> mornings(std::size_t count, double shift, double slope,
                                 std::uint64_t seed) {
  Rng random(seed, "chance_calibration_test");
  std::vector<PastStarts> all(count);
  for (PastStarts& morning : all) {
    const double about = 2.5 * random.normal();
    const double luck = random.uniform(0, 1);
    for (int s = 0; s < 24; ++s) {
      const double x = about + random.normal();
      morning.push_back({logistic(x), luck < logistic(shift + slope * x)});
    }
  }
  return all;
}

double brier(const ChanceCalibration& calibration, const std::vector<PastStarts>& of) {
  double sum = 0, count = 0;
  for (const PastStarts& morning : of)
    for (const auto& start : morning) {
      const double off = calibration(start.said) - (start.held ? 1 : 0);
      sum += off * off;
      count += 1;
    }
  return sum / count;
}

TEST(ChanceCalibration, IsNoneWithoutPastMornings) {
  const ChanceCalibration none = twin::chance_calibration({});
  const std::vector<PastStarts> empty(3);
  const ChanceCalibration of_empty = twin::chance_calibration(empty);
  for (const double p : {0.0, 0.001, 0.3, 0.97, 1.0}) {
    EXPECT_EQ(none(p), p);
    EXPECT_EQ(of_empty(p), p);
  }
  EXPECT_EQ(of_empty.mornings, 0U);
}

TEST(ChanceCalibration, FindsTheDistortionThatWasDrawn) {
  for (const auto& [shift, slope] : {std::pair{1.0, 1.0}, {-0.8, 1.3}, {0.5, 0.6}}) {
    const ChanceCalibration found = twin::chance_calibration(mornings(4000, shift, slope, 5));
    EXPECT_NEAR(found.shift, shift, 0.1) << shift << " " << slope;
    EXPECT_NEAR(found.slope, slope, 0.1) << shift << " " << slope;
    EXPECT_EQ(found.mornings, 4000U);
    EXPECT_EQ(found.starts, 96000U);
  }
}

// The sum of both, differentiated by hand, is flat where the fit ends.
TEST(ChanceCalibration, IsTheLikeliestUnderWhatIsBelievedBeforehand) {
  const std::vector<PastStarts> past = mornings(12, 0.7, 0.8, 9);
  const ChanceCalibration found = twin::chance_calibration(past);
  const auto loss = [&](double a, double b) {
    double sum = 0.5 * std::pow(a / 0.7, 2) + 0.5 * std::pow((b - 1) / 0.2, 2);
    for (const PastStarts& morning : past)
      for (const auto& start : morning) {
        const double p = logistic(a + b * logit(std::clamp(start.said, 0.005, 0.995)));
        sum -= 2.0 / 24 * std::log(start.held ? p : 1 - p);
      }
    return sum;
  };
  const double least = loss(found.shift, found.slope);
  for (const double d : {-0.05, -0.005, 0.005, 0.05}) {
    EXPECT_GT(loss(found.shift + d, found.slope), least);
    EXPECT_GT(loss(found.shift, found.slope + d), least);
    EXPECT_GT(loss(found.shift + d, found.slope - d), least);
  }
}

TEST(ChanceCalibration, KeepsTheOrderOfStarts) {
  Rng random(3, "order");
  for (int round = 0; round < 200; ++round) {
    // Also where the starts that were said to be surer held less often.
    const ChanceCalibration found = twin::chance_calibration(mornings(
        30, random.normal(), 2 * random.normal(), 100 + static_cast<std::uint64_t>(round)));
    double before = found(0);
    for (int i = 1; i <= 100; ++i) {
      const double now = found(0.01 * i);
      EXPECT_GE(now, before);
      EXPECT_GE(now, 0);
      EXPECT_LE(now, 1);
      before = now;
    }
  }
}

TEST(ChanceCalibration, OfOneMorningIsNoCertainty) {
  const std::vector<PastStarts> held{PastStarts(48, {0.6, true})};
  const ChanceCalibration one = twin::chance_calibration(held);
  EXPECT_GT(one(0.6), 0.6);
  EXPECT_LT(one(0.6), 0.75);
  const std::vector<PastStarts> broken{PastStarts(48, {0.95, false})};
  EXPECT_GT(twin::chance_calibration(broken)(0.95), 0.6);
}

// One ocean's mornings teach another morning of it; and where there is nothing to learn they cost
// next to nothing.
TEST(ChanceCalibration, EarnsMoreThanItCosts) {
  double gained = 0, lost = 0;
  constexpr int oceans = 60;
  for (int o = 0; o < oceans; ++o) {
    const auto seed = static_cast<std::uint64_t>(10 * o);
    const ChanceCalibration none;
    const auto distorted = mornings(400, 0.9, 0.9, seed + 1);
    const auto learnt = twin::chance_calibration(mornings(38, 0.9, 0.9, seed));
    gained += brier(none, distorted) - brier(learnt, distorted);
    const auto sound = mornings(400, 0, 1, seed + 3);
    const auto nothing = twin::chance_calibration(mornings(38, 0, 1, seed + 2));
    lost += brier(nothing, sound) - brier(none, sound);
  }
  std::printf("Brier score: %.4f less where 0.9 is to be learnt, %.4f more where nothing is\n",
              gained / oceans, lost / oceans);
  EXPECT_GT(gained / oceans, 0.012);
  EXPECT_LT(lost / oceans, 0.003);
}

TEST(PastVerdicts, CountGoesThatHeldAndMorningsThatWereLost) {
  // 40 goes of which 38 held, 6 mornings at 0.2 whose best start held, 14 on which none did.
  std::vector<PastStarts> past;
  for (int m = 0; m < 60; ++m) {
    const bool is_go = m < 40;
    const bool held = is_go ? m >= 2 : m < 46;
    past.push_back({{is_go ? 0.99 : 0.2, held}, {0.02, false}});
  }
  const twin::PastVerdicts found = twin::past_verdicts(past, {});
  EXPECT_EQ(found.mornings, 60U);
  EXPECT_EQ(found.goes, 40U);
  EXPECT_EQ(found.goes_held, 38U);
  EXPECT_EQ(found.lost, 6U);
  EXPECT_EQ(found.classes[0].starts, 40U);
  EXPECT_EQ(found.classes[0].held, 38U);
  std::size_t starts = 0;
  for (const auto& of : found.classes) starts += of.starts;
  EXPECT_EQ(starts, 120U);
}

// Each morning is told from the others: what came of it alone cannot make it a go.
TEST(PastVerdicts, OfAMorningDoNotKnowWhatCameOfIt) {
  const std::vector<PastStarts> one{PastStarts(10, {0.89, true})};
  EXPECT_GT(twin::chance_calibration(one)(0.89), 0.9);
  const twin::PastVerdicts found = twin::past_verdicts(one, {});
  EXPECT_EQ(found.goes, 0U);
  EXPECT_EQ(found.lost, 1U);
}

}  // namespace
}  // namespace slackwater::tests::chance_calibration_test
