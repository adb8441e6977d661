#include "tests/support/reference_profile.h"

#include <algorithm>

#include "fields/interpolate/temporal.h"

namespace slackwater::tests {
namespace {

/// Neighbouring levels of a depth and the share of the lower one. The first model level stands for
/// the water above it (products start at 0 to 1 m); below the deepest level its value holds to the
/// bed, where the status ends it.
struct LevelPlace {
  std::size_t low = 0;
  double lower_share = 0;
};

LevelPlace level_of(const std::vector<double>& depth_m, double wanted_m) noexcept {
  if (depth_m.size() < 2 || wanted_m <= depth_m.front()) return {};
  if (wanted_m >= depth_m.back()) return {depth_m.size() - 2, 1.0};
  const auto above = std::upper_bound(depth_m.begin(), depth_m.end(), wanted_m);
  const auto low = static_cast<std::size_t>(above - depth_m.begin()) - 1;
  return {low, (wanted_m - depth_m[low]) / (depth_m[low + 1] - depth_m[low])};
}

}  // namespace

void reference_profile(const Snapshot& snapshot, std::size_t column, UtcTime time,
                       std::span<const double> depths_m, std::span<CurrentSample> out,
                       std::size_t member) noexcept {
  const ForecastColumn& c = snapshot.columns[column];
  const std::size_t levels = snapshot.depth_m.size();
  const std::span<const Horizontal> current = current_of_member(c, member);
  const auto place = place_in(snapshot.time, time);
  if (!place || levels == 0 || current.empty()) {
    for (CurrentSample& sample : out) {
      sample = {};
      sample.status = place ? SampleStatus::missing : SampleStatus::outside_time;
    }
    return;
  }
  const std::size_t t0 = place->low * levels;
  const std::size_t t1 = place->upper > 0 ? t0 + levels : t0;
  // Levels under this column's bed hold nothing: the deepest wet level stands for the water down to
  // the bed.
  std::size_t wet = levels;
  while (wet > 1 && c.current_status[t0 + wet - 1] == SampleStatus::below_bed) --wet;
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    CurrentSample sample;
    const double depth = depths_m[i];
    if (!(depth >= 0)) {
      sample.status = SampleStatus::above_surface;
    } else if (depth > c.water_depth_m) {
      sample.status = SampleStatus::below_bed;
    } else {
      LevelPlace level = level_of(snapshot.depth_m, depth);
      if (level.low + 1 >= wet) level = {wet - 1, 0};
      const std::size_t k0 = level.low;
      const std::size_t k1 = level.lower_share > 0 ? k0 + 1 : k0;
      const double w1 = level.lower_share;
      const double v1 = place->upper;
      sample.status = SampleStatus::ok;
      for (const std::size_t o : {t0 + k0, t0 + k1, t1 + k0, t1 + k1}) {
        if (!has_value(c.current_status[o])) sample.status = c.current_status[o];
      }
      if (has_value(sample.status)) {
        const auto blend = [&](const auto& values) {
          return (1 - v1) * ((1 - w1) * values[t0 + k0] + w1 * values[t0 + k1]) +
                 v1 * ((1 - w1) * values[t1 + k0] + w1 * values[t1 + k1]);
        };
        sample.velocity_m_s = blend(current);
        if (member == 0) sample.sigma_m_s = blend(c.current_sigma_m_s);
      }
    }
    out[i] = sample;
  }
}

}  // namespace slackwater::tests
