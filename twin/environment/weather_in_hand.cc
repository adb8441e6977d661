#include "twin/environment/weather_in_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fields/base/text.h"
#include "fields/wave/growth.h"
#include "fields/wind/log_profile.h"
#include "twin/environment/environment.h"

namespace slackwater::twin {
namespace {

constexpr double most_wind_m_s = 60, most_current_m_s = 5;
constexpr double most_visibility_m = 1e5, most_water_visibility_m = 200;
constexpr double least_visibility_m = 1, least_water_visibility_m = 0.05;

bool is_within(double value, double low, double high) { return value >= low && value <= high; }

std::string outside(std::string_view what, double found, double low, double high,
                    std::string_view unit) {
  return formatted("{}: found {:g} {}, expected {:g} to {:g} {}", what, found, unit, low, high,
                   unit);
}

bool has_wind(const Environment& environment) {
  return has_value(EnvironmentSampler(environment).wind({0, 0, -10}, 0).status);
}

std::string problem_of_height(double height_m, const Environment& environment) {
  if (!environment.sea)
    return height_m == 0 ? std::string()
                         : formatted(
                               "waves: found {:g} m in a run that has a calm sea, expected 0; "
                               "begin a run whose scenario has waves",
                               height_m);
  const double period_s = environment.sea_peak_period_s;
  const double most_m =
      std::max(steepest_height_m(period_s), environment.sea->significant_height_m());
  if (is_within(height_m, 0, most_m)) return {};
  return formatted(
      "waves: found {:g} m, expected 0 to {:.1f} m: higher waves of {:.1f} s break; "
      "begin a run with longer ones",
      height_m, most_m, period_s);
}

/// The wakes of the wind to come; null: of the run's own wind, or none.
std::shared_ptr<const FarmFlow> farm_in(const Environment& environment,
                                        const std::optional<Horizontal>& wind_10m_m_s) {
  if (!environment.farm || !environment.turbines || !wind_10m_m_s) return nullptr;
  const Turbine& kind = *environment.turbines->kind;
  return std::make_shared<const FarmFlow>(kind, environment.turbines->at_m,
                                          log_profile_ratio(kind.hub_height_m, 10) * *wind_10m_m_s,
                                          FarmSettings{});
}

}  // namespace

std::string problem_of(const WeatherAsked& asked, const Environment& environment) {
  if (!is_within(asked.over_s, least_over_s, most_over_s))
    return outside("over", asked.over_s, least_over_s, most_over_s, "s");
  if (asked.wind_10m_m_s && !is_within(std::abs(*asked.wind_10m_m_s), 0, most_wind_m_s))
    return outside("wind", std::abs(*asked.wind_10m_m_s), 0, most_wind_m_s, "m/s");
  if (asked.wind_10m_m_s && !has_wind(environment))
    return "wind: the forecast of this run has none, and none can be led; begin a run with wind";
  if (asked.current_m_s && !is_within(std::abs(*asked.current_m_s), 0, most_current_m_s))
    return outside("current", std::abs(*asked.current_m_s), 0, most_current_m_s, "m/s");
  if (asked.visibility_m && !is_within(*asked.visibility_m, least_visibility_m, most_visibility_m))
    return outside("visibility", *asked.visibility_m, least_visibility_m, most_visibility_m, "m");
  if (asked.water_visibility_m &&
      !is_within(*asked.water_visibility_m, least_water_visibility_m, most_water_visibility_m))
    return outside("visibility under water", *asked.water_visibility_m, least_water_visibility_m,
                   most_water_visibility_m, "m");
  if (asked.significant_wave_height_m)
    return problem_of_height(*asked.significant_wave_height_m, environment);
  return {};
}

void WeatherInHand::set(const WeatherAsked& asked, const Environment& environment, double t_s) {
  auto next =
      all_.empty() ? std::make_unique<WeatherNow>() : std::make_unique<WeatherNow>(*all_.back());
  const WeatherAsked before = std::exchange(next->asked, asked);
  const double settled_s = t_s + asked.over_s;
  if (before.wind_10m_m_s != asked.wind_10m_m_s) {
    next->settled_s = settled_s;
    next->wind_10m_m_s.lead(asked.wind_10m_m_s, t_s, asked.over_s);
    next->farm = farm_in(environment, asked.wind_10m_m_s);
  }
  if (before.current_m_s != asked.current_m_s) {
    next->settled_s = settled_s;
    next->current_m_s.lead(asked.current_m_s, t_s, asked.over_s);
  }
  if (before.significant_wave_height_m != asked.significant_wave_height_m) {
    next->settled_s = settled_s;
    next->significant_wave_height_m.lead(asked.significant_wave_height_m, t_s, asked.over_s);
    if (environment.sea) {
      const SeaRealisation& now = next->sea ? *next->sea : *environment.sea;
      std::optional<double> factor;
      if (asked.significant_wave_height_m)
        factor = *asked.significant_wave_height_m / now.significant_height_m();
      next->sea = std::make_shared<const SeaRealisation>(
          now.following(now.course().led(factor, t_s, asked.over_s)));
    }
  }
  all_.push_back(std::move(next));
  now_.store(all_.back().get(), std::memory_order_release);
}

void WeatherInHand::forget() {
  now_.store(nullptr, std::memory_order_release);
  all_.clear();
}

}  // namespace slackwater::twin
