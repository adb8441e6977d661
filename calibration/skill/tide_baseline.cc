#include "calibration/skill/tide_baseline.h"

#include <array>
#include <string_view>
#include <vector>

namespace slackwater::calibration {

std::optional<TideFit> tide_of_last_15_days(const LevelSeries& series, UtcDay day) {
  static constexpr std::array<std::string_view, 5> names{"M2", "S2", "K1", "O1", "M4"};
  const UtcTime end = end_of_day(day);
  const UtcTime start = end - std::chrono::days(15);
  if (series.empty() || series.time.front().start > start) return std::nullopt;
  LevelSeries last;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series.time[i].start < start || series.time[i].end > end) continue;
    last.time.push_back(series.time[i]);
    last.value.push_back(series.value[i]);
  }
  if (last.size() < 1 + 2 * names.size()) return std::nullopt;
  const std::vector<SampleStatus> status(last.size(), SampleStatus::ok);
  return fit_prescribed_tide(last.time, last.value, status, names);
}

}  // namespace slackwater::calibration
