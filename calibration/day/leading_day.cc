#include "calibration/day/leading_day.h"

#include <set>
#include <vector>

#include "calibration/day/known_currents.h"
#include "calibration/day/whole_day.h"
#include "fields/record/leading_dataset.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;

/// A product that held no day within this is no longer the one that leads.
constexpr days remembered(7);
/// Its last good day serves this long.
constexpr days patience(2);

/// The column that speaks for the site when days are chosen: the first with currents.
const ColumnData* leading_column(const SiteData& data) {
  for (const ColumnData& column : data.columns) {
    if (!column.current.pieces.empty()) return &column;
  }
  return nullptr;
}

Knowledge knowledge_of(UtcDay day, const DaysKnown& known) {
  return {UtcTime(day) + days(1), known.issued, UtcTime::min(), known.seen_by};
}

/// Days with any current, newest first, none after the issue time.
std::vector<UtcDay> candidate_days(const ColumnData& column, const DaysKnown& known) {
  std::set<UtcDay> found;
  for (const auto& piece : column.current.pieces) {
    for (const TimeCell& cell : piece.column.time) {
      const UtcDay day = day_of(cell.centre());
      if (UtcTime(day) + days(1) <= known.issued && (!known.latest || day <= *known.latest))
        found.insert(day);
    }
  }
  return {found.rbegin(), found.rend()};
}

/// The dataset that leads on a day and holds it throughout.
std::optional<std::string> holder_of(const SiteData& data, const ColumnData& column, UtcDay day,
                                     const DaysKnown& known) {
  auto dataset = trusted_dataset(column, day, known.issued, known.seen_by);
  if (!dataset || !holds_day(data, *dataset, day, known)) return std::nullopt;
  return dataset;
}

const Origin* origin_of(const ColumnData& column, const std::string& dataset) {
  for (const auto& piece : column.current.pieces)
    if (piece.origin->dataset == dataset) return piece.origin;
  return nullptr;
}

}  // namespace

VectorColumn currents_of_day(const SiteData& data, const std::string& dataset, UtcDay day,
                             const DaysKnown& known) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return {};
  ForecastPlan plan;
  plan.day = day;
  plan.issued = known.issued;
  plan.seen_by = known.seen_by;
  plan.dataset = dataset;
  return slice(known_currents(*column, plan).column, UtcTime(day), plan.end_of_day());
}

bool holds_day(const SiteData& data, const std::string& dataset, UtcDay day,
               const DaysKnown& known) {
  return holds_throughout(currents_of_day(data, dataset, day, known), day);
}

std::optional<LeadingDay> leading_day(const SiteData& data, const DaysKnown& known) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return std::nullopt;
  std::optional<LeadingDay> newest;
  for (const UtcDay day : candidate_days(*column, known)) {
    if (!newest) {
      const auto holder = holder_of(data, *column, day, known);
      if (!holder) continue;
      newest = {day, *holder, {}};
      if (is_in_situ(*origin_of(*column, *holder))) return newest;
      const auto leading =
          leading_product(column->current, UtcTime(day) - remembered, UtcTime(day) + days(1),
                          knowledge_of(day, known), data.site.current_product);
      if (!leading || *leading == *holder) return newest;
      newest->stands_in_for = *leading;
      if (!holds_day(data, *leading, day, known)) continue;
    }
    if (newest->day - day > patience) return newest;
    if (holds_day(data, newest->stands_in_for, day, known))
      return LeadingDay{day, newest->stands_in_for, {}};
  }
  return newest;
}

}  // namespace slackwater::calibration
