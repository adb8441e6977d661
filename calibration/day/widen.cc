#include "calibration/day/widen.h"

#include <vector>

#include "fields/base/numbers/averaging.h"
#include "fields/base/parallel.h"

namespace slackwater::calibration {

std::optional<AveragedCurrents> widen_means(const SiteData& data, const ForecastOptions& options,
                                            const DayChoice& choice, DailyForecast& result) {
  if (!hides_the_tide(choice.averaging)) return std::nullopt;
  std::vector<std::optional<AveragedCurrents>> found(result.columns.size());
  for_all(result.columns.size(), options.threads, [&](std::size_t i) {
    if (result.columns[i].forms.empty()) return;
    ColumnForecast& column = result.columns[i];
    found[i].emplace().averaging = choice.averaging;
    attempt_part(Part::unresolved_tide, column.failures, [&] {
      ForecastColumn widened = column.column;
      const auto tide = options.parts.unresolved_tide(widened, data.columns[i],
                                                      column.known.currents, result.plan);
      found[i] = tide ? std::optional(tide->averaged) : std::nullopt;
      if (!tide) return;
      column.column = std::move(widened);
      column.origins.insert(column.origins.end(), tide->origins.begin(), tide->origins.end());
    });
  });
  std::optional<AveragedCurrents> widest;
  for (const std::optional<AveragedCurrents>& column : found) {
    if (!column) continue;
    const bool is_unknown = !column->unresolved_tide_m_s;
    const bool is_wider =
        widest && widest->unresolved_tide_m_s &&
        (is_unknown || *column->unresolved_tide_m_s > *widest->unresolved_tide_m_s);
    if (!widest || is_wider) widest = column;
  }
  return widest;
}

void widen_stand_in(const SiteData& data, const ForecastOptions& options, const DayChoice& choice,
                    DailyForecast& result) {
  if (result.plan.stands_in_for.empty()) return;
  for (std::size_t i = 0; i < result.columns.size(); ++i) {
    ColumnForecast& column = result.columns[i];
    if (column.forms.empty()) continue;
    attempt_part(Part::stand_in, column.failures, [&] {
      ForecastColumn widened = column.column;
      auto found = options.parts.stand_in(widened, data.columns[i], result.plan);
      if (!hides_the_tide(choice.averaging)) column.column = std::move(widened);
      if (!result.stand_in) result.stand_in = std::move(found);
    });
  }
}

}  // namespace slackwater::calibration
