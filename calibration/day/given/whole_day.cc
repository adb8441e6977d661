#include "calibration/day/given/whole_day.h"

#include <algorithm>
#include <vector>

#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {
using std::chrono::days;
using std::chrono::hours;

bool holds_throughout(const VectorColumn& currents, UtcDay day) {
  std::vector<TimeCell> cells;
  for (std::size_t t = 0; t < currents.times(); ++t) {
    if (!belongs_to_day(currents.time[t], day)) continue;
    bool any = false;
    for (std::size_t k = 0; k < currents.levels() && !any; ++k) any = currents.has(t, k);
    if (any) cells.push_back(currents.time[t]);
  }
  if (cells.empty()) return false;
  const UtcTime from(day);
  const UtcTime to = from + days(1);
  // One daily mean (also a 25-hour mean cut at the day's ends) holds the whole day.
  if (cells.size() == 1) return cells[0].end - cells[0].start >= hours(20);
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < cells.size(); ++i)
    steps.push_back(cells[i].centre() - cells[i - 1].centre());
  // Instruments that sample finer than hourly are held to what an hourly series is.
  const Duration usual = std::max<Duration>(upper_median(std::move(steps)), hours(1));
  const auto too_wide = [&](Duration gap) { return 2 * gap > 5 * usual; };
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (too_wide(cells[i].centre() - cells[i - 1].centre())) return false;
  }
  return cells.front().start - from <= usual && to - cells.back().end <= usual;
}

}  // namespace slackwater::calibration
