#include "calibration/verify/verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "calibration/skill/bootstrap.h"

namespace slackwater::calibration {
namespace {

/// A pair is known by its site and D.
using PairKey = std::tuple<std::string, UtcDay>;

/// A baseline's error in a pair of days, and ours over the same values.
struct PairErrors {
  double theirs = 0;
  double ours = 0;
};
using ErrorsByPair = std::map<PairKey, PairErrors>;

std::optional<LeadBin> first_lead(const std::vector<SkillEntry>& entries) {
  std::optional<LeadBin> first;
  for (const SkillEntry& e : entries) {
    if (e.method != Method::forecast) continue;
    if (!first || std::tuple(e.lead.from_h, e.lead.to_h) < std::tuple(first->from_h, first->to_h))
      first = e.lead;
  }
  return first;
}

/// Errors that differ by less are one number in every table.
constexpr double not_shown = 0.0005;

/// A baseline with the differences that it is judged by.
struct Rival {
  BestBaseline baseline;
  std::vector<BlockSum> difference;  ///< of squared errors, theirs minus ours, a pair each
};

Outcome outcome_of(const Rival& rival) {
  const double difference = rival.baseline.rmse - rival.baseline.forecast_rmse;
  if (rival.difference.size() >= fewest_for_interval) {
    Rng random(1, "calibration/verdict");
    const auto interval = bootstrap_mean(rival.difference, random);
    if (interval && interval->low <= 0 && interval->high >= 0) return Outcome::tie;
  } else if (std::abs(difference) < not_shown) {
    return Outcome::tie;
  }
  return difference < 0 ? Outcome::beaten : Outcome::ahead;
}

/// A baseline beside the forecast; nothing where they share too few of its pairs.
std::optional<Rival> beside(Method method, const ErrorsByPair& errors, std::size_t pairs) {
  std::vector<double> theirs;
  std::vector<double> ours;
  std::vector<BlockSum> difference;
  for (const auto& [pair, e] : errors) {
    theirs.push_back(e.theirs);
    ours.push_back(e.ours);
    difference.push_back({e.theirs * e.theirs - e.ours * e.ours, 1});
  }
  if (theirs.empty() || 2 * theirs.size() < pairs) return std::nullopt;
  return Rival{{method, theirs.size(), rmse_of_pairs(theirs), rmse_of_pairs(ours)},
               std::move(difference)};
}

/// Whether a's error is a smaller share of ours than b's.
bool is_better(const BestBaseline& a, const BestBaseline& b) {
  return a.rmse * b.forecast_rmse < b.rmse * a.forecast_rmse;
}

}  // namespace

std::string_view name_of(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::alone:
      return "alone";
    case Outcome::ahead:
      return "ahead";
    case Outcome::tie:
      return "tie";
    case Outcome::beaten:
      return "beaten";
  }
  return "";
}

std::optional<Verdict> verdict_of(const std::vector<SkillEntry>& entries, WindPolicy wind,
                                  ForecastOrigin origin, std::string_view variable) {
  std::vector<SkillEntry> judged = whole_of(entries, variable, wind, origin);
  const std::optional<LeadBin> lead = first_lead(judged);
  if (!lead) return std::nullopt;
  std::erase_if(judged, [&](const SkillEntry& e) { return e.lead != *lead; });
  // Of several forecasts of one day the one issued first counts, as in the sets.
  std::stable_sort(judged.begin(), judged.end(),
                   [](const SkillEntry& a, const SkillEntry& b) { return a.issued < b.issued; });
  std::map<Method, ErrorsByPair> errors;
  for (const SkillEntry& e : judged) {
    if (e.forecast_rmse && e.method != Method::forecast)
      errors[e.method].try_emplace({e.site, e.day}, PairErrors{rmse_of(e), *e.forecast_rmse});
  }
  std::erase_if(judged, [](const SkillEntry& e) { return e.method != Method::forecast; });
  Verdict verdict;
  verdict.wind = wind;
  verdict.origin = origin;
  verdict.forecast = sets_of(judged).sets.front();
  for (const auto& [method, of_method] : errors) {
    if (method == Method::oracle_mean) continue;
    const auto rival = beside(method, of_method, verdict.forecast.score.pairs);
    if (!rival || (verdict.best && !is_better(rival->baseline, *verdict.best))) continue;
    verdict.best = rival->baseline;
    verdict.outcome = outcome_of(*rival);
  }
  return verdict;
}

std::vector<Verdict> verdicts_of(const std::vector<SkillEntry>& entries) {
  std::vector<Verdict> verdicts;
  for (const ForecastOrigin origin : {ForecastOrigin::forecast, ForecastOrigin::hindcast}) {
    for (const WindPolicy wind : {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist}) {
      if (auto verdict = verdict_of(entries, wind, origin)) verdicts.push_back(std::move(*verdict));
    }
  }
  return verdicts;
}

std::optional<Verdict> main_verdict(const std::vector<SkillEntry>& entries) {
  std::optional<Verdict> main;
  for (Verdict& verdict : verdicts_of(entries)) {
    if (!main || (verdict.origin == main->origin &&
                  verdict.forecast.score.pairs > main->forecast.score.pairs))
      main = std::move(verdict);
  }
  return main;
}

}  // namespace slackwater::calibration
