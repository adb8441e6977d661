#include "twin/account/manoeuvre_figures.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

using constants::pi;
using ManoeuvreRows = std::span<const ManoeuvreRow>;

/// A row as it goes on until a time: at its velocity and its rate of turn.
ManoeuvreRow carried_on(const ManoeuvreRow& row, double t_s) {
  const double for_s = t_s - row.t_s;
  const double c = std::cos(row.heading_rad), s = std::sin(row.heading_rad);
  ManoeuvreRow out = row;
  out.t_s = t_s;
  out.north_m += for_s * (c * row.ahead_m_s - s * row.starboard_m_s);
  out.east_m += for_s * (s * row.ahead_m_s + c * row.starboard_m_s);
  out.heading_rad += for_s * row.turn_rad_s;
  return out;
}

/// The rows from a time on, with headings that do not jump. Where that is between two rows it
/// begins as the first of them goes on: what happens at that time shows in the second one alone.
std::vector<ManoeuvreRow> unwrapped_from(ManoeuvreRows rows, double from_s) {
  std::vector<ManoeuvreRow> out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ManoeuvreRow& row = rows[i];
    if (row.t_s < from_s) continue;
    if (out.empty() && i > 0 && row.t_s > from_s) out.push_back(carried_on(rows[i - 1], from_s));
    out.push_back(row);
    if (out.size() < 2) continue;
    const double before_rad = out[out.size() - 2].heading_rad;
    out.back().heading_rad = before_rad + wrapped_rad(row.heading_rad - before_rad);
  }
  return out;
}

double speed_of(const ManoeuvreRow& row) { return std::hypot(row.ahead_m_s, row.starboard_m_s); }

/// A time and a place between two rows.
struct Passing {
  double t_s = 0;
  double north_m = 0;
  double east_m = 0;
};

/// A side, +1 to starboard, and the course that headings to it are counted from.
struct Side {
  double sign = 1;
  double course_rad = 0;
  [[nodiscard]] double turned_rad(const ManoeuvreRow& row) const {
    return sign * (row.heading_rad - course_rad);
  }
};

/// Where the heading first comes to an angle.
std::optional<Passing> passing_of(ManoeuvreRows rows, const Side& side, double angle_rad) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double before = side.turned_rad(rows[i - 1]) - angle_rad;
    const double after = side.turned_rad(rows[i]) - angle_rad;
    if (!(before < 0 && after >= 0)) continue;
    const double share = before / (before - after);
    const auto between = [&](double a, double b) { return a + share * (b - a); };
    return Passing{between(rows[i - 1].t_s, rows[i].t_s),
                   between(rows[i - 1].north_m, rows[i].north_m),
                   between(rows[i - 1].east_m, rows[i].east_m)};
  }
  return std::nullopt;
}

/// Fewer tell nothing of how steady a rate is.
constexpr std::size_t least_rows = 5;

/// Mean and largest difference from it.
struct Spread {
  double mean = 0;
  double most_off = 0;
};
template <typename Of>
Spread spread_of(ManoeuvreRows rows, const Of& of) {
  Spread spread;
  for (const ManoeuvreRow& row : rows) spread.mean += of(row) / static_cast<double>(rows.size());
  for (const ManoeuvreRow& row : rows)
    spread.most_off = std::max(spread.most_off, std::abs(of(row) - spread.mean));
  return spread;
}

double turn_of(const ManoeuvreRow& row) { return row.turn_rad_s; }

/// The last fifth of their time.
ManoeuvreRows last_fifth(ManoeuvreRows rows) {
  if (rows.empty()) return rows;
  const double from_s = rows.back().t_s - 0.2 * (rows.back().t_s - rows.front().t_s);
  const auto first = std::find_if(rows.begin(), rows.end(),
                                  [&](const ManoeuvreRow& row) { return row.t_s >= from_s; });
  return rows.subspan(static_cast<std::size_t>(first - rows.begin()));
}

std::optional<SteadyTurn> steady_of(ManoeuvreRows rows, const Side& side) {
  const double end_rad = side.turned_rad(rows.back());
  const auto first = std::find_if(rows.begin(), rows.end(), [&](const ManoeuvreRow& row) {
    return side.turned_rad(row) >= end_rad - 0.5 * pi;
  });
  const ManoeuvreRows last = rows.subspan(static_cast<std::size_t>(first - rows.begin()));
  const bool has_quarter = end_rad >= 0.5 * pi;
  const Spread turn = spread_of(last, turn_of);
  if (!has_quarter || !(turn.most_off <= 0.02 * std::abs(turn.mean))) return std::nullopt;
  const double ahead_m_s =
      spread_of(last, [](const ManoeuvreRow& row) { return row.ahead_m_s; }).mean;
  const double starboard_m_s =
      spread_of(last, [](const ManoeuvreRow& row) { return row.starboard_m_s; }).mean;
  SteadyTurn steady;
  steady.turn_rad_s = turn.mean;
  steady.speed_m_s = std::hypot(ahead_m_s, starboard_m_s);
  steady.radius_m = steady.speed_m_s / std::abs(turn.mean);
  steady.drift_rad = std::atan2(-starboard_m_s, ahead_m_s);
  steady.speed_kept = steady.speed_m_s / speed_of(rows.front());
  return steady;
}

