#include "api/show/report/verdict_text.h"

#include <cmath>

#include "fields/base/numbers/averaging.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Errors that differ by less are one number at three digits.
constexpr double not_shown = 0.0005;

/// As people write it.
const char* unit_of(const calibration::Verdict& verdict) {
  return verdict.forecast.of.variable == calibration::wave_variable ? "m" : "m/s";
}

}  // namespace

std::string truth_text(const calibration::SkillEntry& entry) {
  if (!hides_the_tide(entry.truth_averaging)) return entry.truth;
  return entry.truth + " (" + averaging_text(entry.truth_averaging) + ", not instants)";
}

std::string wind_text(const calibration::SkillEntry& entry) {
  return std::string(name_of(entry.wind)) + (entry.simulated_wind ? " (simulated)"
                                             : entry.hindsight    ? " (in hindsight)"
                                                                  : "");
}

std::string error_text(const calibration::Verdict& verdict) {
  const calibration::SkillEntry& of = verdict.forecast.of;
  std::string text = formatted("{:.3f} {}", verdict.forecast.score.rmse, unit_of(verdict));
  if (hides_the_tide(of.truth_averaging)) {
    text += " against " + averaging_text(of.truth_averaging) +
            ", not instants: changes within a mean are not scored";
  }
  if (of.simulated_wind) {
    text += ", with simulated wind forecasts where no real one is stored";
  } else if (of.hindsight) {
    text += ", made in hindsight: its wind was not known when it was issued";
  }
  return text;
}

std::string pairs_text(const calibration::Verdict& verdict) {
  const calibration::SetScore& s = verdict.forecast.score;
  return formatted("{} {}", s.pairs, s.pairs == 1 ? "pair of days" : "pairs of days") +
         (verdict.origin == ForecastOrigin::hindcast ? " of hindcasts" : "") +
         (s.is_of_few() ? " (few: no interval)" : "");
}

std::string baseline_text(const calibration::Verdict& verdict) {
  if (!verdict.best) return {};
  const calibration::BestBaseline& best = *verdict.best;
  std::string text = "best baseline " + std::string(name_of(best.method)) +
                     formatted(" {:.3f} {}", best.rmse, unit_of(verdict));
  if (best.pairs < verdict.forecast.score.pairs) {
    text += formatted(" (over {} of these pairs, where the forecast has {:.3f} {})", best.pairs,
                      best.forecast_rmse, unit_of(verdict));
  } else if (std::abs(best.forecast_rmse - verdict.forecast.score.rmse) > not_shown) {
    text += formatted(" (over the values that both have, where the forecast has {:.3f} {})",
                      best.forecast_rmse, unit_of(verdict));
  }
  return text;
}

std::string verdict_text(const calibration::Verdict& verdict) {
  const calibration::SetScore& s = verdict.forecast.score;
  std::string text = "Wind " + wind_text(verdict.forecast.of) + ", lead " +
                     calibration::lead_text(verdict.forecast.of.lead) + ", " + pairs_text(verdict) +
                     ": forecast " + error_text(verdict);
  if (s.rmse_interval)
    text +=
        formatted(" (95 % interval {:.3f} to {:.3f})", s.rmse_interval->low, s.rmse_interval->high);
  if (verdict.best) text += ", " + baseline_text(verdict);
  if (s.vector && s.vector->coverage_80)
    text += formatted("; {:.0f} % of the truth inside the 80 % band", 100 * *s.vector->coverage_80);
  if (s.vector && s.vector->coverage_interval)
    text += formatted(" (95 % interval {:.0f} to {:.0f} %)", 100 * s.vector->coverage_interval->low,
                      100 * s.vector->coverage_interval->high);
  return text + ".";
}

std::string outcome_text(const calibration::Verdict& verdict) {
  if (verdict.best && verdict.best->pairs < calibration::fewest_for_interval &&
      (verdict.outcome == calibration::Outcome::ahead ||
       verdict.outcome == calibration::Outcome::beaten))
    return std::string(verdict.outcome == calibration::Outcome::ahead ? "The forecast was nearer"
                                                                      : "The baseline was nearer") +
           ", on too few days to say which is better.";
  switch (verdict.outcome) {
    case calibration::Outcome::alone:
      return {};
    case calibration::Outcome::ahead:
      return "The forecast is better.";
    case calibration::Outcome::tie:
      return "A tie: the difference is within noise.";
    case calibration::Outcome::beaten:
      return "THE FORECAST DOES NOT BEAT IT.";
  }
  return {};
}

std::string verdict_lines(const std::vector<calibration::SkillEntry>& entries) {
  std::string lines;
  for (const calibration::Verdict& verdict : calibration::verdicts_of(entries)) {
    lines += verdict_text(verdict);
    if (verdict.best) lines += ' ';
    lines += outcome_text(verdict);
    lines += "\n";
  }
  return lines;
}

}  // namespace slackwater::api
