#include "calibration/day/given/wind_fill.h"

#include <algorithm>
#include <cmath>

#include "calibration/propagate/wind_error.h"
#include "fields/base/check.h"
#include "fields/current/stress_series.h"
#include "fields/record/cadence.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Over this a wind that was missing goes back to the run after the gap.
constexpr Duration way_back = hours(6);

/// What a stamp stands in.
struct Place {
  std::size_t before = 0;  ///< index of the value at or before it
  bool has_before = false;
  bool has_after = false;  ///< the value at `before` + 1, or the first of all, is after it
};

class Filling {
 public:
  explicit Filling(const VectorColumn& series) : series_(series) {
    Horizontal sum{};
    for (std::size_t i = 0; i < series.times(); ++i) {
      times_.push_back(series.time[i].centre());
      sum += series.value[i];
      mean_.push_back(sum / static_cast<double>(i + 1));
    }
  }

  [[nodiscard]] const std::vector<UtcTime>& times() const { return times_; }

  [[nodiscard]] Place place_of(UtcTime stamp) const {
    const auto after = std::upper_bound(times_.begin(), times_.end(), stamp);
    Place place;
    place.has_before = after != times_.begin();
    place.has_after = after != times_.end();
    if (place.has_before) place.before = static_cast<std::size_t>(after - times_.begin()) - 1;
    return place;
  }

  /// Whether the series says what blew then.
  [[nodiscard]] bool says(const Place& place, UtcTime stamp) const {
    if (!place.has_before) return false;
    if (times_[place.before] == stamp) return true;
    return place.has_after && may_interpolate(times_, place.before);
  }

  [[nodiscard]] Horizontal on_line(const Place& place, UtcTime stamp) const {
    const Horizontal low = series_.value[place.before];
    if (times_[place.before] == stamp) return low;
    const UtcTime from = times_[place.before];
    const double share = hours_between(from, stamp) / hours_between(from, times_[place.before + 1]);
    return (1 - share) * low + share * series_.value[place.before + 1];
  }

  [[nodiscard]] DataStatus nearer_source(const Place& place, UtcTime stamp) const {
    const std::size_t i = place.before;
    const bool is_after =
        place.has_after && times_[i + 1] - stamp <= stamp - times_[i] && times_[i] != stamp;
    return series_.source[is_after ? i + 1 : i];
  }

  /// Where the series is silent.
  [[nodiscard]] Horizontal missing(const Place& place, UtcTime stamp) const {
    Horizontal wind = mean_.back();
    if (place.has_before) {
      const double weight = std::exp(-hours_between(times_[place.before], stamp) / wind_memory_h);
      wind = weight * series_.value[place.before] + (1 - weight) * mean_[place.before];
    }
    if (!place.has_after) return wind;
    const std::size_t next = place.has_before ? place.before + 1 : 0;
    const double left = std::min(1.0, hours_between(stamp, times_[next]) / hours_of(way_back));
    return left * wind + (1 - left) * series_.value[next];
  }

  [[nodiscard]] double hole_sigma_m_s(const Place& place, UtcTime stamp) const {
    const WindErrorGrowth growth = persisted_wind_error();
    if (!place.has_before) return growth.saturation_m_s;
    const double before = growth.sigma_m_s(hours_between(times_[place.before], stamp));
    if (!place.has_after || before == 0) return 0;
    if (!may_interpolate(times_, place.before)) return before;
    if (!is_hole(times_, place.before)) return 0;
    const double after = growth.sigma_m_s(hours_between(stamp, times_[place.before + 1]));
    return before * after / std::hypot(before, after);
  }

 private:
  const VectorColumn& series_;
  std::vector<UtcTime> times_;
  std::vector<Horizontal> mean_;  ///< of the values up to each
};

void append(VectorColumn& series, UtcTime time, Horizontal value, DataStatus source) {
  series.time.push_back(TimeCell::instant(time));
  series.value.push_back(value);
  series.status.push_back(SampleStatus::ok);
  series.source.push_back(source);
}

/// Steps wider than a stress is followed over are filled on the line, hour by hour.
VectorColumn hourly(const VectorColumn& series, const Filling& filling) {
  VectorColumn fine;
  fine.point = series.point;
  const std::vector<UtcTime>& times = filling.times();
  for (std::size_t i = 0; i < times.size(); ++i) {
    append(fine, times[i], series.value[i], series.source[i]);
    if (i + 1 == times.size() || times[i + 1] - times[i] <= StressSeries::longest_gap ||
        !may_interpolate(times, i))
      continue;
    for (UtcTime time = times[i] + hours(1); time < times[i + 1]; time += hours(1)) {
      const Place place{i, true, true};
      append(fine, time, filling.on_line(place, time), filling.nearer_source(place, time));
    }
  }
  return fine;
}

/// A series with the stamps at which it is silent.
VectorColumn with_stamps(const VectorColumn& series, std::span<const UtcTime> stamps,
                         const FilledWind& filled) {
  VectorColumn whole;
  whole.point = series.point;
  std::size_t i = 0;
  const auto take_until = [&](UtcTime time) {
    for (; i < series.times() && series.time[i].centre() < time; ++i)
      append(whole, series.time[i].centre(), series.value[i], series.source[i]);
  };
  for (std::size_t s = 0; s < stamps.size(); ++s) {
    if (filled.source[s] != DataStatus::persisted) continue;
    take_until(stamps[s]);
    append(whole, stamps[s], filled.wind_m_s[s], DataStatus::persisted);
  }
  take_until(UtcTime::max());
  return whole;
}

}  // namespace

FilledWind fill_wind(const VectorColumn& series, std::span<const UtcTime> stamps) {
  expects(series.times() > 0, "a wind to fill from has a value");
  const Filling filling(series);
  const std::vector<UtcTime>& times = filling.times();
  FilledWind filled;
  for (const UtcTime stamp : stamps) {
    const Place place = filling.place_of(stamp);
    filled.hole_sigma_m_s.push_back(filling.hole_sigma_m_s(place, stamp));
    if (filling.says(place, stamp)) {
      filled.wind_m_s.push_back(filling.on_line(place, stamp));
      filled.source.push_back(filling.nearer_source(place, stamp));
      continue;
    }
    filled.wind_m_s.push_back(filling.missing(place, stamp));
    filled.source.push_back(DataStatus::persisted);
    if (!place.has_after) continue;
    const WindGap gap{place.has_before ? times[place.before] : stamps.front(),
                      times[place.has_before ? place.before + 1 : 0]};
    if (filled.gaps.empty() || !(filled.gaps.back() == gap)) filled.gaps.push_back(gap);
  }
  filled.series = with_stamps(hourly(series, filling), stamps, filled);
  return filled;
}

}  // namespace slackwater::calibration
