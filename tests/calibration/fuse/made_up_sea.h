#pragma once
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "fields/base/numbers/random.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration::tests {

inline constexpr UtcTime sea_start = UtcDay(std::chrono::year(2024) / 3 / 1);

/// (hour, depth in m) -> east + i north.
using FlowOfHours = std::function<Horizontal(double, double)>;

/// A column of instants, or of means that are taken for their middle.
inline VectorColumn made_up_column(const std::vector<double>& depths_m, double hours, double step_h,
                                   const FlowOfHours& flow, bool means = false) {
  VectorColumn out;
  out.vertical = VerticalKind::depth_m;
  out.levels_m = depths_m;
  const int times = static_cast<int>(hours / step_h + 1e-9) + (means ? 0 : 1);
  for (int t = 0; t < times; ++t) {
    const UtcTime time = add_hours(sea_start, t * step_h);
    out.time.push_back(means ? TimeCell{time, add_hours(time, step_h)} : TimeCell::instant(time));
    out.source.push_back(DataStatus::analysis);
    for (const double depth : depths_m) {
      out.value.push_back(flow((t + (means ? 0.5 : 0)) * step_h, depth));
      out.status.push_back(SampleStatus::ok);
    }
  }
  return out;
}

/// A red process, linear between hours.
class RedSeries {
 public:
  RedSeries(Rng& random, double sigma_m_s, double memory_h, int hours) {
    const double a = std::exp(-1 / memory_h);
    Horizontal x = sigma_m_s * Horizontal{random.normal(), random.normal()};
    for (int h = 0; h <= hours + 1; ++h) {
      value_.push_back(x);
      x = a * x + sigma_m_s * std::sqrt(1 - a * a) * Horizontal{random.normal(), random.normal()};
    }
  }
  [[nodiscard]] Horizontal at(double hour) const {
    const double inside = std::clamp(hour, 0.0, static_cast<double>(value_.size()) - 1.001);
    const auto low = static_cast<std::size_t>(inside);
    const double share = inside - static_cast<double>(low);
    return (1 - share) * value_[low] + share * value_[low + 1];
  }

 private:
  std::vector<Horizontal> value_;
};

/// The rotary parts of a tide of period `period_h`: anticlockwise and clockwise, with their phases.
struct RotaryTide {
  Horizontal anticlockwise;
  Horizontal clockwise;
  double period_h = 12.4206;

  [[nodiscard]] Horizontal at(double hour) const {
    const double turn = 2 * std::numbers::pi * hour / period_h;
    return anticlockwise * std::polar(1.0, turn) + clockwise * std::polar(1.0, -turn);
  }
};

}  // namespace slackwater::calibration::tests
