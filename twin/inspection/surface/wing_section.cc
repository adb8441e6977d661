#include "twin/inspection/surface/wing_section.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

double half_thickness(double x, double t) {
  return 5 * t *
         (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * -0.1036))));
}

double camber_line(double x, double m) {
  constexpr double p = 0.4;
  return x < p ? m * (2 * p * x - x * x) / (p * p)
               : m * (1 - 2 * p + 2 * p * x - x * x) / ((1 - p) * (1 - p));
}

}  // namespace

WingSection::WingSection(double thickness, double camber) {
  expects(thickness > 0, "a section has a thickness");
  constexpr int half = 120;  // points of a side, dense at both edges
  for (int i = -half; i <= half; ++i) {
    const double x = 0.5 * (1 - std::cos(constants::pi * std::abs(i) / half));
    const double side = i < 0 ? -1 : 1;
    points_.push_back({x, camber_line(x, camber) + side * half_thickness(x, thickness)});
  }
  points_.back() = points_.front();  // one edge, whatever rounding says
  length_.push_back(0);
  for (std::size_t i = 1; i < points_.size(); ++i)
    length_.push_back(length_.back() +
                      std::hypot(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y));
}

SectionPoint WingSection::at(double share) const {
  const double length = share * girth();
  const auto next = std::clamp(std::upper_bound(length_.begin(), length_.end(), length),
                               length_.begin() + 1, length_.end() - 1);
  const auto i = static_cast<std::size_t>(next - length_.begin());
  const double part =
      std::clamp((length - length_[i - 1]) / (length_[i] - length_[i - 1]), 0.0, 1.0);
  return {points_[i - 1].x + part * (points_[i].x - points_[i - 1].x),
          points_[i - 1].y + part * (points_[i].y - points_[i - 1].y)};
}

}  // namespace slackwater::twin
