#include "tests/published/joined_dots.h"

#include <Eigen/LU>
#include <algorithm>

namespace slackwater::tests {
namespace {

/// Slopes at the nodes of a cubic through them.
using Slopes = std::vector<double>;

/// The natural spline: second derivatives agree at the nodes and vanish at the ends.
Slopes spline_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd b(n);
  const auto width = [&](Eigen::Index i) {
    return x[static_cast<std::size_t>(i + 1)] - x[static_cast<std::size_t>(i)];
  };
  const auto chord = [&](Eigen::Index i) {
    return (y[static_cast<std::size_t>(i + 1)] - y[static_cast<std::size_t>(i)]) / width(i);
  };
  a(0, 0) = 2;
  a(0, 1) = 1;
  b(0) = 3 * chord(0);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    a(i, i - 1) = 1 / width(i - 1);
    a(i, i) = 2 / width(i - 1) + 2 / width(i);
    a(i, i + 1) = 1 / width(i);
    b(i) = 3 * (chord(i - 1) / width(i - 1) + chord(i) / width(i));
  }
  a(n - 1, n - 2) = 1;
  a(n - 1, n - 1) = 2;
  b(n - 1) = 3 * chord(n - 2);
  const Eigen::VectorXd slopes = a.partialPivLu().solve(b);
  return {slopes.data(), slopes.data() + n};
}

Slopes pchip_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> width(n - 1);
  std::vector<double> chord(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    width[i] = x[i + 1] - x[i];
    chord[i] = (y[i + 1] - y[i]) / width[i];
  }
  Slopes slopes(n);
  slopes.front() = chord.front();
  slopes.back() = chord.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (chord[i - 1] * chord[i] <= 0) continue;
    const double before = 2 * width[i] + width[i - 1];
    const double after = width[i] + 2 * width[i - 1];
    slopes[i] = (before + after) / (before / chord[i - 1] + after / chord[i]);
  }
  return slopes;
}

double component_at(const std::vector<double>& x, const std::vector<double>& y, Joined how,
                    double at) {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()) - 1;
  const double width = x[i + 1] - x[i];
  const double s = (at - x[i]) / width;
  if (how == Joined::linear) return (1 - s) * y[i] + s * y[i + 1];
  const Slopes slopes = how == Joined::spline ? spline_slopes(x, y) : pchip_slopes(x, y);
  return (1 + 2 * s) * (1 - s) * (1 - s) * y[i] + s * (1 - s) * (1 - s) * width * slopes[i] +
         s * s * (3 - 2 * s) * y[i + 1] - s * s * (1 - s) * width * slopes[i + 1];
}

}  // namespace

std::string_view name_of(Joined how) noexcept {
  switch (how) {
    case Joined::linear:
      return "linear";
    case Joined::spline:
      return "natural spline";
    case Joined::pchip:
      return "PCHIP";
  }
  return "";
}

Horizontal joined_at(std::span<const calibration::ProfileLevel> levels, Joined how,
                     double depth_m) {
  std::vector<double> depth;
  std::vector<double> east;
  std::vector<double> north;
  for (const calibration::ProfileLevel& level : levels) {
    depth.push_back(level.depth_m);
    east.push_back(level.current_m_s.real());
    north.push_back(level.current_m_s.imag());
  }
  return {component_at(depth, east, how, depth_m), component_at(depth, north, how, depth_m)};
}

}  // namespace slackwater::tests
