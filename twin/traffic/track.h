#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "twin/body/attitude.h"

namespace slackwater::twin {

/// Where something was reported to be. NED metres from the site's origin, over ground; t_s from the
/// run's epoch.
struct TrackPoint {
  double t_s = 0;
  Triple<double> position_m;
  std::optional<Triple<double>> velocity_m_s;
  std::optional<double> heading_rad;  ///< clockwise from north
};

/// Whether a track says anything of a time.
enum class TrackStatus : std::uint8_t {
  on_track,
  before_start,
  after_end,
  in_gap,  ///< between reports further apart than the rule allows
};

enum class TrackCurve : std::uint8_t {
  straight,  ///< constant velocity between reports
  smooth,    ///< cubic Hermite through the reported positions with the reported velocities
};

/// How a track is read between its reports.
struct TrackRule {
  TrackCurve curve = TrackCurve::smooth;
  /// Twice the longest interval at which vessels report, three minutes (ITU-R M.1371-5, tables 1
  /// and 2): beyond it at least one report was missed.
  double longest_gap_s = 360;
};

/// The state at a time. Position and velocity mean nothing unless `is_known()`.
struct TrackState {
  TrackStatus status = TrackStatus::before_start;
  Triple<double> position_m;
  Triple<double> velocity_m_s;
  std::optional<double> heading_rad;  ///< only where the reports on both sides have one
  [[nodiscard]] bool is_known() const noexcept { return status == TrackStatus::on_track; }
};

/// The way of one vessel, as reported. Immutable.
///
/// Between the reports at t0 and t1 with u = (t - t0)/T, T = t1 - t0, the smooth curve is
///
///   p = (2u^3 - 3u^2 + 1) p0 + (u^3 - 2u^2 + u) T v0 + (3u^2 - 2u^3) p1 + (u^3 - u^2) T v1,
///
/// exact for motion with linearly changing acceleration, with an error of order T^4 otherwise. It
/// needs both velocities, and that neither contradicts the way made (differs from (p1 - p0)/T by
/// more than that speed and 0.5 m/s, which noise at anchor keeps to); else the leg is straight.
class Track {
 public:
  Track() = default;
  /// @throws ContractViolation unless times strictly ascend and all numbers are finite
  explicit Track(std::vector<TrackPoint> points);

  [[nodiscard]] std::span<const TrackPoint> points() const noexcept { return points_; }
  /// Logarithmic in the number of reports; no allocation.
  [[nodiscard]] TrackState at(double t_s, const TrackRule& rule = {}) const noexcept;

 private:
  std::vector<TrackPoint> points_;
};

}  // namespace slackwater::twin
