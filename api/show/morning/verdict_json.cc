#include "api/show/morning/verdict_json.h"

#include <nlohmann/json.hpp>

namespace slackwater::api {

using nlohmann::json;

json verdict_json(const std::optional<calibration::Verdict>& verdict) {
  if (!verdict) return nullptr;
  const calibration::SkillSet& ours = verdict->forecast;
  json document = {{"wind", name_of(verdict->wind)},
                   {"origin", name_of(verdict->origin)},
                   {"lead_h", {ours.of.lead.from_h, ours.of.lead.to_h}},
                   {"days", {format_day(ours.first_day), format_day(ours.last_day)}},
                   {"pairs", ours.score.pairs},
                   {"few", ours.score.is_of_few()},
                   {"rmse_m_s", ours.score.rmse},
                   {"interval_95", nullptr},
                   {"truth_mean_h", hours_of(ours.of.truth_averaging)},
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
