#include "calibration/propagate/wind_error.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {

std::vector<Horizontal> draw_wind_error(std::span<const UtcTime> times, UtcTime end_of_day,
                                        const WindError& error, Rng& random) {
  std::vector<Horizontal> out;
  Horizontal unit{};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double lead_h = std::max(0.0, hours_between(end_of_day, times[i]));
    const double left =
        i == 0 ? 0.0 : std::exp(-hours_between(times[i - 1], times[i]) / error.memory_h);
    const Horizontal fresh{random.normal(), random.normal()};
    unit = left * unit + std::sqrt(1.0 - left * left) * fresh;
    const double sigma =
        std::sqrt(error.at_once_m_s * error.at_once_m_s -
                  error.limit_m_s * error.limit_m_s * std::expm1(-2.0 * lead_h / error.growth_h));
    out.push_back(sigma * unit);
  }
  return out;
}

std::vector<Horizontal> at_stamps(std::span<const UtcTime> samples,
                                  std::span<const Horizontal> departure,
                                  std::span<const UtcTime> stamps, UtcTime end_of_day) {
  std::vector<Horizontal> out;
  for (const UtcTime stamp : stamps) {
    const auto after = std::lower_bound(samples.begin(), samples.end(), stamp);
    const auto i = static_cast<std::size_t>(after - samples.begin());
    if (samples.empty() || stamp <= end_of_day) {
      out.emplace_back();
    } else if (i == samples.size()) {
      out.push_back(departure.back());
    } else {
      const UtcTime before = i == 0 ? end_of_day : samples[i - 1];
      const Horizontal low = i == 0 ? Horizontal{} : departure[i - 1];
      const double share = hours_between(before, stamp) / hours_between(before, samples[i]);
      out.push_back((1.0 - share) * low + share * departure[i]);
    }
  }
  return out;
}

}  // namespace slackwater::calibration
