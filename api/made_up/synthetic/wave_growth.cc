#include "api/made_up/synthetic/wave_growth.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr double step_h = 1.0 / 6;
constexpr double growth_time_h = 5;
constexpr double tm02_over_peak = 0.7775;  ///< JONSWAP with gamma 3.3, physics section 8
constexpr double g = constants::gravity_m_s2;

struct GrownSea {
  double height_m;
  double peak_period_s;
};

/// What the wind would raise if it blew on: dimensionless growth with fetch, never beyond the grown
/// sea.
GrownSea fetch_limited(Horizontal wind_m_s) noexcept {
  const double speed = std::abs(wind_m_s);
  const double from_rad = from_direction_deg(wind_m_s) * constants::pi / 180;
  const double fetch_m = 90e3 + 70e3 * std::cos(from_rad);
  const double fetch = g * fetch_m / (speed * speed);
  return {std::min(0.0016 * std::sqrt(fetch), 0.21) * speed * speed / g,
          std::min(0.286 * std::cbrt(fetch), 2 * constants::pi / 0.877) * speed / g};
}

/// Surface Stokes drift of a monochromatic deep-water wave of the same energy: a^2 w k with a^2 =
/// Hm0^2 / 8.
double stokes_speed_m_s(double energy_m2, double period_s) noexcept {
  const double omega = 2 * constants::pi / period_s;
  return energy_m2 / 8 * omega * omega * omega / g;
}

}  // namespace

WaveGrowth::WaveGrowth(const Weather& weather, std::uint64_t run_seed, double first_h,
                       double last_h)
    : first_h_(first_h) {
  Rng rng(run_seed, "synthetic/swell");
  for (double& phase : swell_phase_) phase = rng.uniform(0, 2 * constants::pi);
  const auto steps = static_cast<std::size_t>(std::ceil((last_h - first_h) / step_h)) + 2;
  const double share = 1 - std::exp(-step_h / growth_time_h);
  State state;
  for (std::size_t i = 0; i < steps; ++i) {
    const Horizontal wind = weather.site_wind_m_s(first_h + static_cast<double>(i) * step_h);
    const GrownSea grown = fetch_limited(wind);
    state.energy_m2 += share * (grown.height_m * grown.height_m - state.energy_m2);
    state.peak_period_s += share * (grown.peak_period_s - state.peak_period_s);
    state.heading += share * (wind / std::abs(wind) - state.heading);
    states_.push_back(state);
  }
}

SyntheticSea WaveGrowth::sea(double offshore_m, double hours) const noexcept {
  const double last = static_cast<double>(states_.size()) - 1.001;
  const double position = std::clamp((hours - first_h_) / step_h, 0.0, last);
  const auto i = static_cast<std::size_t>(position);
  const double x = position - static_cast<double>(i);
  const State& a = states_[i];
  const State& b = states_[i + 1];

  const double shelter = 0.6 + 0.45 * std::tanh(std::max(offshore_m, 0.0) / 12000);
  const double wind_energy = shelter * shelter * ((1 - x) * a.energy_m2 + x * b.energy_m2);
  const double wind_period = (1 - x) * a.peak_period_s + x * b.peak_period_s;
  const Horizontal heading = (1 - x) * a.heading + x * b.heading;

  const auto slow = [&](double period_h, double phase) {
    return std::sin(2 * constants::pi * hours / period_h + phase);
  };
  const double swell_height = shelter * (0.9 + 0.3 * slow(110, swell_phase_[0]));
  const double swell_energy = swell_height * swell_height;
  const double swell_period = 11 + slow(140, swell_phase_[1]);
  const double swell_from_deg = 300 + 10 * slow(170, swell_phase_[2]);

  const Horizontal wind_towards = heading / std::max(std::abs(heading), 1e-12);
  const Horizontal swell_towards = vector_from_direction(1, swell_from_deg);
  const double wind_tm02 = tm02_over_peak * wind_period;
  const double swell_tm02 = tm02_over_peak * swell_period;
  const double total = wind_energy + swell_energy;
  const bool swell_peaks = swell_energy * swell_period > wind_energy * wind_period;
  return {.significant_height_m = std::sqrt(total),
          .peak_period_s = swell_peaks ? swell_period : wind_period,
          .mean_period_tm02_s = std::sqrt(total / (wind_energy / (wind_tm02 * wind_tm02) +
                                                   swell_energy / (swell_tm02 * swell_tm02))),
          .from_direction_deg =
              from_direction_deg(wind_energy * wind_towards + swell_energy * swell_towards),
          .stokes_drift_m_s = stokes_speed_m_s(wind_energy, wind_tm02) * wind_towards +
                              stokes_speed_m_s(swell_energy, swell_tm02) * swell_towards};
}

}  // namespace slackwater::api
