#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/current_skill.h"
#include "api/pipeline/site_data.h"
#include "api/pipeline/skill_entry.h"
#include "api/pipeline/skill_set.h"
#include "data/store/store.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// Scores of many forecasts, and what a page draws of them where the options ask for it.
struct Verification {
  std::vector<SkillEntry> entries;
  std::vector<ForecastTrace> traces;  ///< in the order of the forecasts
};

/// Scores one forecast of these data against the truth that the data hold now.
[[nodiscard]] std::vector<SkillEntry> score_forecast(const SiteData& data, const Snapshot& snapshot,
                                                     const std::string& dataset,
                                                     const VerifyOptions& options);

/// Scores every stored forecast of the site in the range whose truth is in: the last issued for
/// each D and wind policy. Forecasts without any truth are left out; none at all is
/// Error(not_found).
[[nodiscard]] Verification verification(store::Store& store, const Site& site,
                                        const VerifyOptions& options);
/// Its entries.
[[nodiscard]] std::vector<SkillEntry> verify(store::Store& store, const Site& site,
                                             const VerifyOptions& options);

/// The same with the site's data read already; empty where nothing is issued yet.
[[nodiscard]] std::vector<SkillEntry> verify_with(store::Store& store, const Site& site,
                                                  const SiteData& data,
                                                  const VerifyOptions& options);

/// The JSON list that `verify` and `hindcast` share (api/docs/json.md).
[[nodiscard]] std::string skill_json(const std::vector<SkillEntry>& entries);

/// A table for people: per variable, band and lead one row a method, pairs of days weighing the
/// same, best first; hours of lead are left to `hourly_table`.
[[nodiscard]] std::string skill_table(const std::vector<SkillEntry>& entries);

/// One row an hour of lead, one column a method: the vector RMSE over the first band.
[[nodiscard]] std::string hourly_table(const std::vector<SkillEntry>& entries);

}  // namespace slackwater::api
