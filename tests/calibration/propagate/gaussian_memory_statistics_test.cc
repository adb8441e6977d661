#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "fields/base/check.h"
#include "tests/calibration/propagate/memory_textbook.h"

namespace slackwater::calibration::gaussian_memory_statistics_test {
namespace {

TEST(GaussianMemory, BandsHoldWhatTheyPromiseOnDataOfThePrior) {
  // Levels are independent draws of a day and one later hour from the prior of the textbook.
  const std::size_t draws = 3000;
  const std::vector<double> day = hourly(-23, 0);
  MemoryKernel kernel;
  kernel.deep_share = 1;  // the draws are levels
  Rng random(11, "prior");
  std::vector<double> depth_m;
  for (std::size_t k = 0; k < draws; ++k) depth_m.push_back(static_cast<double>(k));
  std::vector<double> all = day;
  all.push_back(15);
  const std::size_t n = all.size();
  VectorColumn residual = column(day, depth_m);
  std::vector<Horizontal> answer(residual.value.size());
  std::vector<Horizontal> answer_later(draws);
  std::vector<Horizontal> truth(draws);
  // One answer to the wind for all, so that one factor makes all draws.
  const std::vector<Horizontal> s = random_vectors(n, 0.15, random);
  Eigen::MatrixXcd joint(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      joint(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          textbook_kernel(kernel, all[i], all[j], s[i], s[j]);
  }
  joint.diagonal().array() += kernel.noise_m_s * kernel.noise_m_s;
  const Eigen::MatrixXcd factor = joint.llt().matrixL();
  for (std::size_t k = 0; k < draws; ++k) {
    const std::vector<Horizontal> white = random_vectors(n, std::sqrt(0.5), random);
    const Eigen::VectorXcd drawn =
        factor * Eigen::Map<const Eigen::VectorXcd>(white.data(), static_cast<Eigen::Index>(n));
    for (std::size_t t = 0; t < day.size(); ++t) {
      residual.value[residual.offset(t, k)] = drawn(static_cast<Eigen::Index>(t));
      answer[residual.offset(t, k)] = s[t];
    }
    answer_later[k] = s.back();
    truth[k] = drawn(static_cast<Eigen::Index>(n - 1));
  }
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  EXPECT_NEAR(memory.surprise(), 1.0, 0.01);
  const Forecast ours = forecast(memory, {15}, answer_later);
  double inside = 0;
  double squares = 0;
  for (std::size_t k = 0; k < draws; ++k) {
    const Horizontal error = truth[k] - ours.mean[k];
    const double sigma = std::sqrt(ours.variance[k]);
    inside +=
        (std::abs(error.real()) < 1.28155 * sigma) + (std::abs(error.imag()) < 1.28155 * sigma);
    squares += std::norm(error) / ours.variance[k];
  }
  // 6000 independent values: binomial sigma 0.0052, that of the mean square 0.018; 3.3 of each.
  const double values = 2.0 * static_cast<double>(draws);
  EXPECT_NEAR(inside / values, 0.8, 3.3 * std::sqrt(0.16 / values));
  EXPECT_NEAR(squares / values, 1.0, 3.3 * std::sqrt(2.0 / values));
}

/// Covariance over members of two places in the arrays of a member.
Horizontal covariance_over(const std::vector<Horizontal>& departures, std::size_t places,
                           std::size_t a, std::size_t b) {
  Horizontal sum{};
  for (std::size_t o = 0; o < departures.size(); o += places)
    sum += departures[o + a] * std::conj(departures[o + b]);
  return sum * static_cast<double>(places) / static_cast<double>(departures.size());
}

/// A column of three levels of which the second has a gap.
VectorColumn sampled_column(Rng& random) {
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5, 25, 60});
  residual.value = random_vectors(residual.value.size(), 0.1, random);
  residual.status[residual.offset(4, 1)] = SampleStatus::missing;
  return residual;
}

TEST(GaussianMemory, MembersHaveThePosteriorsCovarianceInTime) {
  Rng random(12, "members");
  const std::vector<double> later{0.5, 6, 24};
  const VectorColumn residual = sampled_column(random);
  const std::vector<Horizontal> answer = random_vectors(15, 0.2, random);
  const std::vector<Horizontal> answer_later = random_vectors(9, 0.4, random);
  const MemoryKernel kernel;
  const GaussianMemory memory(residual, answer, end_of_day, damping_per_h, coriolis_rad_h, kernel);
  const int members = 40000;
  std::vector<Horizontal> departures(9 * static_cast<std::size_t>(members));
  memory.sample(times(later), answer_later, random, members, departures);

  for (std::size_t k = 0; k < 3; ++k) {
    TextbookLevel level;
    for (std::size_t t = 0; t < 5; ++t) {
      if (!residual.has(t, k)) continue;
      level.hour.push_back(6.0 * static_cast<double>(t) - 24.0);
      level.value.push_back(residual.value[3 * t + k]);
      level.answer.push_back(answer[3 * t + k]);
    }
    Textbook expected = textbook(faded(kernel, residual.levels_m[k]), level, later,
                                 {answer_later[k], answer_later[3 + k], answer_later[6 + k]});
    expected.covariance *= memory.surprise() * memory.surprise();
    // A correlation of complex numbers over 40 000 members has sigma 0.005; 4 of them.
    for (std::size_t t = 0; t < 3; ++t) {
      const auto i = static_cast<Eigen::Index>(t);
      Horizontal mean{};
      for (std::size_t o = 3 * t + k; o < departures.size(); o += 9) mean += departures[o];
      EXPECT_LT(std::abs(mean) / members, 0.02 * std::sqrt(expected.covariance(i, i).real()));
      for (std::size_t u = 0; u < 3; ++u) {
        const auto j = static_cast<Eigen::Index>(u);
        const double scale =
            std::sqrt(expected.covariance(i, i).real() * expected.covariance(j, j).real());
        const Horizontal ours = covariance_over(departures, 9, 3 * t + k, 3 * u + k);
        EXPECT_LT(std::abs(ours - expected.covariance(i, j)), 0.02 * scale);
      }
    }
  }
}

TEST(GaussianMemory, DeparturesOfTwoLevelsForgetEachOtherWithTheirDistance) {
  Rng random(15, "depth");
  MemoryKernel kernel;
  kernel.vertical_scale_m = 30;
  // Not in the order of depth; all feel the same wind, so that nothing but the draw tells them
  // apart.
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {35, 5, 35.003});
  residual.value = random_vectors(15, 0.1, random);
  const GaussianMemory memory(residual, std::vector<Horizontal>(15, {0.1, 0.1}), end_of_day,
                              damping_per_h, coriolis_rad_h, kernel);
  const int members = 40000;
  std::vector<Horizontal> departures(6 * static_cast<std::size_t>(members));
  memory.sample(times({6, 24}), std::vector<Horizontal>(6, {0.3, -0.2}), random, members,
                departures);
  for (const std::size_t t : {0U, 3U}) {
    const auto correlation = [&](std::size_t a, std::size_t b) {
      const auto of = [&](std::size_t i, std::size_t j) {
        return covariance_over(departures, 6, t + i, t + j);
      };
      return of(a, b) / std::sqrt(of(a, a).real() * of(b, b).real());
    };
    // Sigma 0.005; 4 of them.
    EXPECT_LT(std::abs(correlation(0, 1) - std::exp(-1.0)), 0.02);
    EXPECT_GT(correlation(0, 2).real(), 0.999);
  }
}

