#include "fields/wind/dryden_gust.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater {
namespace {

constexpr double metres_per_foot = 0.3048;
constexpr double root_2 = 1.4142135623730951;
constexpr double root_3 = 1.7320508075688772;

/// e^x less the first n terms of its series, without the cancellation of small x.
double exponential_remainder(double x, int n) noexcept {
  double term = 1;
  for (int k = 1; k <= n; ++k) term *= x / k;
  double total = 0;
  for (int k = n + 1; term > 1e-18 * total; ++k) {
    total += term;
    term *= x / k;
  }
  return total;
}

/// With unit variance of x1 the stationary pair has cov(x1, x2) = var(x2) = 1/2, and
/// sqrt(3) x1 + (1 - sqrt(3)) x2 has the variance 2.
double transverse(const double (&x)[2]) noexcept {
  return (root_3 * x[0] + (1 - root_3) * x[1]) / root_2;
}

}  // namespace

DrydenTurbulence dryden_turbulence(double height_m, double wind_at_20_ft_m_s) noexcept {
  const double height_ft = std::clamp(height_m / metres_per_foot, 10.0, 1000.0);
  const double base = 0.177 + 0.000823 * height_ft;
  DrydenTurbulence out;
  out.sigma_vertical_m_s = 0.1 * wind_at_20_ft_m_s;
  out.sigma_horizontal_m_s = out.sigma_vertical_m_s / std::pow(base, 0.4);
  out.length_vertical_m = height_ft * metres_per_foot;
  out.length_horizontal_m = height_ft * metres_per_foot / std::pow(base, 1.2);
  return out;
}

DrydenFilter::Pair DrydenFilter::exact_pair(double h) noexcept {
  // Noise covariance Q = P - F P F^T of the stationary covariance P = [1, 1/2; 1/2, 1/2] under the
  // step F = e^(-h) [1, 0; h, 1]; written with series remainders because Q22 is of order h^3.
  const double e2 = std::exp(-2 * h);
  double q11 = 1;
  double q21 = 0.5;
  double q22 = 0.5;
  if (h < 5) {
    q11 = e2 * exponential_remainder(2 * h, 1);
    q21 = 0.5 * e2 * exponential_remainder(2 * h, 2);
    q22 = 0.5 * e2 * exponential_remainder(2 * h, 3);
  } else {
    q11 -= e2;
    q21 -= e2 * (0.5 + h);
    q22 -= e2 * (0.5 + h + h * h);
  }
  Pair out{};
  out.decay = std::exp(-h);
  out.coupling = h * out.decay;
  out.noise[0] = std::sqrt(q11);
  out.noise[1] = q21 / out.noise[0];
  out.noise[2] = std::sqrt(std::max(0.0, q22 - out.noise[1] * out.noise[1]));
  return out;
}

DrydenFilter::DrydenFilter(const DrydenTurbulence& turbulence, double airspeed_m_s, double step_s)
    : sigma_horizontal_m_s_(turbulence.sigma_horizontal_m_s),
      sigma_vertical_m_s_(turbulence.sigma_vertical_m_s),
      horizontal_(exact_pair(step_s * airspeed_m_s / turbulence.length_horizontal_m)),
      vertical_(exact_pair(step_s * airspeed_m_s / turbulence.length_vertical_m)) {
  expects(airspeed_m_s > 0 && std::isfinite(airspeed_m_s), "the airspeed must be above zero");
  expects(step_s > 0 && std::isfinite(step_s), "the step must be above zero");
  expects(turbulence.length_horizontal_m > 0 && turbulence.length_vertical_m > 0,
          "length scales must be above zero");
  expects(turbulence.sigma_horizontal_m_s >= 0 && turbulence.sigma_vertical_m_s >= 0,
          "standard deviations are 0 or more");
}

void DrydenFilter::advance(const Pair& pair, double (&x)[2], Rng& rng) noexcept {
  const double n1 = rng.normal();
  const double n2 = rng.normal();
  const double before = x[0];
  x[0] = pair.decay * before + pair.noise[0] * n1;
  x[1] = pair.coupling * before + pair.decay * x[1] + pair.noise[1] * n1 + pair.noise[2] * n2;
}

DrydenFilter::State DrydenFilter::stationary_state(Rng& rng) const noexcept {
  const auto draw = [&rng](double(&x)[2]) {
    x[0] = rng.normal();
    x[1] = 0.5 * x[0] + 0.5 * rng.normal();
  };
  State state;
  state.along = rng.normal();
  draw(state.across);
  draw(state.up);
  return state;
}

Gust DrydenFilter::gust(const State& state) const noexcept {
  return {sigma_horizontal_m_s_ * state.along, sigma_horizontal_m_s_ * transverse(state.across),
          sigma_vertical_m_s_ * transverse(state.up)};
}

Gust DrydenFilter::step(State& state, Rng& rng) const noexcept {
  state.along = horizontal_.decay * state.along + horizontal_.noise[0] * rng.normal();
  advance(horizontal_, state.across, rng);
  advance(vertical_, state.up, rng);
  return gust(state);
}

double DrydenFilter::autocovariance_m2_s2(GustAxis axis, int steps) const noexcept {
  const bool is_up = axis == GustAxis::up;
  const double sigma = is_up ? sigma_vertical_m_s_ : sigma_horizontal_m_s_;
  const Pair& pair = is_up ? vertical_ : horizontal_;
  if (axis == GustAxis::along) {
    const double kept = pair.noise[0] * pair.noise[0] / (1 - pair.decay * pair.decay);
    return sigma * sigma * kept * std::pow(pair.decay, steps);
  }
  // The covariance P that the steps themselves keep, P = F P F^T + Q, ...
  const double q21 = pair.noise[0] * pair.noise[1];
  const double q22 = pair.noise[1] * pair.noise[1] + pair.noise[2] * pair.noise[2];
  const double lost = 1 - pair.decay * pair.decay;
  const double p11 = pair.noise[0] * pair.noise[0] / lost;
  const double p21 = (q21 + pair.decay * pair.coupling * p11) / lost;
  const double p22 =
      (q22 + 2 * pair.decay * pair.coupling * p21 + pair.coupling * pair.coupling * p11) / lost;
  // ... seen by the output and carried forward: c F^n P c^T.
  double with[2] = {(root_3 * p11 + (1 - root_3) * p21) / root_2,
                    (root_3 * p21 + (1 - root_3) * p22) / root_2};
  for (int i = 0; i < steps; ++i) {
    with[1] = pair.coupling * with[0] + pair.decay * with[1];
    with[0] *= pair.decay;
  }
  return sigma * sigma * transverse(with);
}

}  // namespace slackwater
