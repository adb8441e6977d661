#include "fields/wave/growth.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/square.h"
#include "fields/base/turn.h"

namespace slackwater {
namespace {

using constants::gravity_m_s2;
using constants::pi;

constexpr double calm_m_s = 0.5;
constexpr double least_fetch_m = 10.0;             ///< where growth begins: half a minute of it
constexpr double energy_period_over_peak = 0.903;  ///< Tm-10/Tp of JONSWAP, gamma 3.3
constexpr double oldest_wave_age =
    1.2;  ///< c_p/U10 of a fully developed sea (Pierson & Moskowitz 1964)
constexpr double widest_turn_deg = 60.0;

double degrees_between(double a_deg, double b_deg) {
  return std::abs(short_way_deg(a_deg - b_deg));
}

/// Fetch at which this wind raises this height, at most `longest_m`.
double fetch_of_height(double wind_speed_m_s, double height_m, double longest_m,
                       double water_depth_m) {
  double low = 0.0;
  double high = longest_m;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const bool below =
        middle <= 0 ||
        fetch_limited_sea(wind_speed_m_s, middle, water_depth_m).significant_height_m < height_m;
    (below ? low : high) = middle;
  }
  return high;
}

/// Waves under the wind and waves that have left it.
struct Parts {
  WindSea wind_sea;
  double wind_sea_from_deg = 0;
  SeaState swell;
};

/// Two swells become one: energies add, the one with the higher peak gives period and direction.
SeaState merged(const SeaState& a, const SeaState& b) {
  if (b.significant_height_m <= 0) return a;
  if (a.significant_height_m <= 0) return b;
  const double peak_a = square(a.significant_height_m) * a.peak_period_s;
  const double peak_b = square(b.significant_height_m) * b.peak_period_s;
  SeaState sum = peak_b > peak_a ? b : a;
  sum.significant_height_m = std::hypot(a.significant_height_m, b.significant_height_m);
  if (std::isfinite(sum.peak_period_s))
    sum.significant_height_m =
        std::min(sum.significant_height_m, steepest_height_m(sum.peak_period_s));
  return sum;
}

SeaState as_state(const WindSea& sea, double from_deg) {
  return {sea.significant_height_m, sea.peak_period_s, from_deg};
}

Parts divided(const SeaState& last, Horizontal wind, const WaveSetting& setting) {
  Parts parts;
  parts.swell = last;
  parts.wind_sea_from_deg = from_direction_deg(wind);
  const double speed = std::abs(wind);
  if (speed < calm_m_s) return parts;
  const bool along =
      !(degrees_between(last.from_direction_deg, parts.wind_sea_from_deg) > widest_turn_deg);
  const bool young = !(gravity_m_s2 * last.peak_period_s / (2.0 * pi) > oldest_wave_age * speed);
  if (!along || !young) return parts;
  const double fetch_m = setting.fetch.at_m(parts.wind_sea_from_deg);
  const WindSea most = fetch_limited_sea(speed, fetch_m, setting.water_depth_m);
  parts.wind_sea.significant_height_m =
      std::min(last.significant_height_m, most.significant_height_m);
  parts.swell.significant_height_m = std::sqrt(std::max(
      0.0, square(last.significant_height_m) - square(parts.wind_sea.significant_height_m)));
  // Until the first step the wind sea keeps the period it was seen with.
  parts.wind_sea.peak_period_s =
      std::isfinite(last.peak_period_s) ? last.peak_period_s : most.peak_period_s;
  return parts;
}

void advance_an_hour(Parts& parts, Horizontal wind, const WaveSetting& setting) {
  const double decay =
      std::exp(-0.5 / setting.swell_decay_h);  // of the height: half the rate of the energy
  parts.swell.significant_height_m *= decay;
  const double speed = std::abs(wind);
  const double from_deg = from_direction_deg(wind);
  const bool left =
      speed < calm_m_s || degrees_between(from_deg, parts.wind_sea_from_deg) > widest_turn_deg;
  if (left) {
    parts.swell = merged(parts.swell, as_state(parts.wind_sea, parts.wind_sea_from_deg));
    parts.wind_sea = {};
  }
  if (speed < calm_m_s) return;
  const double fetch_m = setting.fetch.at_m(from_deg);
  const WindSea most = fetch_limited_sea(speed, fetch_m, setting.water_depth_m);
  if (parts.wind_sea.significant_height_m > most.significant_height_m) {
    WindSea excess = parts.wind_sea;
    excess.significant_height_m =
        std::sqrt(square(parts.wind_sea.significant_height_m) - square(most.significant_height_m));
    parts.swell = merged(parts.swell, as_state(excess, parts.wind_sea_from_deg));
    parts.wind_sea = most;
  } else {
    const double reached_m =
        fetch_of_height(speed, parts.wind_sea.significant_height_m, fetch_m, setting.water_depth_m);
    const double further =
        std::min(fetch_after(speed, reached_m, 3600.0, setting.water_depth_m), fetch_m);
    parts.wind_sea = fetch_limited_sea(speed, further, setting.water_depth_m);
  }
  parts.wind_sea_from_deg = from_deg;
}

}  // namespace

