#include "calibration/day/past_plan.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/given/simulated_run.h"

namespace slackwater::calibration {

using std::chrono::hours;

ForecastPlan moved_to(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan moved = plan;
  moved.day = day;
  const Duration later = plan.issued - plan.end_of_day();
  moved.issued = moved.end_of_day() + later;
  if (plan.best.issued) moved.best.issued = moved.issued;
  if (plan.best.known_by != UtcTime::max())
    moved.best.known_by = moved.end_of_day() + (plan.best.known_by - plan.end_of_day());
  return moved;
}

int lead_days_of(const ForecastPlan& plan) {
  if (plan.stamps.empty()) return 1;
  const double reach_h = hours_between(plan.end_of_day(), plan.stamps.back());
  return std::clamp(static_cast<int>(std::ceil(reach_h / 24.0 - 1e-9)), 1, most_rehearsed_leads);
}

ForecastPlan past_plan(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan past = moved_to(plan, day);
  past.spread.members = 0;
  past.stamps.clear();
  for (int h = 0; h <= 24 * lead_days_of(plan) + 1; ++h)
    past.stamps.push_back(past.end_of_day() + hours(h));
  return past;
}

ForecastPlan with_past_runs(const ForecastPlan& plan, const SiteData& data,
                            const ColumnParts& parts) {
  ForecastPlan with = plan;
  if (plan.best.hindsight || plan.wind == WindPolicy::persist || data.columns.empty()) return with;
  // Where the wind fails, it does so for the forecast itself, which says so.
  static_cast<void>(attempt([&] {
    const HorizonWind now =
        parts.wind(data.columns.front().wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
    if (!reaches_beyond(now, plan.stamps, plan.end_of_day())) return;
    with.best.simulated_seed = plan.seed;
    with.best.analysed_until = plan.issued;
  }));
  return with;
}

}  // namespace slackwater::calibration
