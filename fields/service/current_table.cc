#include "fields/service/current_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace slackwater {
namespace {

/// So large that the least weight of it, a millisecond in a year, outweighs all water.
constexpr float missing = -1e30F;
constexpr std::size_t buckets = 1024;

/// Four lanes that GCC and Clang know how to add and multiply at once.
typedef float Lanes __attribute__((vector_size(16)));

/// How many levels of the column are above its bed at some time.
std::size_t wet_levels(const ForecastColumn& column, std::size_t levels) {
  std::size_t wet = levels;
  const auto is_dry = [&](std::size_t k) {
    for (std::size_t o = k; o < column.current_status.size(); o += levels) {
      if (column.current_status[o] != SampleStatus::below_bed) return false;
    }
    return true;
  };
  while (wet > 0 && is_dry(wet - 1)) --wet;
  return wet;
}

}  // namespace

CurrentTable::CurrentTable(const Snapshot& snapshot, std::size_t member)
    : levels_(snapshot.depth_m.size()), per_column_(snapshot.time.size() * levels_) {
  const std::size_t times = snapshot.time.size();
  entry_.resize(snapshot.columns.size() * per_column_);
  for (std::size_t c = 0; c < snapshot.columns.size(); ++c) {
    const ForecastColumn& column = snapshot.columns[c];
    const std::span<const Horizontal> current = current_of_member(column, member);
    const std::size_t wet = wet_levels(column, levels_);
    for (std::size_t t = 0; t < times; ++t) {
      for (std::size_t k = 0; k < levels_; ++k) {
        Entry& entry = entry_[c * per_column_ + t * levels_ + k];
        if (wet == 0) continue;
        // Below the deepest wet level its value holds to the bed.
        const std::size_t o = t * levels_ + std::min(k, wet - 1);
        const SampleStatus status =
            column.current_status.empty() ? SampleStatus::missing : column.current_status[o];
        if (status == SampleStatus::land) continue;
        entry.water = missing;
        if (!has_value(status) || o >= current.size()) continue;
        const Horizontal value = current[o];
        const double sigma = member == 0 ? column.current_sigma_m_s[o] : 0.0;
        if (!std::isfinite(value.real() + value.imag() + sigma)) continue;
        entry = {static_cast<float>(value.real()), static_cast<float>(value.imag()),
                 static_cast<float>(sigma), 1.0F};
      }
    }
  }
  for (const double depth : snapshot.depth_m) depth_m_.push_back(static_cast<float>(depth));
  if (levels_ < 2) return;
  for (std::size_t k = 0; k + 1 < levels_; ++k)
    per_step_.push_back(1.0F / (depth_m_[k + 1] - depth_m_[k]));
  const double deepest = snapshot.depth_m.back();
  buckets_per_m_ = static_cast<double>(buckets - 1) / deepest;
  low_.resize(buckets);
  for (std::size_t b = 0; b < buckets; ++b) {
    const double depth = static_cast<double>(b) / buckets_per_m_;
    const auto above = std::upper_bound(snapshot.depth_m.begin(), snapshot.depth_m.end(), depth);
    const auto at_or_above = std::max<std::ptrdiff_t>(1, above - snapshot.depth_m.begin()) - 1;
    low_[b] =
        static_cast<std::uint16_t>(std::min(static_cast<std::size_t>(at_or_above), levels_ - 2));
  }
}

CurrentTable::Level CurrentTable::level_at(double depth_m) const noexcept {
  if (levels_ < 2) return {};
  const auto depth = static_cast<float>(depth_m);
  if (depth <= depth_m_.front()) return {};
  if (depth >= depth_m_.back()) return {levels_ - 2, 1.0F};
  std::size_t low = low_[static_cast<std::size_t>(depth_m * buckets_per_m_)];
  while (low + 2 < levels_ && depth >= depth_m_[low + 1]) ++low;
  return {low, (depth - depth_m_[low]) * per_step_[low]};
}

void CurrentTable::prefetch(const ColumnStencil& stencil, const TimePlace& time,
                            const Level& level) const noexcept {
  const Entry* base = entry_.data() + time.low * levels_ + level.low;
  for (std::uint32_t c = 0; c < stencil.count; ++c) {
    const Entry* e = base + stencil.column[c] * per_column_;
    __builtin_prefetch(e);
    __builtin_prefetch(e + 1);
    __builtin_prefetch(e + levels_);
    __builtin_prefetch(e + levels_ + 1);
  }
}

CurrentSample CurrentTable::at(const ColumnStencil& stencil, const TimePlace& time,
                               const Level& level) const noexcept {
  const std::size_t later = time.upper > 0 ? levels_ : 0;
  const std::size_t deeper = level.lower > 0 ? 1 : 0;
  const Entry* base = entry_.data() + time.low * levels_ + level.low;
  const float upper = static_cast<float>(time.upper);
  const float w11 = upper * level.lower;
  const float w10 = upper - w11;
  const float w01 = level.lower - w11;
  const float w00 = std::max(0.0F, 1.0F - upper - w01);  // rounding must not turn `missing` over
  const auto lanes = [](const Entry* entry) {
    Lanes value;
    std::memcpy(&value, entry, sizeof value);
    return value;
  };
  Lanes sum{0, 0, 0, 0};
  // On a stamp and a level, as tables are asked for, a quarter of the entries says the same to the
  // bit.
  const bool is_on_both = later == 0 && deeper == 0;
  for (std::uint32_t c = 0; c < stencil.count; ++c) {
    const auto w = static_cast<float>(stencil.weight[c]);
    const Entry* e = base + stencil.column[c] * per_column_;
    if (is_on_both) {
      sum += w * lanes(e);
      continue;
    }
    sum += w * (w00 * lanes(e) + w01 * lanes(e + deeper) + w10 * lanes(e + later) +
                w11 * lanes(e + later + deeper));
  }
  CurrentSample sample;
  if (!(sum[3] > 0.0F)) {
    sample.status = SampleStatus::missing;
    return sample;
  }
  const float whole = 1.0F / sum[3];
  sample.velocity_m_s = {static_cast<double>(sum[0] * whole), static_cast<double>(sum[1] * whole)};
  sample.sigma_m_s = static_cast<double>(sum[2] * whole);
  sample.status = SampleStatus::ok;
  return sample;
}

}  // namespace slackwater
