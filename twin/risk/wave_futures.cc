#include "twin/risk/wave_futures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "fields/base/check.h"
#include "fields/base/numbers/normal_quantile.h"
#include "fields/base/numbers/random.h"
#include "fields/interpolate/temporal.h"
#include "fields/wave/height_error.h"
#include "fields/wave/height_spread.h"

namespace slackwater::twin {
namespace {

constexpr std::size_t set_size = WaveFutures::set_size;
constexpr double most_of_wind = 0.9;  ///< of the variance of z

using Paths = std::vector<std::vector<double>>;

const ForecastColumn* column_with_waves(const Snapshot& forecast) noexcept {
  for (const ForecastColumn& column : forecast.columns)
    if (!column.sea.empty()) return &column;
  return nullptr;
}

/// What the wind of each member makes of ln(Hs + 0.3 m), as standard deviations of the spread.
Paths driven_by_wind(const Snapshot& forecast, const ForecastColumn& column,
                     const std::vector<double>& spread) {
  const std::size_t times = forecast.time.size();
  Paths driven(forecast.members - 1, std::vector<double>(times, 0));
  for (std::size_t m = 0; m + 1 < forecast.members; ++m) {
    double lasting_m_s = 0;
    for (std::size_t t = 0; t < times; ++t) {
      const double stronger_m_s =
          std::abs(column.wind_member_m_s[m * times + t]) - std::abs(column.wind_m_s[t]);
      const double passed_h = t == 0 ? 0 : hours_between(forecast.time[t - 1], forecast.time[t]);
      const double kept = std::exp(-passed_h / height_error::wind_memory_h);
      lasting_m_s = kept * lasting_m_s + (1 - kept) * stronger_m_s;
      driven[m][t] = height_error::per_wind * lasting_m_s / spread[t];
    }
  }
  return driven;
}

/// Paths of one set that remember as exp(-t / memory), neighbours opposite.
Paths draw_set(const std::vector<UtcTime>& time, std::uint64_t seed, const std::string& name) {
  Paths paths(set_size, std::vector<double>(time.size()));
  for (std::size_t m = 0; m < set_size; m += 2) {
    Rng random(seed, name + "/" + std::to_string(m / 2));
    for (std::size_t t = 0; t < time.size(); ++t) {
      const double fresh = random.normal();
      if (t == 0) {
        paths[m][t] = fresh;
      } else {
        const double kept = std::exp(-hours_between(time[t - 1], time[t]) / WaveFutures::memory_h);
        paths[m][t] = kept * paths[m][t - 1] + std::sqrt(1 - kept * kept) * fresh;
      }
      paths[m + 1][t] = -paths[m][t];
    }
  }
  return paths;
}

/// Adds the part of the wind, no more of it than `most_of_wind` where the winds spread wide.
/// @param first  of the members whose winds these paths go with, one after the other
void add_wind(const Paths& driven, std::size_t first, std::size_t t, Paths& paths) {
  const auto of = [&](std::size_t path) { return driven[(first + path) % driven.size()][t]; };
  double squares = 0;
  for (std::size_t m = 0; m < paths.size(); ++m) squares += of(m) * of(m);
  const double variance = squares / static_cast<double>(paths.size());
  const double share = std::min(variance, most_of_wind);
  const double scale = variance > share ? std::sqrt(share / variance) : 1;
  for (std::size_t m = 0; m < paths.size(); ++m)
    paths[m][t] = scale * of(m) + std::sqrt(1 - share) * paths[m][t];
}

/// Where in its stratum a set draws: 1/2, 1/4, 3/4, 1/8, 5/8, ... (van der Corput).
double place_in_stratum(std::size_t set) noexcept {
  double place = 0, digit = 0.5;
  for (std::size_t n = set + 1; n > 0; n /= 2, digit /= 2)
    if (n % 2 == 1) place += digit;
  return place;
}

/// The values of a normal, one from each of so many strata, ascending.
std::vector<double> even_normals(double place) {
  std::vector<double> values;
  for (std::size_t rank = 0; rank < set_size; ++rank)
    values.push_back(
        normal_quantile((static_cast<double>(rank) + place) / static_cast<double>(set_size)));
  return values;
}

/// Puts the values of a set at one stamp where a normal has them, in their order.
void spread_evenly(const std::vector<double>& normals, std::size_t t, Paths& paths) {
  std::vector<std::size_t> order(paths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return paths[a][t] < paths[b][t]; });
  for (std::size_t rank = 0; rank < order.size(); ++rank) paths[order[rank]][t] = normals[rank];
}

}  // namespace

WaveFutures::WaveFutures(const Snapshot& forecast, std::size_t futures)
    : time_(forecast.time), members_(forecast.members) {
  expects(futures > 0, "the central future is one");
  const ForecastColumn* column = column_with_waves(forecast);
  if (column == nullptr) {  // nobody knows a height whose error this would be
    spread_.assign(time_.size(), 0);
    paths_.assign(futures - 1, std::vector<double>(time_.size(), 0));
    return;
  }
  spread_ = height_spread_of(forecast, *column);
  Paths driven;
  if (!column->wind_member_m_s.empty()) driven = driven_by_wind(forecast, *column, spread_);
  const std::string name = "risk/wave_height/" + forecast.site_id + "/" + format_day(forecast.day);
  for (std::size_t set = 0; paths_.size() + 1 < futures; ++set) {
    Paths paths = draw_set(time_, forecast.seed, name + "/" + std::to_string(set));
    const std::vector<double> normals = even_normals(place_in_stratum(set));
    for (std::size_t t = 0; t < time_.size(); ++t) {
      if (!(spread_[t] > 0)) continue;
      if (!driven.empty()) add_wind(driven, set * set_size, t, paths);
      spread_evenly(normals, t, paths);
    }
    paths.resize(std::min(set_size, futures - 1 - paths_.size()));
    std::move(paths.begin(), paths.end(), std::back_inserter(paths_));
  }
}

std::size_t WaveFutures::member_of(std::size_t future) const noexcept {
  if (future == 0 || members_ < 2) return 0;
  return (future - 1) % (members_ - 1) + 1;
}

WaveFutures::Moment WaveFutures::moment(UtcTime time) const noexcept {
  if (time_.empty()) return {};
  const TimePlace place =
      place_in(time_, std::clamp(time, time_.front(), time_.back())).value_or(TimePlace{});
  Moment at;
  at.low = place.low;
  at.high = place.upper > 0 ? place.low + 1 : place.low;
  const double share = place.upper;
  // Between two stamps a mean of them is narrower than either: made as wide again.
  const double kept =
      at.high > at.low ? std::exp(-hours_between(time_[at.low], time_[at.high]) / memory_h) : 1;
  const double width =
      std::sqrt((1 - share) * (1 - share) + share * share + 2 * share * (1 - share) * kept);
  at.of_low = (1 - share) / width;
  at.of_high = share / width;
  const double spread = (1 - share) * spread_[at.low] + share * spread_[at.high];
  at.spread = std::isnan(spread) ? 0 : spread;
  return at;
}

double WaveFutures::height_m(std::size_t future, double central_m,
                             const Moment& at) const noexcept {
  if (future == 0 || time_.empty() || std::isnan(central_m)) return central_m;
  const std::vector<double>& path = paths_[future - 1];
  return height_error::height_at(central_m, at.spread,
                                 at.of_low * path[at.low] + at.of_high * path[at.high]);
}

}  // namespace slackwater::twin