TEST(GaussianMemory, MembersOfALevelWithoutValuesHaveItsVariance) {
  Rng random(13, "no values");
  VectorColumn residual = column({-24, -18, -12, -6, 0}, {5, 12, 35});
  residual.value = random_vectors(15, 0.1, random);
  for (std::size_t t = 0; t < 5; ++t)
    residual.status[residual.offset(t, 1)] = SampleStatus::missing;
  residual.status[residual.offset(4, 2)] = SampleStatus::missing;
  residual.status[residual.offset(3, 2)] = SampleStatus::missing;
  const std::vector<Horizontal> none(15);
  const GaussianMemory memory(residual, none, end_of_day, damping_per_h, coriolis_rad_h, plain());
  const std::vector<Horizontal> none_later(3);
  const Forecast ours = forecast(memory, {3}, none_later);
  ASSERT_GT(ours.variance[2], 1.2 * ours.variance[0]);
  const int members = 20000;
  std::vector<Horizontal> departures(3 * static_cast<std::size_t>(members));
  memory.sample(times({3}), none_later, random, members, departures);
  double squares = 0;
  for (std::size_t m = 0; m < static_cast<std::size_t>(members); ++m)
    squares += std::norm(departures[3 * m + 1]);
  // The mean square of 20 000 complex numbers has sigma 0.007.
  EXPECT_NEAR(squares / members / (2 * ours.variance[1]), 1.0, 0.03);
}

TEST(GaussianMemory, TheSameSeedDrawsTheSameMembers) {
  Rng random(14, "column");
  const VectorColumn residual = sampled_column(random);
  const GaussianMemory memory(residual, std::vector<Horizontal>(15), end_of_day, damping_per_h,
                              coriolis_rad_h);
  const auto drawn = [&](std::uint64_t seed, int members) {
    Rng stream(seed, "calibration/memory");
    std::vector<Horizontal> out(6 * static_cast<std::size_t>(members));
    memory.sample(times({1, 2}), std::vector<Horizontal>(6), stream, members, out);
    return out;
  };
  EXPECT_EQ(drawn(1, 5), drawn(1, 5));
  EXPECT_NE(drawn(1, 5), drawn(2, 5));
  const std::vector<Horizontal> more = drawn(1, 8);
  EXPECT_EQ(std::vector<Horizontal>(more.begin(), more.begin() + 30), drawn(1, 5));
}

}  // namespace
}  // namespace slackwater::calibration::gaussian_memory_statistics_test
