#include "twin/control/allocation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

using ThrustNumbers = std::array<double, most_mounts>;

/// Below this sine of the angle between what an axis needs and what earlier axes use, it is not an
/// axis of its own.
constexpr double least_independence = 0.02;

AxisNumbers effect_of(const Mount& mount, const ThrustRange& range) {
  Spatial<double> wrench = force_at(mount.position_m, mount.direction);
  wrench.angular = wrench.angular - (mount.spin * range.torque_per_thrust_m) * mount.direction;
  return numbers_of(wrench);
}

double size_of(const ThrustRange& range) { return 0.5 * (range.most_n - range.least_n); }

/// Rows of B that are independent, scaled by the thrusters' sizes so that the least square is the
/// weighted one.
struct Rows {
  Eigen::MatrixXd scaled;
  std::vector<WantedAxis> axes;
};

Rows independent_rows(const Allocation& a, std::span<const WantedAxis> wanted,
                      const Eigen::VectorXd& size) {
  Rows rows;
  const auto n = static_cast<Eigen::Index>(a.mounts);
  std::vector<Eigen::VectorXd> basis;
  double longest_arm = 0;
  for (const auto& row : a.effect)
    for (const double e : row) longest_arm = std::max(longest_arm, std::abs(e));
  for (const WantedAxis& want : wanted) {
    const auto& effect = a.effect[static_cast<std::size_t>(want.axis)];
    Eigen::VectorXd row(n);
    for (Eigen::Index i = 0; i < n; ++i) row[i] = effect[static_cast<std::size_t>(i)] * size[i];
    Eigen::VectorXd left = row;
    for (const Eigen::VectorXd& b : basis) left -= b.dot(left) * b;
    const double own = row.norm();
    if (own < 1e-9 * longest_arm * size.norm() || left.norm() < least_independence * own) continue;
    basis.push_back(left.normalized());
    rows.axes.push_back(want);
    rows.scaled.conservativeResize(static_cast<Eigen::Index>(rows.axes.size()), n);
    rows.scaled.bottomRows(1) = row.transpose();
  }
  return rows;
}

ThrustNumbers clipped(const Allocation& a, const ThrustNumbers& t) noexcept {
  ThrustNumbers out{};
  for (std::size_t i = 0; i < most_mounts; ++i)
    out[i] = std::min(std::max(t[i], a.least_n[i]), a.most_n[i]);
  return out;
}

bool is_within(const Allocation& a, const ThrustNumbers& t) noexcept {
  bool within = true;
  for (std::size_t i = 0; i < most_mounts; ++i)
    within &= t[i] >= a.least_n[i] && t[i] <= a.most_n[i];
  return within;
}

/// Towards the ranges without a change of the wrench: the excess is put on those that idle, over
/// and over (projections on convex sets, relaxed by 1.5).
void ease(const Allocation& a, ThrustNumbers& t) noexcept {
  constexpr int rounds = 6;
  constexpr double relaxation = 1.5;
  if (!a.has_idle) return;
  for (int round = 0; round < rounds; ++round) {
    if (is_within(a, t)) return;
    const ThrustNumbers inside = clipped(a, t);
    ThrustNumbers next = t;
    for (std::size_t j = 0; j < a.mounts; ++j) {
      if (inside[j] == t[j]) continue;
      const double excess = relaxation * (inside[j] - t[j]);
      for (std::size_t i = 0; i < most_mounts; ++i) next[i] += a.idle[j][i] * excess;
    }
    t = next;
  }
}

/// The largest share of `more` that fits on top of `t`.
double share_that_fits(const Allocation& a, const ThrustNumbers& t,
                       const ThrustNumbers& more) noexcept {
  double share = 1;
  for (std::size_t i = 0; i < a.mounts; ++i) {
    const double room = more[i] > 0 ? a.most_n[i] - t[i] : a.least_n[i] - t[i];
    if (std::abs(more[i]) * share > std::abs(room)) share = room / more[i];
  }
  return std::clamp(share, 0.0, 1.0);
}

void add(const Allocation& a, std::size_t axis, double amount, ThrustNumbers& t) noexcept {
  for (std::size_t i = 0; i < most_mounts; ++i) t[i] += a.inverse[axis][i] * amount;
}

/// The share of a level's wrench that its axes could do one by one: what is asked far beyond it
/// would leave `ease` no chance. Infinite and huge demands end here.
double share_in_reach(const Allocation& a, const AxisNumbers& wrench, std::size_t level) noexcept {
  double share = 1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const double reach = wrench[axis] > 0 ? a.most_ahead[axis] : a.most_astern[axis];
    if (a.is_commanded[axis] && a.level[axis] == level && reach > 0)
      share = std::min(share, reach / std::max(std::abs(wrench[axis]), reach));
  }
  return share;
}

