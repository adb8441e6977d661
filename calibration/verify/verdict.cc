#include "calibration/verify/verdict.h"

#include <algorithm>
#include <map>
#include <tuple>

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

/// A baseline beside the forecast; nothing where they share too few pairs.
std::optional<BestBaseline> beside(Method method, const ErrorsByPair& theirs,
                                   const ErrorsByPair& ours) {
  std::vector<double> baseline;
  std::vector<double> forecast;
  for (const auto& [pair, rmse_m_s] : ours) {
    const auto found = theirs.find(pair);
    if (found == theirs.end()) continue;
    baseline.push_back(found->second);
    forecast.push_back(rmse_m_s);
  }
  if (baseline.empty() || 2 * baseline.size() < ours.size()) return std::nullopt;
  return BestBaseline{method, baseline.size(), rmse_of_pairs(baseline), rmse_of_pairs(forecast)};
}

/// Whether a's error is a smaller share of ours than b's.
bool is_better(const BestBaseline& a, const BestBaseline& b) {
  return a.rmse_m_s * b.forecast_rmse_m_s < b.rmse_m_s * a.forecast_rmse_m_s;
}

}  // namespace

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
    const auto baseline = beside(method, theirs, errors[Method::forecast]);
    if (baseline && (!verdict.best || is_better(*baseline, *verdict.best))) verdict.best = baseline;
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

}  // namespace slackwater::calibration