WindSea fetch_limited_sea(double wind_speed_m_s, double fetch_m, double water_depth_m) {
  expects(wind_speed_m_s >= 0 && fetch_m > 0 && water_depth_m > 0,
          "a wind sea needs a wind speed >= 0, a fetch > 0 and a depth > 0");
  if (wind_speed_m_s < calm_m_s) return {};
  const double u = wind_speed_m_s;
  const double x = gravity_m_s2 * fetch_m / (u * u);
  const double d = gravity_m_s2 * water_depth_m / (u * u);
  const double a = std::tanh(0.343 * std::pow(d, 1.14));
  const double b = std::tanh(0.10 * std::pow(d, 2.01));
  const double h = 0.24 * std::pow(a * std::tanh(4.41e-4 * std::pow(x, 0.79) / a), 0.572);
  const double t = 7.69 * std::pow(b * std::tanh(2.77e-7 * std::pow(x, 1.45) / b), 0.187);
  WindSea sea{h * u * u / gravity_m_s2, t * u / gravity_m_s2};
  sea.significant_height_m =
      std::min(sea.significant_height_m, steepest_height_m(sea.peak_period_s));
  return sea;
}

double fetch_after(double wind_speed_m_s, double start_fetch_m, double duration_s,
                   double water_depth_m) {
  expects(duration_s >= 0, "a wind cannot blow for a negative time");
  if (wind_speed_m_s < calm_m_s) return start_fetch_m;
  const auto speed = [&](double fetch_m) {
    const double period_s = fetch_limited_sea(wind_speed_m_s, fetch_m, water_depth_m).peak_period_s;
    return std::min(gravity_m_s2 * energy_period_over_peak * period_s / (4.0 * pi),
                    std::sqrt(gravity_m_s2 * water_depth_m));
  };
  double fetch_m = std::max(start_fetch_m, least_fetch_m);
  const int steps = std::max(1, static_cast<int>(std::ceil(duration_s / 600.0)));
  const double step_s = duration_s / steps;
  for (int i = 0; i < steps; ++i) {  // midpoint rule: the speed varies slowly
    const double half = fetch_m + 0.5 * step_s * speed(fetch_m);
    fetch_m += step_s * speed(half);
  }
  return fetch_m;
}

WindSea limited_wind_sea(double wind_speed_m_s, double fetch_m, double duration_s,
                         double water_depth_m) {
  if (wind_speed_m_s >= 0 && wind_speed_m_s < calm_m_s) return {};  // nothing travels, no fetch
  const double reached_m = fetch_after(wind_speed_m_s, 0.0, duration_s, water_depth_m);
  return fetch_limited_sea(wind_speed_m_s, std::min(fetch_m, reached_m), water_depth_m);
}

double steepest_height_m(double peak_period_s) noexcept {
  const double share = std::clamp((peak_period_s - 8.0) / (15.0 - 8.0), 0.0, 1.0);
  const double steepness = 1.0 / 15.0 + share * (1.0 / 25.0 - 1.0 / 15.0);
  return steepness * gravity_m_s2 * peak_period_s * peak_period_s / (2.0 * pi);
}

std::vector<SeaState> propagate_sea_state(const SeaState& last, std::span<const Horizontal> wind,
                                          const WaveSetting& setting) {
  expects(setting.water_depth_m > 0 && setting.swell_decay_h > 0,
          "waves need a depth and a decay time above zero");
  std::vector<SeaState> sea(wind.size(), SeaState{constants::nan, constants::nan, constants::nan});
  if (wind.empty() || !std::isfinite(last.significant_height_m)) return sea;
  sea[0] = last;
  const auto known = [](Horizontal w) {
    return std::isfinite(w.real()) && std::isfinite(w.imag());
  };
  if (!known(wind[0])) return sea;
  Parts parts = divided(last, wind[0], setting);
  for (std::size_t i = 1; i < wind.size() && known(wind[i]); ++i) {
    advance_an_hour(parts, wind[i], setting);
    sea[i] = merged(as_state(parts.wind_sea, parts.wind_sea_from_deg), parts.swell);
  }
  return sea;
}

}  // namespace slackwater
