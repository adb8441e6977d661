#pragma once
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
  WindPolicy wind = WindPolicy::best;
  std::vector<calibration::SkillEntry> entries;
  std::optional<calibration::Verdict> verdict;  ///< absent: no truth is in
  std::vector<std::string> unscored;            ///< forecasts that could not be, and why
  std::string not_verified;                     ///< why nothing was verified; empty: it was
};

/// What can be verified is: earlier forecasts of the last two weeks under the same wind policy, as
/// issued (api/issued/as_issued.h), where their truth had come in when this one is issued. Neither
/// a hindcast nor a later run of a past day is among them. The new forecast is stored by now: what
/// fails here is told, and takes nothing from it.
[[nodiscard]] PastSkill verify_past(store::Store& store, const Site& site, const SiteData& data,
                                    const Snapshot& snapshot, WindPolicy wind);

}  // namespace slackwater::api
