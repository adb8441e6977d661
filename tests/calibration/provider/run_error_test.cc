#include "calibration/provider/run_error.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "calibration/propagate/memory_kernel.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::run_error_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr double f_rad_h = 0.42;

/// Hours before and after the end of D of one run that began `age_h` before it.
std::vector<RunMoment> moments(std::size_t run, double age_h, double from_h, double to_h,
                               double step_h) {
  std::vector<RunMoment> found;
  for (double h = from_h; h <= to_h; h += step_h)
    found.push_back({h, run, std::max(0.0, h + age_h)});
  return found;
}

MatrixXcd same(const std::vector<RunMoment>& at, Horizontal value, Index levels = 1) {
  return MatrixXcd::Constant(static_cast<Index>(at.size()), levels, value);
}

TEST(RunError, ABiasThatLastsIsCarriedOn) {
  const auto seen = moments(0, 72, -70, -2, 4);
  const RunError error({0}, seen, same(seen, {0.1, -0.05}), f_rad_h);
  const auto expected = error.at(moments(0, 72, 1, 13, 6));
  for (Index t = 0; t < 3; ++t)
    EXPECT_LT(std::abs(expected.error_m_s(t, 0) - Horizontal(0.1, -0.05)), 0.02);
  EXPECT_LT(std::sqrt(expected.variance_m2_s2(0, 0)), 0.03);
}

TEST(RunError, ARunThatWasNeverWrongIsBelieved) {
  const auto seen = moments(0, 72, -70, -2, 4);
  const RunError error({0}, seen, same(seen, 0.0), f_rad_h);
  const auto expected = error.at(moments(0, 72, 1, 49, 24));
  for (Index t = 0; t < 3; ++t) {
    EXPECT_LT(std::abs(expected.error_m_s(t, 0)), 1e-9);
    EXPECT_LT(std::sqrt(expected.variance_m2_s2(t, 0)), 0.01);
  }
}

TEST(RunError, OfNothingSeenIsThePrior) {
  RunErrorKernel kernel;
  kernel.sizes_m_s = {0.1};
  const RunError error({0}, {}, MatrixXcd(0, 1), f_rad_h, kernel);
  const auto expected = error.at(std::vector<RunMoment>{{0, 0, 0}, {1000, 0, 1000}});
  const double noise = kernel.noise_m_s * kernel.noise_m_s;
  EXPECT_EQ(expected.error_m_s(0, 0), Horizontal{});
  EXPECT_NEAR(expected.variance_m2_s2(0, 0), 0.5 * (0.01 + noise), 1e-12)
      << "at its reference time a run has gathered nothing";
  EXPECT_NEAR(expected.variance_m2_s2(1, 0), 0.5 * (0.02 + noise), 1e-12);
}

TEST(RunError, ErrorsThatEachRunGathersAnewAreNotCarriedToTheNext) {
  // Four old runs, each wrong another way and more the longer it runs.
  std::vector<RunMoment> seen;
  std::vector<Horizontal> values;
  for (std::size_t run = 1; run <= 3; ++run) {
    for (const RunMoment& at : moments(run, 24.0 * static_cast<double>(run),
                                       -24.0 * static_cast<double>(run) + 3, -1, 4)) {
      seen.push_back(at);
      values.push_back(std::polar(0.15 * (1 - std::exp(-at.lead_h / 24)), 2.1 * double(run)));
    }
  }
  const MatrixXcd error = Eigen::Map<MatrixXcd>(values.data(), Index(values.size()), 1);
  const auto expected = RunError({0}, seen, error, f_rad_h).at(moments(0, 0, 1, 25, 12));
  for (Index t = 0; t < 3; ++t) EXPECT_LT(std::abs(expected.error_m_s(t, 0)), 0.06);
  EXPECT_GT(expected.variance_m2_s2(2, 0), 2 * expected.variance_m2_s2(0, 0));
}

