#include "calibration/propagate/gaussian_memory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "tests/calibration/propagate/memory_textbook.h"

namespace slackwater::calibration::gaussian_memory_test {
namespace {

TEST(GaussianMemory, IsTheTextbooksRegressionWithGapsAndStatedErrors) {
  const std::vector<double> hour{-24, -18, -13, -12, -6, -5, 0};
  const std::vector<double> later{-9, 0.5, 6, 24, 72};
  const std::size_t levels = 4;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Rng random(seed, "textbook");
    VectorColumn residual = column(hour, {1, 5, 20, 60});
    residual.value = random_vectors(residual.value.size(), 0.1, random);
    const std::vector<Horizontal> answer = random_vectors(residual.value.size(), 0.2, random);
    const std::vector<Horizontal> answer_later = random_vectors(later.size() * levels, 0.2, random);
    std::vector<double> sigma(residual.value.size(), 0.0);
    for (double& s : sigma) s = random.uniform(0, 0.05);
    residual.status[residual.offset(2, 1)] = SampleStatus::missing;
    residual.status[residual.offset(6, 1)] = SampleStatus::suspect;
    residual.status[residual.offset(0, 3)] = SampleStatus::missing;

    const MemoryKernel kernel;
    const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel,
                                sigma);
    const Forecast ours = forecast(memory, later, answer_later);
    double log_evidence = 0;
    double chi_squared = 0;
    double values = 0;
    std::vector<Textbook> expected;
    for (std::size_t k = 0; k < levels; ++k) {
      TextbookLevel level;
      for (std::size_t t = 0; t < hour.size(); ++t) {
        if (!residual.has(t, k)) continue;
        const std::size_t o = residual.offset(t, k);
        level.hour.push_back(hour[t]);
        level.value.push_back(residual.value[o]);
        level.answer.push_back(answer[o]);
        level.sigma.push_back(sigma[o]);
      }
      std::vector<Horizontal> level_later;
      for (std::size_t t = 0; t < later.size(); ++t)
        level_later.push_back(answer_later[t * levels + k]);
      expected.push_back(textbook(faded(kernel, residual.levels_m[k]), level, later, level_later));
      log_evidence += expected.back().log_evidence;
      chi_squared += expected.back().chi_squared;
      values += static_cast<double>(level.hour.size());
    }
    const double w = kernel.surprise_weight;
    const double kappa_squared = (1 + w * chi_squared / values) / (1 + w);
    EXPECT_NEAR(memory.surprise(), std::sqrt(kappa_squared), 1e-9);
    EXPECT_NEAR(memory.log_evidence(), log_evidence, 1e-8 * std::abs(log_evidence));
    for (std::size_t k = 0; k < levels; ++k) {
      for (std::size_t t = 0; t < later.size(); ++t) {
        const auto i = static_cast<Eigen::Index>(t);
        // Condition 1e5 times rounding of values of 0.1.
        EXPECT_LT(std::abs(ours.mean[t * levels + k] - expected[k].mean(i)), 1e-11);
        EXPECT_NEAR(ours.variance[t * levels + k],
                    0.5 * kappa_squared * expected[k].covariance(i, i).real(), 1e-11);
      }
    }
  }
}

TEST(GaussianMemory, ARougherSeaWidensTheBandsAndLeavesTheMeanToItsAmplitude) {
  Rng random(8, "rough");
  VectorColumn calm = column(hourly(-23, 0), {5, 30});
  calm.value = random_vectors(48, 0.02, random);
  VectorColumn rough = calm;
  rough.value = times_factor(calm.value, 10.0);
  const std::vector<Horizontal> none(48);
  const GaussianMemory of_calm(calm, none, end_of_day, damping_per_h, coriolis_rad_h);
  const GaussianMemory of_rough(rough, none, end_of_day, damping_per_h, coriolis_rad_h);
  EXPECT_GT(of_rough.surprise(), 3 * of_calm.surprise());
  const Forecast ours_calm = forecast(of_calm, {12}, std::vector<Horizontal>(2));
  const Forecast ours_rough = forecast(of_rough, {12}, std::vector<Horizontal>(2));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(std::abs(ours_rough.mean[k] - 10.0 * ours_calm.mean[k]), 1e-12);
    EXPECT_NEAR(ours_rough.variance[k] / ours_calm.variance[k],
                std::pow(of_rough.surprise() / of_calm.surprise(), 2), 1e-9);
  }
}

