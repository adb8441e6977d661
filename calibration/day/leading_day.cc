#include "calibration/day/leading_day.h"

#include <set>
#include <vector>

#include "calibration/day/given/known_currents.h"
#include "calibration/day/given/whole_day.h"
#include "fields/base/numbers/averaging.h"
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

/// The day as a dataset holds it; nothing where it does not hold it throughout.
std::optional<LeadingDay> day_held(const std::string& dataset, const Chosen<Horizontal>& record,
                                   UtcDay day) {
  const VectorColumn currents = slice(record.column, UtcTime(day), UtcTime(day) + days(1));
  if (!holds_throughout(currents, day)) return std::nullopt;
  return LeadingDay{day, dataset, {}, averaging_of(currents.time)};
}

/// The same of the dataset that leads on the day.
std::optional<LeadingDay> held_by_leader(const ColumnData& column, UtcDay day,
                                         const DaysKnown& known) {
  const auto leader = trusted_currents(column, day, known.issued, known.seen_by);
  if (!leader) return std::nullopt;
  return day_held(leader->dataset, leader->record, day);
}

/// The same of this dataset.
std::optional<LeadingDay> held_by(const std::string& dataset, const ColumnData& column, UtcDay day,
                                  const DaysKnown& known) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = known.issued;
  plan.seen_by = known.seen_by;
  plan.dataset = dataset;
  return day_held(dataset, known_currents(column, plan).record, day);
}

const Origin* origin_of(const ColumnData& column, const std::string& dataset) {
  for (const auto& piece : column.current.pieces)
    if (piece.origin->dataset == dataset) return piece.origin;
  return nullptr;
}

}  // namespace

bool holds_day(const SiteData& data, const std::string& dataset, UtcDay day,
               const DaysKnown& known) {
  const ColumnData* column = leading_column(data);
  return column != nullptr && held_by(dataset, *column, day, known).has_value();
}

std::optional<LeadingDay> leading_day(const SiteData& data, const DaysKnown& known) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return std::nullopt;
  std::optional<LeadingDay> newest;
  for (const UtcDay day : candidate_days(*column, known)) {
    if (!newest) {
      newest = held_by_leader(*column, day, known);
      if (!newest) continue;
      if (is_in_situ(*origin_of(*column, newest->dataset))) return newest;
      const auto leading =
          leading_product(column->current, UtcTime(day) - remembered, UtcTime(day) + days(1),
                          knowledge_of(day, known), data.site.current_product);
      if (!leading || *leading == newest->dataset) return newest;
      newest->stands_in_for = *leading;
    }
    if (newest->day - day > patience) return newest;
    if (auto held = held_by(newest->stands_in_for, *column, day, known)) return held;
  }
  return newest;
}

}  // namespace slackwater::calibration
