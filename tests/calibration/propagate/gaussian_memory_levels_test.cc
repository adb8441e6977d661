#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "tests/calibration/propagate/memory_textbook.h"

namespace slackwater::calibration::gaussian_memory_levels_test {
namespace {

TEST(GaussianMemory, ALevelWithoutValuesIsBetweenItsNeighboursAndHeldBeyondThem) {
  Rng random(6, "levels");
  VectorColumn residual = column(hourly(-23, 0), {0, 10, 20, 40, 80});
  residual.value = random_vectors(residual.value.size(), 0.1, random);
  for (std::size_t t = 0; t < residual.times(); ++t) {
    for (const std::size_t k : {0U, 2U, 4U})
      residual.status[residual.offset(t, k)] = SampleStatus::missing;
  }
  const std::vector<Horizontal> answer = random_vectors(residual.value.size(), 0.1, random);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h);
  const Forecast ours = forecast(memory, {6}, random_vectors(5, 0.1, random));
  for (const std::size_t k : {0U, 2U, 4U}) EXPECT_FALSE(memory.has(k));
  EXPECT_TRUE(memory.has(1));
  EXPECT_EQ(ours.mean[0], ours.mean[1]);
  EXPECT_EQ(ours.mean[4], ours.mean[3]);
  EXPECT_LT(std::abs(ours.mean[2] - (2.0 * ours.mean[1] + ours.mean[3]) / 3.0), 1e-15);
  EXPECT_NEAR(ours.variance[2], (2.0 * ours.variance[1] + ours.variance[3]) / 3.0, 1e-15);
  const LevelMix mix = *memory.at_depth(30);
  EXPECT_EQ(mix.above, 1U);
  EXPECT_EQ(mix.below, 3U);
  EXPECT_NEAR(mix.share_below, 2.0 / 3.0, 1e-15);
}

TEST(GaussianMemory, AColumnWithoutADepthAxisIsOneLevel) {
  VectorColumn residual = column(hourly(-23, 0), {0});
  residual.levels_m.clear();
  residual.value.assign(24, {0.1, 0.0});
  const GaussianMemory memory(residual, std::vector<Horizontal>(24), end_of_day, damping_per_h,
                              coriolis_rad_h);
  EXPECT_EQ(memory.levels(), 1U);
  EXPECT_TRUE(memory.has(0));
  EXPECT_NEAR(forecast(memory, {1}, {Horizontal{}}).mean[0].real(), 0.1, 0.01);
}

TEST(GaussianMemory, TenMinutesSayWhatTheirHoursSay) {
  const auto motion = [](double hour) {
    return Horizontal(0.2, 0.1) + 0.1 * std::exp(-i_unit * coriolis_rad_h * hour);
  };
  std::vector<double> fine;
  for (int i = -143; i <= 0; ++i) fine.push_back(i / 6.0);
  std::vector<double> coarse;
  for (int h = -23; h <= 0; ++h) coarse.push_back(h - 25.0 / 60);  // mean of -50 .. 0 minutes
  const auto later = [&](const std::vector<double>& hour) {
    VectorColumn residual = column(hour, {5});
    for (std::size_t t = 0; t < hour.size(); ++t) residual.value[t] = motion(hour[t]);
    return forecast(GaussianMemory(residual, std::vector<Horizontal>(hour.size()), end_of_day,
                                   damping_per_h, coriolis_rad_h, plain()),
                    {12}, {Horizontal{}});
  };
  // An inertial motion loses (0.39 x 50/60)^2/24 of its 0.1 m/s in the mean of an hour: 0.4 mm/s.
  EXPECT_LT(std::abs(later(fine).mean[0] - later(coarse).mean[0]), 5e-4);
  EXPECT_NEAR(later(fine).variance[0], later(coarse).variance[0], 1e-12);
}

TEST(GaussianMemory, RefusesArraysOfAnotherSizeAndAnswersThatAreNoNumbers) {
  const VectorColumn residual = column({-6, 0}, {5, 50});
  const std::vector<Horizontal> answer(4);
  EXPECT_THROW(GaussianMemory(residual, std::vector<Horizontal>(3), end_of_day, damping_per_h,
                              coriolis_rad_h),
               ContractViolation);
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h);
  const std::vector<UtcTime> later = times({1});
  std::vector<Horizontal> mean(2);
  std::vector<double> variance(2);
  std::vector<double> too_short(1);
  EXPECT_THROW(memory.predict(later, answer, mean, variance), ContractViolation);
  const std::vector<Horizontal> right(2);
  EXPECT_THROW(memory.predict(later, right, mean, too_short), ContractViolation);
  const std::vector<Horizontal> no_number{{std::nan(""), 0}, {}};
  EXPECT_THROW(memory.predict(later, no_number, mean, variance), ContractViolation);
  Rng random(1, "sizes");
  EXPECT_THROW(memory.sample(later, right, random, 3, mean), ContractViolation);
  EXPECT_THROW((void)memory.has(2), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::gaussian_memory_levels_test
