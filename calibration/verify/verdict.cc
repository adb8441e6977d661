#include "calibration/verify/verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "calibration/skill/bootstrap.h"

namespace slackwater::calibration {
namespace {

/// Errors of a method by pair of days. A pair is known by its site, D and issue time.
using PairKey = std::tuple<std::string, UtcDay, UtcTime>;
using ErrorsByPair = std::map<PairKey, double>;

std::optional<LeadBin> first_lead(const std::vector<SkillEntry>& entries) {
  std::optional<LeadBin> first;
  for (const SkillEntry& e : entries) {
    if (e.method != Method::forecast) continue;
    if (!first || std::tuple(e.lead.from_h, e.lead.to_h) < std::tuple(first->from_h, first->to_h))
      first = e.lead;
  }
  return first;
}

/// Fewer pairs say nothing of noise.
constexpr std::size_t fewest_pairs_for_noise = 5;
/// Errors that differ by less are one number in every table.
constexpr double not_shown_m_s = 0.0005;

/// A baseline with the differences that it is judged by.
struct Rival {
  BestBaseline baseline;
  std::vector<BlockSum> difference;  ///< of squared errors, theirs minus ours, a pair each
};

Outcome outcome_of(const Rival& rival) {
  const double difference_m_s = rival.baseline.rmse_m_s - rival.baseline.forecast_rmse_m_s;
  if (rival.difference.size() >= fewest_pairs_for_noise) {
    Rng random(1, "calibration/verdict");
    const auto interval = bootstrap_mean(rival.difference, random);
    if (interval && interval->low <= 0 && interval->high >= 0) return Outcome::tie;
  } else if (std::abs(difference_m_s) < not_shown_m_s) {
    return Outcome::tie;
  }
  return difference_m_s < 0 ? Outcome::beaten : Outcome::ahead;
}

/// A baseline beside the forecast; nothing where they share too few pairs.
std::optional<Rival> beside(Method method, const ErrorsByPair& theirs, const ErrorsByPair& ours) {
  std::vector<double> baseline;
  std::vector<double> forecast;
  std::vector<BlockSum> difference;
  for (const auto& [pair, rmse_m_s] : ours) {
    const auto found = theirs.find(pair);
    if (found == theirs.end()) continue;
    baseline.push_back(found->second);
    forecast.push_back(rmse_m_s);
    difference.push_back({found->second * found->second - rmse_m_s * rmse_m_s, 1});
  }
  if (baseline.empty() || 2 * baseline.size() < ours.size()) return std::nullopt;
  return Rival{{method, baseline.size(), rmse_of_pairs(baseline), rmse_of_pairs(forecast)},
               std::move(difference)};
}

/// Whether a's error is a smaller share of ours than b's.
bool is_better(const BestBaseline& a, const BestBaseline& b) {
  return a.rmse_m_s * b.forecast_rmse_m_s < b.rmse_m_s * a.forecast_rmse_m_s;
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

std::optional<Verdict> verdict_of(const std::vector<SkillEntry>& entries, WindPolicy wind) {
  std::vector<SkillEntry> judged = whole_current(entries, wind);
  const std::optional<LeadBin> lead = first_lead(judged);
  if (!lead) return std::nullopt;
  std::erase_if(judged, [&](const SkillEntry& e) { return e.lead != *lead; });
  Verdict verdict;
  verdict.wind = wind;
  std::map<Method, ErrorsByPair> errors;
  for (const SkillEntry& e : judged)
    errors[e.method][{e.site, e.day, e.issued}] = e.vector.rmse_m_s;
  std::erase_if(judged, [](const SkillEntry& e) { return e.method != Method::forecast; });
  verdict.forecast = sets_of(judged).sets.front();
  for (const auto& [method, theirs] : errors) {
    if (method == Method::forecast || method == Method::oracle_mean) continue;
    const auto rival = beside(method, theirs, errors[Method::forecast]);
    if (!rival || (verdict.best && !is_better(rival->baseline, *verdict.best))) continue;
    verdict.best = rival->baseline;
    verdict.outcome = outcome_of(*rival);
  }
  return verdict;
}

std::vector<Verdict> verdicts_of(const std::vector<SkillEntry>& entries) {
  std::vector<Verdict> verdicts;
  for (const WindPolicy wind : {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist}) {
    if (auto verdict = verdict_of(entries, wind)) verdicts.push_back(std::move(*verdict));
  }
  return verdicts;
}

std::optional<Verdict> main_verdict(const std::vector<SkillEntry>& entries) {
  std::optional<Verdict> main;
  for (Verdict& verdict : verdicts_of(entries)) {
    if (!main || verdict.forecast.score.pairs > main->forecast.score.pairs)
      main = std::move(verdict);
  }
  return main;
}

}  // namespace slackwater::calibration