double track_m(ManoeuvreRows rows, const Passing& until) {
  double sum_m = 0;
  ManoeuvreRow before = rows.front();
  for (const ManoeuvreRow& row : rows) {
    if (row.t_s > until.t_s) break;
    sum_m += std::hypot(row.north_m - before.north_m, row.east_m - before.east_m);
    before = row;
  }
  return sum_m + std::hypot(until.north_m - before.north_m, until.east_m - before.east_m);
}

/// How far the heading goes until it turns back, where the rate, straight between rows, is 0;
/// nothing where the rows end before that.
std::optional<double> top_of(ManoeuvreRows rows, const Side& side) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double before = side.sign * rows[i - 1].turn_rad_s;
    const double after = side.sign * rows[i].turn_rad_s;
    if (!(after <= 0)) continue;
    const double until_s =
        before > 0 ? before / (before - after) * (rows[i].t_s - rows[i - 1].t_s) : 0.0;
    return side.turned_rad(rows[i - 1]) + 0.5 * before * until_s;
  }
  return std::nullopt;
}

/// Where a straight line between two points is 0.
double zero_between(double x0, double y0, double x1, double y1) {
  return y0 == y1 ? 0.5 * (x0 + x1) : x0 - y0 * (x1 - x0) / (y1 - y0);
}

/// One way of a spiral.
struct SpiralWay {
  std::optional<double> side_at_rad;  ///< the helm at which the rate changes its side
  std::optional<double> rate_at_0;
};
SpiralWay way_of_spiral(std::span<const SpiralPoint> points, double down) {
  SpiralWay way;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SpiralPoint& at = points[i];
    const bool goes_on = i + 1 < points.size() && down * (points[i + 1].helm_rad - at.helm_rad) < 0;
    const bool came = i > 0 && down * (at.helm_rad - points[i - 1].helm_rad) < 0;
    if ((goes_on || came) && std::abs(at.helm_rad) < 1e-9) way.rate_at_0 = at.turn_rad_s;
    if (!goes_on) continue;
    const SpiralPoint& next = points[i + 1];
    if (down * at.turn_rad_s > 0 && down * next.turn_rad_s <= 0)
      way.side_at_rad = zero_between(at.helm_rad, at.turn_rad_s, next.helm_rad, next.turn_rad_s);
  }
  return way;
}

}  // namespace

std::vector<ManoeuvreRow> manoeuvre_rows(const VehicleRows& log) {
  const auto x = log.column("x"), y = log.column("y"), yaw = log.column("yaw");
  const auto velocity = log.column("velocity_body"), rate = log.column("rate_body");
  const auto rudder = log.column("rudder");
  std::vector<ManoeuvreRow> rows;
  if (y.size() != x.size() || yaw.size() != x.size() || velocity.size() != 3 * x.size() ||
      rate.size() != 3 * x.size())
    return rows;
  for (std::size_t i = 0; i < std::min(x.size(), log.t_s.size()); ++i) {
    if (!std::isfinite(x[i])) continue;
    ManoeuvreRow& row = rows.emplace_back();
    row.t_s = log.t_s[i];
    row.north_m = y[i];
    row.east_m = x[i];
    row.heading_rad = yaw[i];
    row.ahead_m_s = velocity[3 * i];
    row.starboard_m_s = velocity[3 * i + 1];
    row.turn_rad_s = rate[3 * i + 2];
    if (i < rudder.size() && std::isfinite(rudder[i])) row.helm_rad = rudder[i];
  }
  return rows;
}

TurningCircle turning_circle(std::span<const ManoeuvreRow> all, double execute_s) {
  TurningCircle circle;
  const std::vector<ManoeuvreRow> rows = unwrapped_from(all, execute_s);
  if (rows.size() < 2) return circle;
  const ManoeuvreRow& from = rows.front();
  const Side side{rows.back().heading_rad >= from.heading_rad ? 1.0 : -1.0, from.heading_rad};
  circle.to_starboard = side.sign > 0;
  const double c = std::cos(from.heading_rad), s = std::sin(from.heading_rad);
  const auto along_m = [&](const Passing& at) {
    return c * (at.north_m - from.north_m) + s * (at.east_m - from.east_m);
  };
  const auto across_m = [&](const Passing& at) {
    return side.sign * (c * (at.east_m - from.east_m) - s * (at.north_m - from.north_m));
  };
  const auto time_at = [&](double angle_rad) -> std::optional<double> {
    const auto at = passing_of(rows, side, angle_rad);
    return at ? std::optional(at->t_s - from.t_s) : std::nullopt;
  };
  if (const auto at = passing_of(rows, side, 0.5 * pi)) {
    circle.advance_m = along_m(*at);
    circle.transfer_m = across_m(*at);
  }
  if (const auto at = passing_of(rows, side, pi)) circle.tactical_diameter_m = across_m(*at);
  circle.quarter_s = time_at(0.5 * pi);
  circle.half_s = time_at(pi);
  circle.three_quarters_s = time_at(1.5 * pi);
  circle.full_s = time_at(2 * pi);
  circle.steady = steady_of(rows, side);
  return circle;
}

