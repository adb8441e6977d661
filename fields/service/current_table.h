#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "fields/interpolate/temporal.h"
#include "fields/service/column_layout.h"
#include "fields/service/place.h"

namespace slackwater {

/// The current of all columns of one member, laid out for sampling: levels beside each other, then
/// times, then columns, in single precision (rounded by less than 1e-6 m/s).
///
/// Each entry carries beside its value whether it has one: 1 water, 0 never water (land, below the
/// column's bed), and a large negative number where a value is missing for a time, so that one
/// weighted sum tells the value, the weight of the water, and whether anything is missing in it.
class CurrentTable {
 public:
  CurrentTable() = default;
  /// @param member  0: with sigma; another: without. Columns that do not hold it are missing.
  CurrentTable(const Snapshot& snapshot, std::size_t member);

  /// A depth within the levels: between `low` and the next, `lower` the share of the next.
  struct Level {
    std::size_t low = 0;
    float lower = 0;
  };
  [[nodiscard]] Level level_at(double depth_m) const noexcept;

  /// Asks the memory for what `at` will read.
  void prefetch(const ColumnStencil& stencil, const TimePlace& time,
                const Level& level) const noexcept;
  /// Value at a place in water: weights of the stencil need not sum to one.
  [[nodiscard]] CurrentSample at(const ColumnStencil& stencil, const TimePlace& time,
                                 const Level& level) const noexcept;

 private:
  struct alignas(16) Entry {
    float east = 0;
    float north = 0;
    float sigma = 0;
    float water = 0;
  };
  std::size_t levels_ = 0;
  std::size_t per_column_ = 0;  ///< entries of one column
  std::vector<Entry> entry_;    ///< columns x times x levels
  std::vector<float> depth_m_;
  std::vector<float> per_step_;     ///< 1/(depth of the next level less its own)
  std::vector<std::uint16_t> low_;  ///< of each bucket of depth, the level at or above its top
  double buckets_per_m_ = 0;
};

}  // namespace slackwater
