#include "calibration/day/whole_day.h"

#include <algorithm>
#include <set>
#include <vector>

#include "calibration/day/known_currents.h"
#include "fields/record/leading_dataset.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;
using std::chrono::hours;

/// The column that speaks for the site when days are chosen: the first with currents.
const ColumnData* leading_column(const SiteData& data) {
  for (const ColumnData& column : data.columns) {
    if (!column.current.pieces.empty()) return &column;
  }
  return nullptr;
}

/// Days with any current, newest first, none after the issue time.
std::vector<UtcDay> candidate_days(const ColumnData& column, UtcTime issued) {
  std::set<UtcDay> found;
  for (const auto& piece : column.current.pieces) {
    for (const TimeCell& cell : piece.column.time) {
      const UtcDay day = day_of(cell.centre());
      if (UtcTime(day) + days(1) <= issued) found.insert(day);
    }
  }
  return {found.rbegin(), found.rend()};
}

}  // namespace

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
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  // Instruments that sample finer than hourly are held to what an hourly series is.
  const Duration usual = std::max<Duration>(steps[steps.size() / 2], hours(1));
  const auto too_wide = [&](Duration gap) { return 2 * gap > 5 * usual; };
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (too_wide(cells[i].centre() - cells[i - 1].centre())) return false;
  }
  return cells.front().start - from <= usual && to - cells.back().end <= usual;
}

DayCurrents currents_of_day(const SiteData& data, UtcDay day, UtcTime issued) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return {};
  const UtcTime from(day);
  const UtcTime to = from + days(1);
  const auto dataset = leading_dataset(column->current, from, to);
  if (!dataset) return {};
  ForecastPlan plan;
  plan.day = day;
  plan.issued = issued;
  plan.dataset = *dataset;
  return {slice(known_currents(*column, plan).column, from, to), *dataset};
}

bool holds_day(const SiteData& data, UtcDay day, UtcTime issued) {
  return holds_throughout(currents_of_day(data, day, issued).currents, day);
}

std::optional<UtcDay> newest_whole_day(const SiteData& data, UtcTime issued,
                                       std::optional<UtcDay> latest) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return std::nullopt;
  for (const UtcDay day : candidate_days(*column, issued)) {
    if ((!latest || day <= *latest) && holds_day(data, day, issued)) return day;
  }
  return std::nullopt;
}

}  // namespace slackwater::calibration
