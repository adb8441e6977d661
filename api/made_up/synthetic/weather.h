#pragma once
#include <cstdint>

#include "api/made_up/synthetic/random_series.h"
#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// The wind over the synthetic ocean, at 10 m, towards: depressions that pass eastwards, 5 to 18
/// m/s at the site. Analytic in time and space. Offshore it blows up to 6 % harder, at the coast up
/// to 6 % less.
class Weather {
 public:
  Weather(std::uint64_t run_seed, UtcTime epoch);

  [[nodiscard]] Horizontal wind_m_s(PlanePoint point, double hours) const noexcept {
    return offshore_gain(point) * site_wind_m_s(hours - arrival_delay_h(point));
  }
  /// At the origin of the plane. Speed within [5, 17] m/s.
  [[nodiscard]] Horizontal site_wind_m_s(double hours) const noexcept;
  /// The wind at a point is this gain times the site's wind `arrival_delay_h` hours ago.
  [[nodiscard]] static double offshore_gain(PlanePoint point) noexcept;
  [[nodiscard]] static double arrival_delay_h(PlanePoint point) noexcept;

 private:
  double phase_[6]{};
};

/// One run of a weather model that forecasts the synthetic wind: the truth plus an error that is
/// drawn anew for each run, smooth in time and space, with a standard deviation of each component
/// of 0.4 m/s at the start growing by 0.6 m/s a day (1.0 m/s at 24 h, 2.2 m/s at 72 h), about what
/// verification reports of global models show over sea.
class WeatherForecast {
 public:
  WeatherForecast(const Weather& weather, std::uint64_t run_seed, UtcTime epoch, UtcTime issued);
  /// Wind forecast for `hours` after the epoch; the error before the issue time is that of an
  /// analysis.
  [[nodiscard]] Horizontal wind_m_s(PlanePoint point, double hours) const noexcept;
  [[nodiscard]] static double component_sigma_m_s(double lead_h) noexcept;
  /// The error field before it is scaled with lead: unit standard deviation of each component.
  [[nodiscard]] Horizontal unit_error(PlanePoint point, double hours) const noexcept {
    return error_.at(point, hours);
  }

 private:
  const Weather* weather_;
  RandomVectorField error_;
  double issued_h_ = 0;
};

}  // namespace slackwater::api