Thrusts allocate_by_level(const Allocation& a, const AxisNumbers& wrench) noexcept {
  Thrusts out;
  for (std::size_t level = 0; level < a.levels; ++level) {
    const double in_reach = share_in_reach(a, wrench, level);
    ThrustNumbers all = out.thrust_n;
    for (std::size_t axis = 0; axis < axes; ++axis)
      if (a.is_commanded[axis] && a.level[axis] == level)
        add(a, axis, in_reach * wrench[axis], all);
    ease(a, all);
    ThrustNumbers more{};
    for (std::size_t i = 0; i < most_mounts; ++i) more[i] = all[i] - out.thrust_n[i];
    const double share = share_that_fits(a, out.thrust_n, more);
    for (std::size_t i = 0; i < most_mounts; ++i) out.thrust_n[i] += share * more[i];
    for (std::size_t axis = 0; axis < axes; ++axis)
      if (a.is_commanded[axis] && a.level[axis] == level) out.share[axis] = share * in_reach;
  }
  out.thrust_n = clipped(a, out.thrust_n);  // rounding
  return out;
}

/// The most along one axis alone, by halving.
double reach_along(const Allocation& a, std::size_t axis, double sign) {
  double low = 0, high = 0;
  for (std::size_t i = 0; i < a.mounts; ++i)
    high += std::abs(a.effect[axis][i]) * std::max(a.most_n[i], -a.least_n[i]);
  for (int i = 0; i < 50; ++i) {
    AxisNumbers wrench{};
    wrench[axis] = sign * 0.5 * (low + high);
    // The last thousandth of a projection is long in coming.
    const bool is_had = allocate_by_level(a, wrench).share[axis] > 1 - 1e-3;
    (is_had ? low : high) = 0.5 * (low + high);
  }
  return (1 - 1e-3) * low;
}

}  // namespace

Allocation plan_allocation(std::span<const Mount> mounts, std::span<const ThrustRange> ranges,
                           std::span<const WantedAxis> wanted) {
  expects(!mounts.empty() && mounts.size() <= most_mounts && mounts.size() == ranges.size(),
          "one to eight mounts, each with its range");
  Allocation a;
  a.mounts = mounts.size();
  Eigen::VectorXd size(static_cast<Eigen::Index>(a.mounts));
  for (std::size_t i = 0; i < a.mounts; ++i) {
    expects(ranges[i].least_n <= 0 && ranges[i].most_n > 0 && std::isfinite(size_of(ranges[i])),
            "a thruster can stand still and push");
    a.least_n[i] = ranges[i].least_n;
    a.most_n[i] = ranges[i].most_n;
    size[static_cast<Eigen::Index>(i)] = size_of(ranges[i]);
    const AxisNumbers effect = effect_of(mounts[i], ranges[i]);
    for (std::size_t axis = 0; axis < axes; ++axis) a.effect[axis][i] = effect[axis];
  }
  const Rows rows = independent_rows(a, wanted, size);
  if (rows.axes.empty()) return a;
  const Eigen::MatrixXd& b = rows.scaled;
  const Eigen::MatrixXd inverse =
      b.transpose() *
      (b * b.transpose()).llt().solve(Eigen::MatrixXd::Identity(b.rows(), b.rows()));
  const Eigen::MatrixXd plain = size.asDiagonal() * inverse;
  for (std::size_t k = 0; k < rows.axes.size(); ++k) {
    const auto axis = static_cast<std::size_t>(rows.axes[k].axis);
    expects(rows.axes[k].level < most_levels, "levels are counted from zero and few");
    a.is_commanded[axis] = true;
    a.level[axis] = rows.axes[k].level;
    a.levels = std::max(a.levels, a.level[axis] + 1);
    for (std::size_t i = 0; i < a.mounts; ++i)
      a.inverse[axis][i] = plain(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
  }
  for (std::size_t j = 0; j < a.mounts; ++j) {
    for (std::size_t i = 0; i < a.mounts; ++i) {
      double used = 0;
      for (std::size_t axis = 0; axis < axes; ++axis)
        used += a.inverse[axis][i] * (a.is_commanded[axis] ? a.effect[axis][j] : 0.0);
      a.idle[j][i] = (i == j ? 1.0 : 0.0) - used;
      a.has_idle = a.has_idle || std::abs(a.idle[j][i]) > 1e-9;
    }
  }
  AxisNumbers ahead{}, astern{};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    if (!a.is_commanded[axis]) continue;
    ahead[axis] = reach_along(a, axis, 1);
    astern[axis] = reach_along(a, axis, -1);
  }
  a.most_ahead = ahead;
  a.most_astern = astern;
  return a;
}

Thrusts allocate(const Allocation& a, const Spatial<double>& wrench) noexcept {
  const AxisNumbers asked = numbers_of(wrench);
  Thrusts out;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    add(a, axis, asked[axis], out.thrust_n);
    out.share[axis] = a.is_commanded[axis] ? 1.0 : 0.0;
  }
  if (is_within(a, out.thrust_n)) return out;
  return allocate_by_level(a, asked);
}

Spatial<double> wrench_of(const Allocation& a,
                          const std::array<double, most_mounts>& thrust_n) noexcept {
  AxisNumbers w{};
  for (std::size_t axis = 0; axis < axes; ++axis)
    for (std::size_t i = 0; i < most_mounts; ++i) w[axis] += a.effect[axis][i] * thrust_n[i];
  return {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
}

}  // namespace slackwater::twin
