#include "api/report/verdict_text.h"
#include "fields/base/text.h"

namespace slackwater::api {
std::string baseline_text(const calibration::Verdict& verdict) {
  if (!verdict.best) return {};
  const calibration::BestBaseline& best = *verdict.best;
  std::string text = "best baseline " + std::string(name_of(best.method)) +
                     formatted(" {:.3f} m/s", best.rmse_m_s);
  if (best.pairs < verdict.forecast.score.pairs)
    text += formatted(" (over {} of these pairs, there the forecast has {:.3f} m/s)", best.pairs,
                      best.forecast_rmse_m_s);
  return text;
}

std::string verdict_text(const calibration::Verdict& verdict) {
  const calibration::SetScore& s = verdict.forecast.score;
  std::string text = "Wind " + std::string(name_of(verdict.wind)) + ", lead " +
                     calibration::lead_text(verdict.forecast.of.lead) +
                     formatted(", {} {}: forecast {:.3f} m/s", s.pairs,
                               s.pairs == 1 ? "pair of days" : "pairs of days", s.rmse);
  if (s.rmse_interval)
    text += formatted(" [{:.3f}, {:.3f}]", s.rmse_interval->low, s.rmse_interval->high);
  if (verdict.best) text += ", " + baseline_text(verdict);
  if (s.vector->coverage_80)
    text += formatted("; {:.0f} % of the truth inside the 80 % band", 100 * *s.vector->coverage_80);
  if (s.vector->coverage_interval)
    text += formatted(" [{:.0f}, {:.0f}]", 100 * s.vector->coverage_interval->low,
                      100 * s.vector->coverage_interval->high);
  return text + ".";
}

std::string verdict_lines(const std::vector<calibration::SkillEntry>& entries) {
  std::string lines;
  for (const calibration::Verdict& verdict : calibration::verdicts_of(entries)) {
    lines += verdict_text(verdict);
    lines += verdict.is_beaten() ? " THE FORECAST DOES NOT BEAT IT.\n" : "\n";
  }
  return lines;
}

}  // namespace slackwater::api
