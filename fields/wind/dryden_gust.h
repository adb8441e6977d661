#pragma once
#include "fields/base/numbers/random.h"
#include "fields/wind/gust.h"

namespace slackwater {

/// Dryden turbulence near the surface (MIL-F-8785C, 3.7.3.4: below 1000 ft), the usual disturbance
/// of small aircraft:
///
///   sigma_w = 0.1 W20,  sigma_u = sigma_v = sigma_w / (0.177 + 0.000823 h)^0.4
///   L_w = h,            L_u = L_v = h / (0.177 + 0.000823 h)^1.2          h in feet
///
/// with W20 the wind at 20 ft (6.1 m). Heights are held within 10 to 1000 ft, where this holds.
struct DrydenTurbulence {
  double sigma_horizontal_m_s = 0;
  double sigma_vertical_m_s = 0;
  double length_horizontal_m = 1;
  double length_vertical_m = 1;
  bool operator==(const DrydenTurbulence&) const = default;
};
[[nodiscard]] DrydenTurbulence dryden_turbulence(double height_m,
                                                 double wind_at_20_ft_m_s) noexcept;

/// The Dryden shaping filters, stepped exactly: white noise through
///
///   along:       sigma sqrt(2 L/(pi V)) / (1 + L s/V)
///   across, up:  sigma sqrt(L/(pi V)) (1 + sqrt(3) L s/V) / (1 + L s/V)^2
///
/// The state advances by the matrix exponential of the step and noise with the covariance that the
/// exact step demands, so the gusts at the steps have the autocovariance of the continuous process
/// for any step, coarse or fine: sigma^2 e^(-t/T) along and sigma^2 (1 - t/2T) e^(-t/T) across and
/// up, T = L/V. Description apart from state: one filter drives many vehicles.
class DrydenFilter {
 public:
  /// Two states of each transverse filter and one of the other, in standard deviations.
  struct State {
    double along = 0;
    double across[2] = {0, 0};
    double up[2] = {0, 0};
  };

  /// @param airspeed_m_s  V > 0, at which the frozen field is flown through (a hovering vehicle:
  ///                      the mean wind)
  /// @param step_s        > 0
  DrydenFilter(const DrydenTurbulence& turbulence, double airspeed_m_s, double step_s);

  /// A state drawn from the stationary distribution, so that a series has no run-up.
  [[nodiscard]] State stationary_state(Rng& rng) const noexcept;
  /// Advances by one step and returns the gust there. No allocation.
  [[nodiscard]] Gust step(State& state, Rng& rng) const noexcept;
  /// The gust that a state stands for, m/s.
  [[nodiscard]] Gust gust(const State& state) const noexcept;
  /// The autocovariance of an axis after so many steps, m2/s2, computed from the matrices of the
  /// step: transition and noise.
  [[nodiscard]] double autocovariance_m2_s2(GustAxis axis, int steps) const noexcept;

 private:
  /// Exact step of the pair x1' = (-x1 + noise)/T, x2' = (x1 - x2)/T.
  struct Pair {
    double decay;     ///< e^(-h), h = step/T
    double coupling;  ///< h e^(-h): what x2 receives of x1
    double noise[3];  ///< lower triangle of the square root of the noise covariance: 11, 21, 22
  };
  static Pair exact_pair(double steps_per_time) noexcept;
  static void advance(const Pair& pair, double (&x)[2], Rng& rng) noexcept;

  double sigma_horizontal_m_s_;
  double sigma_vertical_m_s_;
  Pair horizontal_;
  Pair vertical_;
};

}  // namespace slackwater
