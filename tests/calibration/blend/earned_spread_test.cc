#include "calibration/blend/earned_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/random.h"

namespace slackwater::calibration {
namespace {

constexpr double z_of_80_percent = 1.2815515655446004;

using Draw = std::function<double(Rng&)>;

double normal(Rng& random) { return random.normal(); }
double student_3(Rng& random) {
  double square = 0;
  for (int i = 0; i < 3; ++i) square += std::pow(random.normal(), 2);
  return random.normal() / std::sqrt(square / 3.0);
}
/// One error in twenty is eight times too large.
double with_outliers(Rng& random) {
  return (random.uniform() < 0.05 ? 8.0 : 1.0) * random.normal();
}

/// A day's normalised errors as verification has them: 200 components of which four parts share
/// most of their error (hours and levels of one motion), and a severity of the day.
std::vector<double> day_of(const Draw& draw, double factor, Rng& random) {
  const double severity = factor * std::exp(0.3 * random.normal());
  std::vector<double> z;
  for (int part = 0; part < 4; ++part) {
    const double shared = draw(random);
    for (int i = 0; i < 50; ++i) {
      z.push_back(severity * (std::sqrt(0.8) * shared + std::sqrt(0.2) * draw(random)));
    }
  }
  return z;
}

PastSpread past_of(std::span<const double> z, double age_days) {
  PastSpread pair;
  pair.age_days = age_days;
  for (const double one : z) pair.errors.add(0.07 * one, 0.07);
  return pair;
}

/// Mean over seeds of the share of |z| that the scaled band holds in days never seen, for the
/// earned factor and for sqrt(mean z^2) with the same prior and forgetting.
struct Coverage {
  double earned = 0;
  double by_moment = 0;
  double unscaled = 0;
  double earned_error = 0;  ///< root mean square about 0.8
};

Coverage coverage_after(int days, const Draw& draw, double factor) {
  Rng random(1, "coverage");
  std::vector<double> future;
  for (int day = 0; day < 2000; ++day) {
    for (const double z : day_of(draw, factor, random)) future.push_back(std::abs(z));
  }
  std::sort(future.begin(), future.end());
  const auto covered = [&](double scale) {
    const auto end = std::upper_bound(future.begin(), future.end(), z_of_80_percent * scale);
    return static_cast<double>(end - future.begin()) / static_cast<double>(future.size());
  };
  constexpr int seeds = 100;
  Coverage coverage;
  coverage.unscaled = covered(1.0);
  for (int seed = 0; seed < seeds; ++seed) {
    std::vector<PastSpread> past;
    double squares = 2.0;
    double weight = 2.0;
    for (int day = 0; day < days; ++day) {
      const auto z = day_of(draw, factor, random);
      past.push_back(past_of(z, day));
      const double g = std::exp(-day / 30.0);
      for (const double one : z) squares += g * one * one / static_cast<double>(z.size());
      weight += g;
    }
    const double earned = covered(earned_spread(past).scale);
    coverage.earned += earned / seeds;
    coverage.earned_error += std::pow(earned - 0.8, 2) / seeds;
    coverage.by_moment += covered(std::clamp(std::sqrt(squares / weight), 0.5, 2.0)) / seeds;
  }
  coverage.earned_error = std::sqrt(coverage.earned_error);
  return coverage;
}

TEST(EarnedSpread, CoversAsItShouldWhateverTheErrorsAre) {
  for (const Draw& draw : {Draw(normal), Draw(student_3), Draw(with_outliers)}) {
    const Coverage coverage = coverage_after(30, draw, 1.0);
    // The prior of two pairs in some twenty holds back a tenth of the correction.
    EXPECT_NEAR(coverage.earned, 0.8, 0.03) << "unscaled " << coverage.unscaled;
    EXPECT_LT(coverage.earned_error, 0.05);
  }
}

TEST(EarnedSpread, IsNotMisledByTailsAsTheSecondMomentIs) {
  for (const Draw& draw : {Draw(student_3), Draw(with_outliers)}) {
    const Coverage coverage = coverage_after(30, draw, 1.0);
    EXPECT_GT(coverage.by_moment, 0.825);
    EXPECT_LT(std::abs(coverage.earned - 0.8), std::abs(coverage.by_moment - 0.8));
  }
}

TEST(EarnedSpread, CorrectsASpreadThatIsWrongByHalf) {
  const Coverage narrow = coverage_after(10, normal, 1.5);
  EXPECT_LT(narrow.unscaled, 0.65);
  EXPECT_NEAR(narrow.earned, 0.8, 0.06);
  const Coverage wide = coverage_after(10, normal, 0.6);
  EXPECT_GT(wide.unscaled, 0.92);
  EXPECT_NEAR(wide.earned, 0.8, 0.06);
}

TEST(EarnedSpread, IsOneWithoutAPastAndForOneThatIsNormal) {
  EXPECT_EQ(earned_spread({}).scale, 1.0);
  EXPECT_NE(earned_spread({}).provenance.find("as forecast"), std::string::npos);
  Rng random(4, "normal");
  std::vector<double> z(200000);
  for (double& one : z) one = random.normal();
  const EarnedSpread spread = earned_spread(std::vector<PastSpread>{past_of(z, 0.0)});
  // Standard error of the quantile: sqrt(0.8 0.2/n)/(2 phi(q) q) = 0.2 %; the bins: 0.1 %.
  EXPECT_NEAR(spread.scale, 1.0, 0.006);
  EXPECT_NEAR(spread.past_coverage_80, 0.8, 0.004);
  EXPECT_EQ(spread.pairs, 1u);
}

TEST(EarnedSpread, IsBounded) {
  const std::vector<double> far(100, 50.0);
  const std::vector<double> near(100, 0.01);
  std::vector<PastSpread> past;
  for (int day = 0; day < 20; ++day) past.push_back(past_of(far, day));
  EXPECT_EQ(earned_spread(past).scale, 2.0);
  past.clear();
  for (int day = 0; day < 20; ++day) past.push_back(past_of(near, day));
  EXPECT_EQ(earned_spread(past).scale, 0.5);
}

TEST(EarnedSpread, PairsWeighTheSameWhateverTheirNumberOfValues) {
  Rng random(5, "sizes");
  std::vector<double> many(20000);
  std::vector<double> few(200);
  for (double& one : many) one = 0.7 * random.normal();
  for (double& one : few) one = 1.6 * random.normal();
  std::vector<double> as_many;
  for (int copy = 0; copy < 100; ++copy) as_many.insert(as_many.end(), few.begin(), few.end());
  const double scale =
      earned_spread(std::vector<PastSpread>{past_of(many, 0), past_of(few, 0)}).scale;
  EXPECT_NEAR(scale,
              earned_spread(std::vector<PastSpread>{past_of(many, 0), past_of(as_many, 0)}).scale,
              1e-12);
}

TEST(NormalisedErrors, DoNotCountWhatIsNotANumberAndPutAnErrorWithoutSpreadBeyond) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  NormalisedErrors errors;
  errors.add(nan, 1.0);
  errors.add(1.0, nan);
  errors.add(1.0, -1.0);
  EXPECT_EQ(errors.count(), 0.0);
  errors.add(0.1, 0.0);
  errors.add(0.0, 0.0);
  errors.add(-0.25, 1.0);
  errors.add(1e300, 1e-300);
  EXPECT_EQ(errors.count(), 4.0);
  EXPECT_EQ(errors.share(NormalisedErrors::bins), 0.5);
  EXPECT_EQ(errors.share(0), 0.25);
  EXPECT_EQ(errors.share(2), 0.25);
}

TEST(EarnedSpread, ThePastIsNotInTheFuture) {
  PastSpread pair;
  pair.age_days = -1;
  EXPECT_THROW((void)earned_spread(std::vector<PastSpread>{pair}), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration
