#include "api/morning/past_skill.h"

#include <chrono>

#include "api/pipeline/verify.h"
#include "api/report/verdict_text.h"
#include "fields/base/attempt.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using std::chrono::days;

/// How good it has been: does it beat the plainest alternatives where the truth is in?
std::string verified_text(const std::optional<calibration::Verdict>& verdict, WindPolicy wind) {
  if (!verdict) {
    return "Not verified yet: no truth after an issued forecast of this site with wind " +
           std::string(name_of(wind)) + ".";
  }
  std::string text = "Verified over past days, lead " +
                     calibration::lead_text(verdict->forecast.of.lead) + ", " +
                     pairs_text(*verdict) + ": " + error_text(*verdict);
  if (!verdict->best) return text + ".";
  return text + "; " + baseline_text(*verdict) + ". " + outcome_text(*verdict);
}

}  // namespace

PastSkill verify_past(store::Store& store, const Site& site, const SiteData& data,
                      const Snapshot& snapshot, WindPolicy wind) {
  calibration::VerifyOptions options;
  options.from = snapshot.day - days(14);
  options.issued_before = snapshot.issued;
  options.only = ForecastOrigin::forecast;
  options.truth_until = snapshot.issued;
  options.leads = {{0, 24}};
  options.bands = {{0, calibration::whole_column_m}};
  options.by_hour = false;
  PastSkill past;
  std::vector<std::string> unscored;
  const auto failure = attempt([&] {
    calibration::Verification verification = verify_with(store, site, data, options);
    unscored = std::move(verification.unscored);
    past.entries = std::move(verification.entries);
    past.verdict = calibration::verdict_of(past.entries, wind);
  });
  past.verified = failure ? "Not verified, the verification failed: " + failure->why
                          : verified_text(past.verdict, wind);
  if (!unscored.empty()) {
    past.verified += formatted(" {} of the past forecasts could not be scored: ", unscored.size()) +
                     unscored.front();
  }
  return past;
}

json verdict_json(const std::optional<calibration::Verdict>& verdict) {
  if (!verdict) return nullptr;
  const calibration::SkillSet& ours = verdict->forecast;
  json document = {
      {"wind", name_of(verdict->wind)},
      {"origin", name_of(verdict->origin)},
      {"lead_h", {ours.of.lead.from_h, ours.of.lead.to_h}},
      {"days", {format_day(ours.first_day), format_day(ours.last_day)}},
      {"pairs", ours.score.pairs},
      {"few", ours.score.is_of_few()},
      {"rmse_m_s", ours.score.rmse},
      {"interval_95", nullptr},
      {"truth_mean_h",
       std::chrono::duration<double, std::ratio<3600>>(ours.of.truth_averaging).count()},
      {"hindsight", ours.of.hindsight},
      {"beaten", verdict->is_beaten()},
      {"outcome", name_of(verdict->outcome)},
      {"best_baseline", nullptr}};
  if (const auto& interval = ours.score.rmse_interval)
    document["interval_95"] = {interval->low, interval->high};
  if (verdict->best) {
    document["best_baseline"] = {{"method", name_of(verdict->best->method)},
                                 {"pairs", verdict->best->pairs},
                                 {"rmse_m_s", verdict->best->rmse},
                                 {"forecast_rmse_m_s", verdict->best->forecast_rmse}};
  }
  return document;
}

}  // namespace slackwater::api
