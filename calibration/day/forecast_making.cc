#include "calibration/day/forecast_making.h"

#include "calibration/day/daily_forecast.h"
#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

ForecastMaking::Fit fit_of(const Calibration& calibration) {
  ForecastMaking::Fit fit{
      {}, calibration.rms_m_s, calibration.observations, calibration.termination};
  for (const Parameter& p : calibration.parameters)
    fit.parameters.push_back({p.name, p.unit, p.value, p.prior, p.at_bound, p.weakly_determined});
  return fit;
}

std::vector<ForecastMaking::Share> shares_of(const Blend& blend) {
  std::vector<ForecastMaking::Share> shares;
  for (const CandidateShare& share : blend.share)
    shares.push_back({std::string(name_of(share.method)), share.weight});
  return shares;
}

ForecastMaking::Mixture mixture_of(const Earned& earned) {
  ForecastMaking::Mixture mixture{{shares_of(earned.blend)},
                                  earned.blend.provenance,
                                  earned.spread.scale,
                                  earned.spread.provenance,
                                  earned.simulated_days};
  for (const Blend& later : earned.later) mixture.by_day.push_back(shares_of(later));
  return mixture;
}

}  // namespace

ForecastMaking making_of(const DailyForecast& forecast) {
  expects(!forecast.columns.empty(), "a forecast has a column");
  ForecastMaking making;
  const ColumnForecast& column = forecast.columns.front();
  if (const Calibration* calibration = column.calibration())
    making.fit = fit_of(*calibration);
  else
    making.no_fit = column.calibration_problem;
  if (forecast.earned) making.mixture = mixture_of(*forecast.earned);
  for (const SourceUse& use : column.sources) making.sources.push_back(text_of(use));
  making.notes = column.notes;
  return making;
}

}  // namespace slackwater::calibration
