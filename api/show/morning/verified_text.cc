#include "api/show/morning/verified_text.h"

#include "api/show/report/verdict_text.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

std::string verdict_sentence(const PastSkill& past) {
  const std::optional<calibration::Verdict>& verdict = past.verdict;
  if (!verdict) {
    return "Not verified yet: the truth is not stored yet for any issued forecast of this site "
           "with wind " +
           std::string(name_of(past.wind)) + ".";
  }
  std::string text = "Verified over past days, lead " +
                     calibration::lead_text(verdict->forecast.of.lead) + ", " +
                     pairs_text(*verdict) + ": " + error_text(*verdict);
  if (!verdict->best) return text + ".";
  return text + "; " + baseline_text(*verdict) + ". " + outcome_text(*verdict);
}

}  // namespace

std::string verified_text(const PastSkill& past) {
  const std::string text = past.not_verified.empty() ? verdict_sentence(past) : past.not_verified;
  if (past.unscored.empty()) return text;
  return text + formatted(" {} of the past forecasts could not be scored: ", past.unscored.size()) +
         past.unscored.front();
}

}  // namespace slackwater::api
