#include "fields/wave/spreading.h"

#include <math.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater {
namespace {

using constants::pi;

void expect_spreading(double s) {
  expects(s >= 0 && std::isfinite(s), "the spreading exponent s must not be negative");
}

/// std::lgamma writes the global `signgam`, which threads would share.
double log_gamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

}  // namespace

double spreading_density(double s, double from_mean_rad) {
  expect_spreading(s);
  // By the duplication formula the norm is Gamma(s+1)/(2 sqrt(pi) Gamma(s+1/2)); logarithms,
  // because Gamma leaves the range of a double from s = 170 on.
  const double norm = std::exp(log_gamma(s + 1.0) - log_gamma(s + 0.5)) / (2.0 * std::sqrt(pi));
  return norm * std::pow(std::abs(std::cos(0.5 * from_mean_rad)), 2.0 * s);
}

double spreading_first_moment(double s) {
  expect_spreading(s);
  return s / (s + 1.0);
}

double spreading_second_moment(double s) {
  expect_spreading(s);
  return s * (s - 1.0) / ((s + 1.0) * (s + 2.0));
}

double circular_spread_rad(double s) {
  expect_spreading(s);
  return std::sqrt(2.0 / (s + 1.0));
}

double spreading_quantile_rad(double s, double probability) {
  expects(probability >= 0 && probability <= 1, "a probability lies in [0, 1]");
  constexpr std::size_t cells = 512;
  const double half_width = std::min(pi, 8.0 * circular_spread_rad(s));
  const double step = 2.0 * half_width / static_cast<double>(cells);
  // The norm cancels, so that one power per cell, at its middle, is enough.
  std::array<double, cells + 1> below{};
  for (std::size_t i = 0; i < cells; ++i) {
    const double theta = -half_width + (static_cast<double>(i) + 0.5) * step;
    below[i + 1] = below[i] + std::pow(std::cos(0.5 * theta), 2.0 * s);
  }
  const double wanted = probability * below[cells];
  const auto after = std::lower_bound(below.begin() + 1, below.end() - 1, wanted);
  const auto cell = static_cast<std::size_t>(after - below.begin()) - 1;
  const double mass = below[cell + 1] - below[cell];
  const double share = mass > 0 ? (wanted - below[cell]) / mass : 0.5;
  return -half_width + (static_cast<double>(cell) + std::clamp(share, 0.0, 1.0)) * step;
}

}  // namespace slackwater
