#include "fields/service/sea_level.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/service/field.h"

namespace slackwater {
namespace {

/// Of the polynomial between stamps.
constexpr std::size_t most_stamps = 6;

/// Of one column at one time.
struct LevelAt {
  double level_m;
  double sigma_m;
};

LevelAt level_at(const SeaLevel& level, TimePlace time) noexcept {
  double sigma_m = level.sigma_m[time.low];
  if (time.upper > 0) sigma_m += time.upper * (level.sigma_m[time.low + 1] - sigma_m);
  return {smooth_between(level.level_m, time), sigma_m};
}

}  // namespace

SeaLevelQuantiles quantiles_of(const SeaLevelSample& central) noexcept {
  assert(has_value(central.status));
  const double reach_m = constants::normal_p90 * central.sigma_m;
  return {central.level_m - reach_m, central.level_m, central.level_m + reach_m};
}

double smooth_between(std::span<const double> values, TimePlace time) noexcept {
  if (!(time.upper > 0)) return values[time.low];
  const std::size_t count = std::min(most_stamps, values.size());
  const std::size_t before = count / 2 - 1;
  const std::size_t first =
      std::min(time.low > before ? time.low - before : 0, values.size() - count);
  // Lagrange's form.
  const double x = static_cast<double>(time.low - first) + time.upper;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < count; ++j) {
      if (j == i) continue;
      weight *= (x - static_cast<double>(j)) / (static_cast<double>(i) - static_cast<double>(j));
    }
    sum += weight * values[first + i];
  }
  return sum;
}

std::string_view text_of_level_source(DataStatus source) noexcept {
  return source == DataStatus::forecast ? "product forecast" : "harmonic tide";
}

SeaLevelSample Field::level_at_place(const Place& place, std::size_t member) const noexcept {
  const Spot here = spot(place.longitude_deg, place.latitude_deg);
  const std::optional<TimePlace> time = when(place.time);
  if (here.status != SampleStatus::ok) return {0, 0, here.status};
  if (!time) return {0, 0, SampleStatus::outside_time};
  if (member >= level_error_.size()) return {};
  SeaLevelSample sum;
  for (std::uint32_t c = 0; c < here.stencil.count; ++c) {
    const SeaLevel& level = snapshot_->columns[here.stencil.column[c]].sea_level;
    if (level.empty()) return {};
    const LevelAt at = level_at(level, *time);
    sum.level_m += here.stencil.weight[c] * at.level_m;
    sum.sigma_m += here.stencil.weight[c] * at.sigma_m;
  }
  if (!std::isfinite(sum.level_m) || !std::isfinite(sum.sigma_m)) return {};
  sum.status = SampleStatus::ok;
  if (member == 0) return sum;
  sum.level_m += level_error_[member] * sum.sigma_m;
  sum.sigma_m = 0;
  return sum;
}

void Field::sample_sea_level(std::span<const Place> places, std::span<SeaLevelSample> out,
                             std::size_t member) const noexcept {
  for (std::size_t i = 0; i < places.size(); ++i) out[i] = level_at_place(places[i], member);
}

}  // namespace slackwater
