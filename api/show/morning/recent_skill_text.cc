#include "api/show/morning/recent_skill_text.h"

#include "fields/base/text.h"

namespace slackwater::api {

std::string text_of(const RecentSkill& trust) {
  const calibration::Verdict& verdict = trust.verdict;
  const std::size_t pairs = verdict.best ? verdict.best->pairs : verdict.forecast.score.pairs;
  // Beside a rival over what both have.
  const double rmse = verdict.best ? verdict.best->forecast_rmse : verdict.forecast.score.rmse;
  const std::string ours = trust.variable + formatted(" {:.2f} {} over {} {}", rmse, trust.unit,
                                                      pairs, pairs == 1 ? "forecast" : "forecasts");
  if (!verdict.best) return ours + " (no simple method to compare with)";
  const calibration::BestBaseline& best = *verdict.best;
  const std::string rival = " the best simple method (" + std::string(name_of(best.method)) +
                            formatted(", {:.2f} ", best.rmse) + trust.unit + ")";
  const bool looks_alike = formatted("{:.2f}", rmse) == formatted("{:.2f}", best.rmse);
  if (looks_alike) return ours + ", within noise of" + rival;
  if (best.pairs < calibration::fewest_for_interval)
    return ours + ", beside" + rival + ": too few to say which is better";
  switch (verdict.outcome) {
    case calibration::Outcome::ahead:
      return ours + formatted(", {:.0f} % less than", 100 * (1 - best.forecast_rmse / best.rmse)) +
             rival;
    case calibration::Outcome::beaten:
      return ours + ", WORSE than" + rival;
    default:
      return ours + ", within noise of" + rival;
  }
}

}  // namespace slackwater::api
