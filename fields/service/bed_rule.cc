#include "fields/service/bed_rule.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace slackwater {
namespace {

/// The deepest level that is above the product's own bed at some time, and was not carried there.
std::optional<std::size_t> deepest_wet_level(const ForecastColumn& column, std::size_t levels) {
  for (std::size_t k = levels; k-- > 0;) {
    for (std::size_t o = k; o < column.current_status.size(); o += levels) {
      const SampleStatus status = column.current_status[o];
      if (status != SampleStatus::below_bed && status != SampleStatus::carried) return k;
    }
  }
  return std::nullopt;
}

}  // namespace

double depth_tolerance_m(double depth_m) noexcept { return std::max(5.0, 0.2 * depth_m); }

double known_to_m(const ForecastColumn& column, std::span<const double> depth_m) noexcept {
  const auto deepest = deepest_wet_level(column, depth_m.size());
  if (!deepest) return std::numeric_limits<double>::infinity();
  const double tolerated = depth_m[*deepest] + depth_tolerance_m(depth_m[*deepest]);
  if (*deepest + 1 == depth_m.size()) return tolerated;
  return std::min(tolerated, depth_m[*deepest + 1] - same_depth_m);
}

void keep_to_bed(ForecastColumn& column, std::span<const double> depth_m) {
  const std::size_t levels = depth_m.size();
  const std::size_t values = column.current_status.size();
  const std::size_t members = values == 0 ? 0 : column.member_m_s.size() / values;
  const auto each_time = [&](std::size_t k, const auto& set) {
    for (std::size_t o = k; o < values; o += levels) set(o);
  };
  for (std::size_t k = 0; k < levels; ++k) {
    if (depth_m[k] <= column.water_depth_m + same_depth_m) continue;
    each_time(k, [&](std::size_t o) {
      column.current_status[o] = SampleStatus::below_bed;
      column.current_m_s[o] = {};
      column.current_sigma_m_s[o] = 0;
      for (std::size_t m = 0; m < members; ++m) column.member_m_s[m * values + o] = {};
    });
  }
  const auto deepest = deepest_wet_level(column, levels);
  if (!deepest) return;
  for (std::size_t k = *deepest + 1; k < levels; ++k) {
    if (!(depth_m[k] <= column.water_depth_m + same_depth_m)) break;
    each_time(k, [&](std::size_t o) {
      const std::size_t from = o - k + *deepest;
      const SampleStatus status = column.current_status[from];
      column.current_status[o] = has_value(status) ? SampleStatus::carried : status;
      column.current_m_s[o] = column.current_m_s[from];
      column.current_sigma_m_s[o] = column.current_sigma_m_s[from];
      for (std::size_t m = 0; m < members; ++m)
        column.member_m_s[m * values + o] = column.member_m_s[m * values + from];
    });
  }
}

}  // namespace slackwater