TEST(GaussianMemory, WithoutValuesThePriorIsLeft) {
  VectorColumn residual = column({-6, 0}, {5, 50});
  residual.status.assign(4, SampleStatus::missing);
  const MemoryKernel kernel;
  const GaussianMemory memory(residual, std::vector<Horizontal>(4), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const std::vector<Horizontal> answer{{0.1, 0}, {0, 0.3}};
  const Forecast ours = forecast(memory, {12}, answer);
  const double prior =
      MemoryCovariance(kernel, 1, 0).variance_m2_s2() + kernel.noise_m_s * kernel.noise_m_s;
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_FALSE(memory.has(k));
    EXPECT_EQ(ours.mean[k], Horizontal{});
    const double share = kernel.own_share * kernel.own_share * std::norm(answer[k]);
    const double amplitude = kernel.amplitude_at(residual.levels_m[k]);
    EXPECT_NEAR(ours.variance[k], 0.5 * (amplitude * amplitude * prior + share), 1e-15);
  }
  EXPECT_FALSE(memory.at_depth(10).has_value());
  EXPECT_EQ(memory.log_evidence(), 0.0);
  EXPECT_EQ(memory.surprise(), 1.0);
}

TEST(GaussianMemory, LongAfterTheDayOnlyTheConstantIsRemembered) {
  Rng random(7, "long after");
  VectorColumn residual = column(hourly(-24, 0), {5});
  residual.value = random_vectors(25, 0.2, random);
  MemoryKernel kernel = plain();
  kernel.constant_m_s = 0;
  const std::vector<Horizontal> none(25);
  const GaussianMemory memory(residual, none, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {2e4}, {Horizontal{}});
  EXPECT_LT(std::abs(ours.mean[0]), 1e-12);
  const double prior =
      MemoryCovariance(kernel, 1, 0).variance_m2_s2() + kernel.noise_m_s * kernel.noise_m_s;
  EXPECT_NEAR(ours.variance[0], 0.5 * prior, 1e-12);
}

TEST(GaussianMemory, InertialMotionIsCarriedWithItsRotationAndDamping) {
  MemoryKernel kernel = only_inertial();
  kernel.noise_m_s = 1e-7;
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5});
  const Horizontal lambda(damping_per_h, coriolis_rad_h);
  const Horizontal amplitude(0.08, -0.03);
  for (std::size_t t = 0; t < residual.times(); ++t)
    residual.value[t] = amplitude * std::exp(-lambda * (6.0 * static_cast<double>(t) - 24.0));
  const GaussianMemory memory(residual, std::vector<Horizontal>(5), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const std::vector<double> later{1, 7.5, 24, 72};
  const Forecast ours = forecast(memory, later, std::vector<Horizontal>(4));
  for (std::size_t t = 0; t < later.size(); ++t) {
    // Noise of 1e-6 of the motion.
    EXPECT_LT(std::abs(ours.mean[t] - amplitude * std::exp(-lambda * later[t])), 1e-9);
    const double unknown = 1 - std::exp(-2 * damping_per_h * later[t]);
    EXPECT_NEAR(ours.variance[t], 0.5 * kernel.inertial_m_s * kernel.inertial_m_s * unknown, 1e-9);
  }
}

TEST(GaussianMemory, AConstantStaysConstantWhereNothingIsBelievedOfIt) {
  MemoryKernel kernel;
  kernel.constant_m_s = 1e3;  // as good as unknown: the regression is then unbiased
  VectorColumn residual = column(hourly(-23, 0), {5});
  const Horizontal constant(0.31, -0.12);
  residual.value.assign(24, constant);
  const GaussianMemory memory(residual, std::vector<Horizontal>(24), end_of_day, damping_per_h,
                              coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {1, 12, 72}, std::vector<Horizontal>(3));
  for (const Horizontal mean : ours.mean) EXPECT_LT(std::abs(mean - constant), 1e-6);
}

TEST(GaussianMemory, ALevelLearnsItsOwnShareOfTheWindsAnswer) {
  MemoryKernel kernel;
  kernel.noise_m_s = 1e-5;
  kernel.constant_m_s = kernel.slow_m_s = kernel.inertial_m_s = kernel.recent_m_s = 1e-6;
  Rng random(3, "own share");
  VectorColumn residual = column(hourly(-23, 0), {5});
  const std::vector<Horizontal> answer = random_vectors(24, 0.1, random);
  const Horizontal share(-0.2, 0.1);  // weaker, and turned to the left
  residual.value = times_factor(answer, share);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const Horizontal later(0.3, 0.2);
  const Forecast ours = forecast(memory, {10}, {later});
  EXPECT_LT(std::abs(ours.mean[0] - share * later), 1e-6);
}

