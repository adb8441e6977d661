#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fields/service/field.h"

namespace slackwater {

/// Every point x time x depth of a table of samples; depth fastest, then time.
struct SampleGrid {
  std::vector<GeoPoint> points;
  std::vector<UtcTime> time;
  std::vector<double> depth_m;

  [[nodiscard]] std::size_t per_point() const noexcept { return time.size() * depth_m.size(); }
};

/// How many places have which status.
using StatusCounts = std::array<std::size_t, sample_status_count>;

/// The samples of some consecutive points: status of the central forecast, and the components of
/// one member; `no_value` where there is none.
struct SampleBlock {
  std::size_t first_point = 0;
  std::size_t member = 0;
  std::span<const float> east_m_s;
  std::span<const float> north_m_s;
  std::span<const std::int8_t> status;
};

/// Samples `members` members of the field, points in blocks of bounded memory, and hands each block
/// on: for every block the central forecast first. The same numbers on any count of threads.
StatusCounts sample_points(const Field& field, const SampleGrid& grid, std::size_t members,
                           float no_value, const std::function<void(const SampleBlock&)>& take);

}  // namespace slackwater
