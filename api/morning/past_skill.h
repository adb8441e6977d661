#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "calibration/verify/verdict.h"
#include "data/store/store.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// How past forecasts did.
struct PastSkill {
  std::vector<calibration::SkillEntry> entries;
  std::optional<calibration::Verdict> verdict;
  std::string verified;  ///< in words
};

/// What can be verified is: earlier forecasts of the last two weeks under the same wind policy, as
/// issued (api/issued/as_issued.h), where their truth had come in when this one is issued. Neither
/// a hindcast nor a later run of a past day is among them. The new forecast is stored by now: what
/// fails here is told, and takes nothing from it.
[[nodiscard]] PastSkill verify_past(store::Store& store, const Site& site, const SiteData& data,
                                    const Snapshot& snapshot, WindPolicy wind);

/// A verdict as in `forecast --json`; null before any truth is in.
[[nodiscard]] nlohmann::json verdict_json(const std::optional<calibration::Verdict>& verdict);

}  // namespace slackwater::api