TEST(GaussianMemory, TurningTheValuesTurnsTheMeanAndLeavesTheVariance) {
  Rng random(4, "turn");
  VectorColumn residual = column(hourly(-23, 0), {5, 30});
  residual.value = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer_later = random_vectors(6, 0.1, random);
  const Horizontal turn = std::polar(1.0, 2.1);
  const auto forecast_of = [&](const VectorColumn& values, Horizontal wind_turn) {
    return forecast(GaussianMemory(values, times_factor(answer, wind_turn), end_of_day,
                                   damping_per_h, coriolis_rad_h),
                    {1, 9, 40}, times_factor(answer_later, wind_turn));
  };
  const Forecast plain = forecast_of(residual, 1.0);
  VectorColumn turned = residual;
  turned.value = times_factor(residual.value, turn);
  // Condition 3e5 times rounding of values of 0.1, in all comparisons of whole regressions.
  // The share is complex: how the wind's answer itself is turned does not matter.
  for (const Horizontal wind_turn : {turn, Horizontal(1.0)}) {
    const Forecast ours = forecast_of(turned, wind_turn);
    for (std::size_t o = 0; o < 6; ++o) {
      EXPECT_LT(std::abs(ours.mean[o] - turn * plain.mean[o]), 1e-11);
      EXPECT_NEAR(ours.variance[o], plain.variance[o], 1e-12);
    }
  }
}

TEST(GaussianMemory, MirrorsInTheSouthernHemisphere) {
  Rng random(5, "south");
  VectorColumn north = column(hourly(-23, 0), {5, 30});
  north.value = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer = random_vectors(48, 0.1, random);
  const std::vector<Horizontal> answer_later = random_vectors(6, 0.1, random);
  VectorColumn south = north;
  south.value = conjugates(north.value);
  const std::vector<double> later{1, 9, 40};
  const Forecast in_north =
      forecast(GaussianMemory(north, answer, end_of_day, damping_per_h, coriolis_rad_h), later,
               answer_later);
  const Forecast in_south = forecast(
      GaussianMemory(south, conjugates(answer), end_of_day, damping_per_h, -coriolis_rad_h), later,
      conjugates(answer_later));
  for (std::size_t o = 0; o < 6; ++o) {
    EXPECT_LT(std::abs(in_south.mean[o] - std::conj(in_north.mean[o])), 1e-11);
    EXPECT_NEAR(in_south.variance[o], in_north.variance[o], 1e-12);
  }
}

/// Three days of daily means of one level, each of this value.
VectorColumn daily_means(Horizontal value) {
  VectorColumn residual = column({0, 0, 0}, {5});
  for (int d = 0; d < 3; ++d)
    residual.time[static_cast<std::size_t>(d)] = {lead(24.0 * (d - 3)), lead(24.0 * (d - 2))};
  residual.value.assign(3, value);
  return residual;
}

TEST(GaussianMemory, DailyMeansKnowTheConstant) {
  MemoryKernel kernel;
  kernel.constant_m_s = 1e3;
  const Horizontal constant(0.2, 0.1);
  const GaussianMemory memory(daily_means(constant), std::vector<Horizontal>(3), end_of_day,
                              damping_per_h, coriolis_rad_h, kernel);
  const Forecast ours = forecast(memory, {12}, {Horizontal{}});
  EXPECT_LT(std::abs(ours.mean[0] - constant), 1e-6);
}

TEST(GaussianMemory, DailyMeansKnowNothingOfAnInertialMotionOfADay) {
  // At 30 degrees of latitude the period is the day: whatever the means are, they are not this.
  const double period_of_a_day_rad_h = 2 * std::acos(-1.0) / 24;
  const MemoryKernel kernel = only_inertial();
  const GaussianMemory memory(daily_means({0.2, 0.1}), std::vector<Horizontal>(3), end_of_day, 1e-8,
                              period_of_a_day_rad_h, kernel);
  const Forecast ours = forecast(memory, {12}, {Horizontal{}});
  // Damping leaves 1e-7 of the motion's variance in the mean of a day, which is 400 times the
  // noise's: values of 0.2 weigh 1e-5.
  EXPECT_LT(std::abs(ours.mean[0]), 1e-4);
  const double prior =
      kernel.inertial_m_s * kernel.inertial_m_s + kernel.noise_m_s * kernel.noise_m_s;
  EXPECT_NEAR(ours.variance[0], 0.5 * prior, 1e-3 * prior);
}

}  // namespace
}  // namespace slackwater::calibration::gaussian_memory_test
