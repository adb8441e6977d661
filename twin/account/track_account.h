#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace slackwater::twin {

/// The rows that a log holds of one vehicle, whoever keeps them.
struct VehicleRows {
  std::span<const double> t_s;  ///< ascending
  /// The numbers of a quantity of `log_variables`, all times one after the other; empty: the log
  /// has none.
  std::function<std::span<const double>(std::string_view)> column;
};

struct Extreme {
  double value = 0;
  double t_s = 0;
  friend bool operator==(const Extreme&, const Extreme&) = default;
};

/// 0 where there is none.
[[nodiscard]] inline double magnitude_of(const std::optional<Extreme>& extreme) noexcept {
  return extreme ? std::abs(extreme->value) : 0;
}

/// How a vehicle went, at the times of the log from when it was there until it halted or, where
/// that is asked for, until a time. Extremes are of their size, with their sign.
struct TrackAccount {
  double from_s = 0;
  double until_s = 0;
  double sailed_m = 0;  ///< over ground
  double rms_across_m = 0;
  double rms_depth_error_m = 0;  ///< off the depth or height of its way
  std::optional<Extreme> across_m;
  std::optional<Extreme> depth_error_m;
  std::optional<Extreme> roll_rad;
  std::optional<Extreme> pitch_rad;
  std::optional<Extreme> tether_n;
  std::optional<double> least_voltage_v;
  std::optional<double> navigation_error_m;  ///< where it took itself to be from where it was: last
  std::optional<double> rms_navigation_error_m;
  double drawn_j = 0;  ///< electrical, by then
  friend bool operator==(const TrackAccount&, const TrackAccount&) = default;
};

/// @param until_s  the first time from then on is the last one
[[nodiscard]] TrackAccount track_of(const VehicleRows& rows,
                                    double until_s = std::numeric_limits<double>::infinity());

}  // namespace slackwater::twin
