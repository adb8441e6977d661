#include "calibration/propagate/ensemble_wind.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/square.h"

namespace slackwater::calibration {
namespace {

using constants::nan;

/// Linear between times, from 0 at the end of D, held after the last; NaN next to what is.
template <typename T>
T at(std::span<const UtcTime> times, std::span<const T> values, UtcTime end_of_day, UtcTime time) {
  const auto i =
      static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
  if (i == times.size()) return values.back();
  if (times[i] == time) return values[i];
  const UtcTime before = i == 0 ? end_of_day : times[i - 1];
  const T low = i == 0 ? T{} : values[i - 1];
  const double share = hours_between(before, time) / hours_between(before, times[i]);
  return (1.0 - share) * low + share * values[i];
}

}  // namespace

std::vector<std::size_t> choose_drivers(std::size_t ensemble, std::size_t members,
                                        std::uint64_t seed, std::size_t set) {
  expects(ensemble > 0, "somebody drives");
  // The round in which the first set ends has the stream that it had before there were further
  // sets.
  const std::size_t first_odd_round = members / ensemble;
  std::vector<std::size_t> drivers;
  const std::size_t end = (set + 1) * members;
  for (std::size_t card = set * members; card < end;) {
    const std::size_t round = card / ensemble;
    const std::size_t next = std::min(end, (round + 1) * ensemble);
    std::vector<std::size_t> drawn(ensemble);
    std::iota(drawn.begin(), drawn.end(), 0U);
    Rng random(seed, round == first_odd_round
                         ? "calibration/wind_drivers"
                         : "calibration/wind_drivers/" + std::to_string(round));
    for (std::size_t i = ensemble - 1; i > 0; --i)
      std::swap(drawn[i], drawn[random.bits() % (i + 1)]);
    const auto at = [&](std::size_t c) {
      return drawn.begin() + static_cast<std::ptrdiff_t>(c - round * ensemble);
    };
    std::sort(at(card), at(next));
    drivers.insert(drivers.end(), at(card), at(next));
    card = next;
  }
  return drivers;
}

std::vector<double> ensemble_variance(const WindDepartures& ensemble, std::size_t times) {
  expects(ensemble.departure_m_s.size() == ensemble.number.size() * times,
          "a departure for each member and time");
  std::vector<double> variance(times);
  for (std::size_t t = 0; t < times; ++t) {
    double count = 0;
    for (std::size_t i = t; i < ensemble.departure_m_s.size(); i += times) {
      const double square = 0.5 * std::norm(ensemble.departure_m_s[i]);
      if (std::isnan(square)) continue;
      variance[t] += square;
      count += 1.0;
    }
    variance[t] = count > 0 ? variance[t] / count : nan;
  }
  return variance;
}

double least_ensemble_sigma_m_s() noexcept { return analysed_wind_error().initial_m_s; }

EnsembleWind::EnsembleWind(const WindDepartures& ensemble, std::span<const UtcTime> times,
                           UtcTime end_of_day, std::span<const UtcTime> samples,
                           const WindErrorGrowth& law, std::size_t members, std::uint64_t seed,
                           std::size_t set)
    : samples_(samples.begin(), samples.end()),
      law_(law),
      seed_(seed),
      first_(set * members),
      number_(ensemble.number),
      driver_of_member_(choose_drivers(ensemble.number.size(), members, seed, set)) {
  const std::vector<double> variance = ensemble_variance(ensemble, times.size());
  const std::span all(ensemble.departure_m_s);
  for (std::size_t n = 0; n < number_.size(); ++n) {
    drivers_.push_back(
        driver_of(all.subspan(n * times.size(), times.size()), variance, times, end_of_day));
  }
  for (std::size_t m = 0; m < members; ++m)
    is_repeated_.push_back(first_ + m >= number_.size());  // after the first round
}

EnsembleWind::Driver EnsembleWind::driver_of(std::span<const Horizontal> departure_m_s,
                                             std::span<const double> variance,
                                             std::span<const UtcTime> times,
                                             UtcTime end_of_day) const {
  Driver driver;
  std::optional<std::size_t> last;  // the last sample at which the member says something
  const double least = square(least_ensemble_sigma_m_s());
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const UtcTime time = samples_[k];
    const Horizontal known = at(times, departure_m_s, end_of_day, time);
    const double law = law_.sigma_m_s(hours_between(end_of_day, time));
    if (!std::isnan(known.real())) {
      const double spread_squared = at(times, variance, end_of_day, time);
      driver.departure_m_s.push_back(known);
      driver.spread_m_s.push_back(std::sqrt(spread_squared));
      driver.remainder_m_s.push_back(std::sqrt(std::max(0.0, least - spread_squared)));
      last = k;
    } else if (last) {
      const double kept = std::exp(-hours_between(samples_[*last], time) / law_.memory_h);
      const double remainder = square(kept * driver.remainder_m_s[*last]);
      driver.departure_m_s.push_back(kept * driver.departure_m_s[*last]);
      driver.spread_m_s.push_back(kept * driver.spread_m_s[*last]);
      driver.remainder_m_s.push_back(std::sqrt(remainder + (1.0 - kept * kept) * law * law));
    } else {
      driver.departure_m_s.emplace_back();
      driver.spread_m_s.push_back(0.0);
      driver.remainder_m_s.push_back(law);
    }
  }
  return driver;
}

std::vector<int> EnsembleWind::numbers() const {
  std::vector<int> numbers;
  for (const std::size_t n : driver_of_member_) numbers.push_back(number_[n]);
  return numbers;
}

std::vector<Horizontal> EnsembleWind::departure(std::size_t m, Rng& random) const {
  const Driver& driver = drivers_[driver_of_member_[m]];
  std::vector<Horizontal> departure =
      draw_wind_departures(samples_, driver.remainder_m_s, law_.memory_h, random);
  const double sign = m % 2 == 0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < departure.size(); ++k)
    departure[k] = driver.departure_m_s[k] + sign * departure[k];
  if (!is_repeated_[m]) return departure;
  std::vector<double> sigma;
  for (const double spread : driver.spread_m_s) sigma.push_back(repeated_share * spread);
  Rng own(seed_, "calibration/repeated_wind/" + std::to_string(first_ + m));
  const std::vector<Horizontal> more = draw_wind_departures(samples_, sigma, law_.memory_h, own);
  for (std::size_t k = 0; k < departure.size(); ++k) departure[k] += more[k];
  return departure;
}

}  // namespace slackwater::calibration
