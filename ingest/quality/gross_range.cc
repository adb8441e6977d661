#include "ingest/quality/gross_range.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::ingest {
std::size_t test_gross_range(const Range& range, std::span<const float> values,
                             std::span<SampleStatus> status) {
  expects(values.size() == status.size(), "one status for each value");
  std::size_t marked = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!has_value(status[i]) || (values[i] >= range.low && values[i] <= range.high)) continue;
    status[i] = SampleStatus::suspect;
    ++marked;
  }
  return marked;
}

std::size_t test_speed_range(double greatest_speed, std::span<const float> east,
                             std::span<const float> north, std::span<SampleStatus> east_status,
                             std::span<SampleStatus> north_status) {
  expects(east.size() == north.size() && east.size() == east_status.size() &&
              east.size() == north_status.size(),
          "two components and two statuses for each vector");
  std::size_t marked = 0;
  for (std::size_t i = 0; i < east.size(); ++i) {
    if (!has_value(east_status[i]) || !has_value(north_status[i])) continue;
    if (std::hypot(static_cast<double>(east[i]), static_cast<double>(north[i])) <= greatest_speed)
      continue;
    east_status[i] = north_status[i] = SampleStatus::suspect;
    ++marked;
  }
  return marked;
}

}  // namespace slackwater::ingest
