#pragma once
#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// What befell a vehicle and when, seconds since the epoch; no number: it did not. Numbers only.
struct Milestones {
  static constexpr double never = constants::nan;
  double power_lost_s = never;
  double is_empty = 0;  ///< 1: the battery had nothing left; 0: its voltage was too low
  double capsized_s = never;
  double line_parted_s = never;
  double most_line_n = 0;         ///< of its tether, at the vehicle
  double kept_depth_m = never;    ///< the last one that was to be kept and at which it was
  double left_depth_s = never;    ///< see `note_depth`
  double largest_pitch_sine = 0;  ///< of its size
  /// Of the largest roll: sine squared of it up to a right angle, 2 less that beyond: grows with
  /// it, without a call of atan2.
  double largest_roll_measure = 0;

  [[nodiscard]] double largest_pitch_rad() const noexcept {
    return std::asin(std::min(largest_pitch_sine, 1.0));
  }
  [[nodiscard]] double largest_roll_rad() const noexcept {
    const double m = largest_roll_measure;
    const double acute = std::asin(std::sqrt(std::clamp(m < 1 ? m : 2 - m, 0.0, 1.0)));
    return m < 1 ? acute : constants::pi - acute;
  }
};

/// Rolled or pitched beyond a right angle: what was below is above.
[[nodiscard]] inline bool is_capsized(const Rotation<double>& r) noexcept { return r.down.z < 0; }

inline void note_attitude(Milestones& m, const Rotation<double>& r, double t_s) noexcept {
  m.largest_pitch_sine = std::max(m.largest_pitch_sine, std::abs(r.down.x));
  const double y2 = r.down.y * r.down.y;
  const double across2 = y2 + r.down.z * r.down.z;
  // On its nose or tail a body has no roll to speak of.
  if (across2 > 1e-4) {
    const double share = y2 / across2;
    m.largest_roll_measure = std::max(m.largest_roll_measure, r.down.z < 0 ? 2 - share : share);
  }
  if (is_capsized(r) && std::isnan(m.capsized_s)) m.capsized_s = t_s;
}

/// Leaves its depth: one that has been within `bound_m` of the depth that it is to keep is not any
/// more, though that stayed where it was. On the way to another depth it leaves none.
/// @param wanted_m  to be kept; no number: nobody keeps one, and it is to be where it was
inline void note_depth(Milestones& m, double bound_m, double wanted_m, double depth_m,
                       double t_s) noexcept {
  if (std::isnan(wanted_m)) wanted_m = std::isnan(m.kept_depth_m) ? depth_m : m.kept_depth_m;
  if (std::abs(depth_m - wanted_m) <= bound_m)
    m.kept_depth_m = wanted_m;
  else if (!(std::abs(wanted_m - m.kept_depth_m) <= bound_m))
    m.kept_depth_m = Milestones::never;  // on its way to another one, until it is there
  else if (std::isnan(m.left_depth_s))
    m.left_depth_s = t_s;
}

/// @param off  of the battery: 1 once it gives nothing more
inline void note_power(Milestones& m, double off, double charge, double t_s) noexcept {
  if (off < 0.5 || !std::isnan(m.power_lost_s)) return;
  m.power_lost_s = t_s;
  m.is_empty = charge < 1e-9 ? 1 : 0;
}

/// @param whole  of the tether: less than a half once it has parted
inline void note_line(Milestones& m, double whole, double tension_n, double t_s) noexcept {
  m.most_line_n = std::max(m.most_line_n, tension_n);
  if (whole < 0.5 && std::isnan(m.line_parted_s)) m.line_parted_s = t_s;
}

}  // namespace slackwater::twin