ZigZag zig_zag(std::span<const ManoeuvreRow> all, double execute_s, double heading_rad) {
  ZigZag out;
  const std::vector<ManoeuvreRow> kept = unwrapped_from(all, execute_s);
  const ManoeuvreRows rows = kept;
  if (rows.empty()) return out;
  const auto first_out = std::find_if(rows.begin(), rows.end(), [&](const ManoeuvreRow& row) {
    return std::abs(row.heading_rad - rows[0].heading_rad) >= heading_rad;
  });
  if (first_out == rows.end()) return out;
  Side side{first_out->heading_rad > rows[0].heading_rad ? 1.0 : -1.0, rows[0].heading_rad};
  for (ManoeuvreRows left = rows; const auto at = passing_of(left, side, heading_rad);) {
    if (out.execute_s.empty()) out.initial_turning_m = track_m(rows, *at);
    const auto next = std::find_if(left.begin(), left.end(),
                                   [&](const ManoeuvreRow& row) { return row.t_s >= at->t_s; });
    left = left.subspan(static_cast<std::size_t>(next - left.begin()));
    const auto top_rad = top_of(left, side);
    if (!top_rad) break;
    out.execute_s.push_back(at->t_s - rows.front().t_s);
    out.overshoot_rad.push_back(*top_rad - heading_rad);
    side.sign = -side.sign;
  }
  if (const std::size_t n = out.execute_s.size(); n >= 3)
    out.period_s = out.execute_s[n - 1] - out.execute_s[n - 3];
  return out;
}

Spiral spiral(std::span<const ManoeuvreRow> rows) {
  Spiral out;
  double largest = 0;
  for (const ManoeuvreRow& row : rows) largest = std::max(largest, std::abs(row.turn_rad_s));
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first + 1;
    while (end < rows.size() && rows[end].helm_rad == rows[first].helm_rad) ++end;
    const ManoeuvreRows last = last_fifth(rows.subspan(first, end - first));
    const Spread turn = spread_of(last, turn_of);
    const bool is_steady = last.size() >= least_rows && turn.most_off <= 0.01 * largest;
    out.points.push_back({rows[first].helm_rad, turn.mean, is_steady});
    first = end;
  }
  const SpiralWay down = way_of_spiral(out.points, 1), up = way_of_spiral(out.points, -1);
  if (down.side_at_rad && up.side_at_rad)
    out.loop_width_rad = std::max(0.0, *up.side_at_rad - *down.side_at_rad);
  if (down.rate_at_0 && up.rate_at_0)
    out.loop_height_rad_s = std::max(0.0, *down.rate_at_0 - *up.rate_at_0);
  return out;
}

double residual_turn_rad_s(std::span<const ManoeuvreRow> rows, double midships_s) {
  const std::vector<ManoeuvreRow> after = unwrapped_from(rows, midships_s);
  return after.empty() ? 0 : spread_of(last_fifth(after), turn_of).mean;
}

StepResponse step_response(std::span<const double> t_s, std::span<const double> value, double from,
                           double to) {
  StepResponse out;
  const std::size_t count = std::min(t_s.size(), value.size());
  if (count == 0 || from == to) return out;
  const auto share_at = [&](std::size_t i) { return (value[i] - from) / (to - from); };
  const auto time_to = [&](double share) -> std::optional<double> {
    for (std::size_t i = 1; i < count; ++i)
      if (share_at(i - 1) < share && share_at(i) >= share)
        return zero_between(t_s[i - 1], share_at(i - 1) - share, t_s[i], share_at(i) - share) -
               t_s[0];
    return std::nullopt;
  };
  const auto low_s = time_to(0.1), high_s = time_to(0.9);
  if (low_s && high_s) out.rise_s = *high_s - *low_s;
  out.time_63_s = time_to(1 - std::exp(-1.0));
  for (std::size_t i = 0; i < count; ++i) out.overshoot = std::max(out.overshoot, share_at(i) - 1);
  // The last time that it was outside.
  for (std::size_t i = count; i-- > 0;) {
    if (std::abs(share_at(i) - 1) <= 0.05) continue;
    if (i + 1 < count) {
      const double bound = share_at(i) > 1 ? 1.05 : 0.95;
      out.settling_s =
          zero_between(t_s[i], share_at(i) - bound, t_s[i + 1], share_at(i + 1) - bound) - t_s[0];
    }
    break;
  }
  const double from_s = t_s[count - 1] - 0.2 * (t_s[count - 1] - t_s[0]);
  double sum = 0, rows = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (t_s[i] < from_s) continue;
    sum += value[i] - to;
    ++rows;
  }
  out.steady_error = sum / rows;
  return out;
}

}  // namespace slackwater::twin
