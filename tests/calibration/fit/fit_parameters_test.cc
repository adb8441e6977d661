// Fits with known answers: a line, whose covariance the textbook has; a decay with noise of known
// kinds, which lies within two standard deviations as often as it should; what data do not say.
#include "calibration/fit/fit_parameters.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>

#include "fields/base/numbers/random.h"
#include "tests/support/error_of.h"

namespace slackwater::calibration::fit_parameters_test {
namespace {

std::vector<ResidualPlace> one_series(std::size_t rows) {
  std::vector<ResidualPlace> place;
  for (std::size_t row = 0; row < rows; ++row) place.push_back({0, row});
  return place;
}

TEST(FitParameters, OfALineAreThoseOfTheTextbook) {
  constexpr std::size_t n = 60;
  Rng rng(7, "line");
  std::vector<double> x, y;
  for (std::size_t i = 0; i < n; ++i) {
    x.push_back(0.1 * static_cast<double>(i));
    y.push_back(2 - 0.7 * x.back() + 0.3 * rng.normal());
  }
  const ParameterFit fit =
      fit_parameters({{"intercept", 1, -10, 10}, {"slope", -1, -10, 10}}, one_series(n),
                     [&](std::span<const double> p, std::span<double> out) {
                       for (std::size_t i = 0; i < n; ++i) out[i] = p[0] + p[1] * x[i] - y[i];
                       return true;
                     });
  Eigen::MatrixXd design(n, 2);
  Eigen::VectorXd measured(n);
  for (std::size_t i = 0; i < n; ++i) {
    design.row(static_cast<Eigen::Index>(i)) << 1, x[i];
    measured(static_cast<Eigen::Index>(i)) = y[i];
  }
  const Eigen::Matrix2d inverse = (design.transpose() * design).inverse();
  const Eigen::Vector2d best = inverse * design.transpose() * measured;
  const double s2 = (design * best - measured).squaredNorm() / (n - 2);
  EXPECT_TRUE(fit.has_converged) << fit.ended;
  EXPECT_EQ(fit.effective_residuals, n) << "this noise is white";
  for (int i = 0; i < 2; ++i) {
    const FittedParameter& p = fit.parameters[static_cast<std::size_t>(i)];
    EXPECT_NEAR(p.value, best(i), 1e-7);
    EXPECT_NEAR(p.standard_deviation.value() / std::sqrt(s2 * inverse(i, i)), 1, 1e-7);
    EXPECT_TRUE(p.is_determined);
    EXPECT_EQ(p.ended_on, EndedOn::neither);
  }
  EXPECT_NEAR(fit.correlation(0, 1), inverse(0, 1) / std::sqrt(inverse(0, 0) * inverse(1, 1)),
              1e-7);
  EXPECT_NEAR(fit.rms_after, std::sqrt(s2 * (n - 2) / n), 1e-9);
  EXPECT_GT(fit.rms_before, fit.rms_after);
}

struct Noise {
  double size = 0;
  double correlation = 0;  ///< from row to row
  double in_common = 0;    ///< share of its variance that both series have
};

/// Of 200 draws, how many of two parameters are within two standard deviations of the truth.
double within_two(const Noise& noise) {
  constexpr std::size_t rows = 200, draws = 200;
  constexpr double size = 3, rate = 0.4;
  std::vector<ResidualPlace> place;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t series = 0; series < 2; ++series) place.push_back({series, row});
  const auto t = [](std::size_t row) { return 0.05 * static_cast<double>(row); };
  std::size_t within = 0;
  for (std::size_t draw = 0; draw < draws; ++draw) {
    Rng rng(draw, "decay");
    std::vector<double> y;
    double off[3] = {rng.normal(), rng.normal(), rng.normal()};
    for (std::size_t row = 0; row < rows; ++row) {
      for (double& one : off)
        one = noise.correlation * one +
              std::sqrt(1 - noise.correlation * noise.correlation) * rng.normal();
      for (int series = 0; series < 2; ++series) {
        const double e =
            std::sqrt(noise.in_common) * off[2] + std::sqrt(1 - noise.in_common) * off[series];
        // The second series is the slope of the first, and three times as noisy.
        const double truth = size * std::exp(-rate * t(row)) * (series == 0 ? 1 : rate);
        y.push_back(truth + noise.size * (series == 0 ? 1 : 3) * e);
      }
    }
    const ParameterFit fit = fit_parameters({{"size", 1, 0.3, 10}, {"rate", 1, 0.1, 10}}, place,
                                            [&](std::span<const double> p, std::span<double> out) {
                                              for (std::size_t row = 0; row < rows; ++row) {
                                                const double decayed =
                                                    p[0] * std::exp(-p[1] * t(row));
                                                out[2 * row] = decayed - y[2 * row];
                                                out[2 * row + 1] = decayed * p[1] - y[2 * row + 1];
                                              }
                                              return true;
                                            });
    const double truth[2] = {size, rate};
    for (std::size_t i = 0; i < 2; ++i) {
      const FittedParameter& p = fit.parameters[i];
      EXPECT_TRUE(p.is_determined);
      within += std::abs(p.value - truth[i]) <= 2 * p.standard_deviation.value() ? 1 : 0;
    }
  }
  const double share = static_cast<double>(within) / (2.0 * draws);
  std::printf("noise %g, correlation %g, in common %g: %.1f %% within two standard deviations\n",
              noise.size, noise.correlation, noise.in_common, 100 * share);
  return share;
}

/// 400 figures of 95 % are known to 1.1 %.
TEST(FitParameters, TheTruthIsWithinTwoDeviationsAsOftenAsItShould) {
  const double white = within_two({0.1, 0, 0});
  EXPECT_GT(white, 0.92);
  EXPECT_LT(white, 0.98);
}
TEST(FitParameters, AlsoWhereNoiseHasMemoryOrIsOfBothSeries) {
  // Slow parameters: the deviations are about right, and never far too small.
  EXPECT_GT(within_two({0.1, 0.8, 0}), 0.91);
  EXPECT_GT(within_two({0.1, 0.95, 0}), 0.91);
  const double in_common = within_two({0.1, 0, 0.9});
  EXPECT_GT(in_common, 0.92);
  EXPECT_LT(in_common, 0.98);
  EXPECT_GT(within_two({0.1, 0.8, 0.9}), 0.91);
}

TEST(FitParameters, MemoryIsThatOfAutoregressiveNoise) {
  for (const double c : {0.0, 0.5, 0.9}) {
    Rng rng(3, "memory");
    std::vector<double> noise;
    double now = rng.normal();
    for (int i = 0; i < 20000; ++i) {
      now = c * now + std::sqrt(1 - c * c) * rng.normal();
      noise.push_back(now);
    }
    EXPECT_NEAR(repeats_itself(noise) / ((1 + c) / (1 - c)), 1, 0.15) << c;
  }
  EXPECT_EQ(repeats_itself(std::vector<double>(50, 0.0)), 1);
  EXPECT_GT(repeats_itself(std::vector<double>(50, 1.0)), 25) << "a bias is one number";
}

TEST(FitParameters, WhatTheDataDoNotSayIsNamed) {
  constexpr std::size_t n = 40;
  Rng rng(1, "unsaid");
  std::vector<double> noise;
  for (std::size_t i = 0; i < n; ++i) noise.push_back(0.05 * rng.normal());
  const ParameterFit fit =
      fit_parameters({{"seen", 1, 0.1, 10},
                      {"nowhere", 2, 0.2, 20},
                      {"one", 1, 0.1, 10},
                      {"other", 1, 0.1, 10},
                      {"hardly", 1, 0.1, 10}},
                     one_series(n), [&](std::span<const double> p, std::span<double> out) {
                       for (std::size_t i = 0; i < n; ++i) {
                         const double x = static_cast<double>(i) / n;
                         out[i] = (p[0] - 2) * x + (p[2] + p[3] - 3) * std::sin(6 * x) +
                                  0.001 * (p[4] - 1.5) * std::cos(20 * x) + noise[i];
                       }
                       return true;
                     });
  const auto& p = fit.parameters;
  EXPECT_TRUE(p[0].is_determined);
  EXPECT_NEAR(p[0].value, 2, 0.1);
  EXPECT_FALSE(p[1].is_determined);
  EXPECT_FALSE(p[1].standard_deviation);
  EXPECT_EQ(p[1].value, 2) << "stays where it was";
  for (const std::size_t i : {2U, 3U}) {
    EXPECT_FALSE(p[i].is_determined) << "their sum alone is seen";
    EXPECT_FALSE(p[i].standard_deviation);
  }
  EXPECT_NEAR(p[2].value + p[3].value, 3, 0.1);
  EXPECT_FALSE(p[4].is_determined);
  for (Eigen::Index i = 0; i < 5; ++i)
    for (Eigen::Index j = 0; j < 5; ++j) EXPECT_TRUE(std::isfinite(fit.correlation(i, j)));
}

TEST(FitParameters, OneThatEndsOnItsBoundIsNamed) {
  Rng rng(1, "bound");
  std::vector<double> y;
  for (int i = 0; i < 50; ++i) y.push_back(5 + 0.1 * rng.normal());
  const ParameterFit fit = fit_parameters({{"level", 1, 0.1, 3}}, one_series(50),
                                          [&](std::span<const double> p, std::span<double> out) {
                                            for (std::size_t i = 0; i < 50; ++i)
                                              out[i] = p[0] - y[i];
                                            return true;
                                          });
  EXPECT_EQ(fit.parameters[0].value, 3);
  EXPECT_EQ(fit.parameters[0].ended_on, EndedOn::high);
}

TEST(FitParameters, GoesRoundWhatCannotBeComputedAndSaysSoAtTheStart) {
  const auto residuals = [](double most) {
    return [most](std::span<const double> p, std::span<double> out) {
      if (p[0] > most) return false;
      for (std::size_t i = 0; i < out.size(); ++i) {
        const double x = static_cast<double>(i) / 10;
        out[i] = std::exp(p[0] * x) - std::exp(2 * x);
      }
      return true;
    };
  };
  // The first step leads far beyond.
  const ParameterFit fit = fit_parameters({{"rate", 0.3, 0.03, 9}}, one_series(20), residuals(2.5));
  EXPECT_NEAR(fit.parameters[0].value, 2, 1e-6);
  EXPECT_NE(tests::error_of([&] {
              return fit_parameters({{"rate", 1, 0.1, 9}}, one_series(20), residuals(0.5));
            }).find("would start from"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::calibration::fit_parameters_test
