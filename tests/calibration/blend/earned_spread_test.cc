#include "calibration/blend/earned_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::earned_spread_test {
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

/// Pairs whose first day errs as sigma says and whose later days by other factors of it.
std::vector<PastSpread> past_by_day(int days, const std::vector<double>& later, Rng& random) {
  std::vector<PastSpread> past;
  for (int day = 0; day < days; ++day) {
    past.push_back(past_of(day_of(normal, 1.0, random), day));
    for (const double factor : later)
      past.back().later.push_back(past_of(day_of(normal, factor, random), 0).errors);
  }
  return past;
}

TEST(EarnedSpread, EachDayOfLeadEarnsItsOwnFactor) {
  Rng random(6, "days of lead");
  double first = 0;
  double second = 0;
  double third = 0;
  constexpr int seeds = 60;
  for (int seed = 0; seed < seeds; ++seed) {
    const EarnedSpread spread = earned_spread(past_by_day(20, {1.4, 0.7}, random));
    ASSERT_EQ(spread.later.size(), 2u);
    first += spread.scale / seeds;
    second += spread.later[0].scale / seeds;
    third += spread.later[1].scale / seeds;
  }
  // Of twenty pairs the prior of two, worth the day before, holds back a tenth of the way; the
  // severity of days adds 4 % to the quantile.
  EXPECT_NEAR(first, 1.0, 0.06);
  EXPECT_NEAR(second / first, 1.4, 0.09);
  EXPECT_NEAR(third / first, 0.7, 0.10);
}

TEST(EarnedSpread, FewPairsLeaveALaterDayNearTheFirst) {
  Rng random(7, "few");
  std::vector<PastSpread> past;
  for (int day = 0; day < 20; ++day) past.push_back(past_of(day_of(normal, 1.5, random), day));
  EXPECT_TRUE(earned_spread(past).later.empty());
  const double first = earned_spread(past).scale;
  EXPECT_GT(first, 1.3);
  for (PastSpread& pair : past) pair.later.resize(2);  // nothing counted
  for (const LaterSpread& later : earned_spread(past).later) {
    EXPECT_EQ(later.scale, first) << "a day that nobody has seen is as the first";
    EXPECT_EQ(later.pairs, 0u);
  }
  past.back().later[0] = past_of(day_of(normal, 0.5, random), 0).errors;
  const EarnedSpread one = earned_spread(past);
  EXPECT_GT(one.later[0].scale, 0.75 * first) << "one pair against a prior of two";
  EXPECT_EQ(one.later[1].scale, one.later[0].scale);
  EXPECT_NE(one.provenance.find("on day 2 of lead (1 pair"), std::string::npos) << one.provenance;
  EXPECT_EQ(one.provenance.find("on day 3"), std::string::npos) << one.provenance;
}

TEST(EarnedSpread, LaterDaysDoNotMoveTheFirst) {
  Rng random(8, "first day");
  std::vector<PastSpread> past = past_by_day(15, {3.0, 0.2}, random);
  const EarnedSpread with = earned_spread(past);
  for (PastSpread& pair : past) pair.later.clear();
  const EarnedSpread without = earned_spread(past);
  EXPECT_EQ(with.scale, without.scale);
  EXPECT_EQ(with.past_coverage_80, without.past_coverage_80);
  EXPECT_LE(with.later[0].scale, 2.0);
  EXPECT_GE(with.later[1].scale, 0.5);
}

TEST(EarnedSpread, PassesFromDayToDayWithoutAJump) {
  EarnedSpread spread;
  spread.scale = 0.9;
  EXPECT_EQ(spread.scale_at(60), 0.9) << "one factor for all days";
  spread.later = {{1.2, 5, 0.7}, {1.1, 5, 0.7}};
  EXPECT_EQ(spread.scale_at(0), 0.9);
  EXPECT_EQ(spread.scale_at(21), 0.9);
  EXPECT_DOUBLE_EQ(spread.scale_at(24), 1.05);
  EXPECT_DOUBLE_EQ(spread.scale_at(27), 1.2);
  EXPECT_DOUBLE_EQ(spread.scale_at(45), 1.2);
  EXPECT_DOUBLE_EQ(spread.scale_at(48), 1.15);
  EXPECT_DOUBLE_EQ(spread.scale_at(72), 1.1);
  EXPECT_DOUBLE_EQ(spread.scale_at(200), 1.1);
  for (double lead_h = 0; lead_h < 80; lead_h += 1)
    EXPECT_LE(std::abs(spread.scale_at(lead_h + 1) - spread.scale_at(lead_h)), 0.3 / 6 + 1e-12);
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
}  // namespace slackwater::calibration::earned_spread_test