TEST(RunError, IsTheRegressionOfTheTextbook) {
  RunErrorKernel kernel;
  kernel.sizes_m_s = {0.08};
  auto seen = moments(0, 30, -28, -1, 5);
  for (const RunMoment& at : moments(1, 54, -50, -3, 9)) seen.push_back(at);
  Rng random(3, "tests/run_error/textbook");
  MatrixXcd values(Index(seen.size()), 1);
  for (Index i = 0; i < values.rows(); ++i)
    values(i, 0) = 0.1 * Horizontal(random.normal(), random.normal());
  const auto later = moments(0, 30, 2, 40, 19);
  const auto covariance = [&](const RunMoment& a, const RunMoment& b) {
    const double d = a.hour - b.hour;
    const double s2 = 0.08 * 0.08;
    Horizontal k = 0.6 * s2 * std::exp(-std::abs(d) / 120);
    k += 0.2 * s2 * std::exp(-std::abs(d) / 96) *
         Horizontal(std::cos(f_rad_h * d), -std::sin(f_rad_h * d));
    k += 0.1 * s2 * std::exp(-std::abs(d) / 120) *
         (std::cos(2 * std::numbers::pi * d / 12.4206012) +
          std::cos(2 * std::numbers::pi * d / 23.9344696));
    if (a.run == b.run)
      k += s2 * (std::exp(-std::abs(d) / 48) - std::exp(-(a.lead_h + b.lead_h) / 48));
    return k;
  };
  MatrixXcd k(values.rows(), values.rows());
  MatrixXcd across(Index(later.size()), values.rows());
  for (Index i = 0; i < k.rows(); ++i) {
    for (Index j = 0; j < k.cols(); ++j)
      k(i, j) =
          covariance(seen[std::size_t(i)], seen[std::size_t(j)]) + (i == j ? 0.004 * 0.004 : 0);
    for (Index t = 0; t < across.rows(); ++t)
      across(t, i) = covariance(later[std::size_t(t)], seen[std::size_t(i)]);
  }
  const MatrixXcd inverse = k.inverse();
  const MatrixXcd mean = across * inverse * values;
  const auto expected = RunError({0}, seen, values, f_rad_h, kernel).at(later);
  for (Index t = 0; t < mean.rows(); ++t) {
    EXPECT_LT(std::abs(expected.error_m_s(t, 0) - mean(t, 0)), 1e-9);
    const double own =
        covariance(later[std::size_t(t)], later[std::size_t(t)]).real() + 0.004 * 0.004;
    const double left = own - (across.row(t) * inverse * across.row(t).adjoint())(0, 0).real();
    EXPECT_NEAR(expected.variance_m2_s2(t, 0), 0.5 * left, 1e-9);
  }
}

TEST(RunError, TurningTheErrorsTurnsWhatIsExpected) {
  const auto seen = moments(0, 40, -38, -2, 3);
  Rng random(5, "tests/run_error/turn");
  MatrixXcd values(Index(seen.size()), 2);
  for (Index i = 0; i < values.size(); ++i)
    values.data()[i] = 0.1 * Horizontal(random.normal(), random.normal());
  const Horizontal by = std::polar(1.0, 0.7);
  const auto later = moments(0, 40, 1, 30, 7);
  const auto one = RunError({0, 10}, seen, values, f_rad_h).at(later);
  const auto turned = RunError({0, 10}, seen, by * values, f_rad_h).at(later);
  EXPECT_LT((turned.error_m_s - by * one.error_m_s).norm(), 1e-12);
  EXPECT_LT((turned.variance_m2_s2 - one.variance_m2_s2).norm(), 1e-12);
}

TEST(RunError, ALevelWithoutValuesHasTheErrorOfNothingSeen) {
  const auto seen = moments(0, 72, -70, -2, 4);
  MatrixXcd values = same(seen, {0.1, 0}, 2);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  values.col(1).setConstant(Horizontal(nan, nan));
  const auto expected = RunError({0, 5}, seen, values, f_rad_h).at(moments(0, 72, 1, 1, 1));
  EXPECT_GT(expected.error_m_s(0, 0).real(), 0.08);
  EXPECT_EQ(expected.error_m_s(0, 1), Horizontal{});
  EXPECT_GT(expected.variance_m2_s2(0, 1), expected.variance_m2_s2(0, 0));
}

}  // namespace
}  // namespace slackwater::calibration::run_error_test
