#include "calibration/verify/score_forecast.h"

#include "calibration/verify/surface_skill.h"
#include "fields/base/check.h"

namespace slackwater::calibration {

ForecastSkill score_forecast(const SiteData& data, const Snapshot& snapshot,
                             const CurrentSource& currents, const VerifyOptions& options) {
  expects(snapshot.wind_policy.has_value(), "a forecast to score has a wind policy");
  SkillEntry blank;
  blank.variable = current_variable;
  blank.site = snapshot.site_id;
  blank.day = snapshot.day;
  blank.issued = snapshot.issued;
  blank.origin = options.origin;
  blank.wind = *snapshot.wind_policy;
  blank.hindsight = snapshot.hindsight;
  blank.simulated_wind = snapshot.simulated_wind;
  ForecastSkill skill = score_currents(data, snapshot, currents, options, blank);
  if (data.columns.empty() || snapshot.columns.empty()) return skill;
  const UtcTime end = UtcTime(snapshot.day) + std::chrono::days(1);
  auto surface = score_surface(data.columns.front(), snapshot, end, options, blank);
  std::move(surface.begin(), surface.end(), std::back_inserter(skill.entries));
  return skill;
}

}  // namespace slackwater::calibration
