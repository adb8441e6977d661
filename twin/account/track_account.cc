#include "twin/account/track_account.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {
namespace {

/// Of the rows from `first` on, `count` of them.
struct RowRange {
  std::size_t first = 0;
  std::size_t count = 0;
};

RowRange stretch_of(const VehicleRows& rows, double until_s) {
  const auto end = std::lower_bound(rows.t_s.begin(), rows.t_s.end(), until_s);
  std::size_t last =
      std::min(static_cast<std::size_t>(end - rows.t_s.begin()) + 1, rows.t_s.size());
  const std::span<const double> halt = rows.column("halt"), x = rows.column("x");
  for (std::size_t t = 0; t < std::min(last, halt.size()); ++t)
    if (halt[t] > 0) last = t + 1;
  std::size_t first = 0;
  while (first + 1 < last && first < x.size() && !std::isfinite(x[first])) ++first;
  return {first, last > first ? last - first : 0};
}

/// The rows of a quantity that count; none where the log has none.
class RowSeries {
 public:
  RowSeries(const VehicleRows& rows, RowRange stretch, std::string_view name) : t_s_(rows.t_s) {
    const std::span<const double> all = rows.column(name);
    if (all.empty()) return;
    first_ = stretch.first;
    values_ = all.subspan(stretch.first, stretch.count);
  }
  [[nodiscard]] std::optional<Extreme> largest() const {
    std::optional<Extreme> found;
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (std::isfinite(values_[i]) && (!found || std::abs(values_[i]) > std::abs(found->value)))
        found = Extreme{values_[i], t_s_[first_ + i]};
    return found;
  }
  [[nodiscard]] double rms() const {
    double squares = 0, count = 0;
    for (const double value : values_) {
      if (!std::isfinite(value)) continue;
      squares += value * value;
      ++count;
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
  }
  [[nodiscard]] std::optional<double> least() const {
    std::optional<double> found;
    for (const double value : values_)
      if (std::isfinite(value)) found = std::min(found.value_or(value), value);
    return found;
  }
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }

 private:
  std::span<const double> t_s_;
  std::span<const double> values_;
  std::size_t first_ = 0;
};

double sailed_m(const VehicleRows& rows, RowRange stretch) {
  const RowSeries x(rows, stretch, "x"), y(rows, stretch, "y"), z(rows, stretch, "z");
  if (x.values().empty() || y.values().empty() || z.values().empty()) return 0;
  double sum_m = 0;
  for (std::size_t i = 1; i < stretch.count; ++i)
    sum_m += std::hypot(x.values()[i] - x.values()[i - 1], y.values()[i] - y.values()[i - 1],
                        z.values()[i] - z.values()[i - 1]);
  return sum_m;
}

/// East, north and up of each row of the whole log.
void note_navigation(std::span<const double> errors, TrackAccount& track) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i + 2 < errors.size(); i += 3) {
    const double error_m = std::hypot(errors[i], errors[i + 1], errors[i + 2]);
    if (!std::isfinite(error_m)) continue;
    track.navigation_error_m = error_m;
    squares += error_m * error_m;
    ++count;
  }
  if (count > 0) track.rms_navigation_error_m = std::sqrt(squares / count);
}

}  // namespace

TrackAccount track_of(const VehicleRows& rows, double until_s) {
  TrackAccount track;
  const RowRange stretch = stretch_of(rows, until_s);
  if (stretch.count == 0) return track;
  const auto quantity = [&](const char* name) { return RowSeries(rows, stretch, name); };
  track.from_s = rows.t_s[stretch.first];
  track.until_s = rows.t_s[stretch.first + stretch.count - 1];
  track.sailed_m = sailed_m(rows, stretch);
  track.across_m = quantity("across_track").largest();
  track.rms_across_m = quantity("across_track").rms();
  track.depth_error_m = quantity("below_track").largest();
  track.rms_depth_error_m = quantity("below_track").rms();
  track.roll_rad = quantity("roll").largest();
  track.pitch_rad = quantity("pitch").largest();
  track.tether_n = quantity("tether_tension").largest();
  track.least_voltage_v = quantity("bus_voltage").least();
  const RowSeries drawn = quantity("electrical_energy");
  if (!drawn.values().empty()) track.drawn_j = drawn.values().back();
  note_navigation(rows.column("navigation_error"), track);
  return track;
}

}  // namespace slackwater::twin
