#pragma once
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "twin/risk/risk_register.h"

namespace slackwater::api {

/// The register of a start, over all vehicles of each of its flights; empty where nothing was
/// flown.
[[nodiscard]] std::vector<twin::RiskEntry> risks_of(
    const StartOutcome& start, const std::vector<twin::Consequence>& consequences);

}  // namespace slackwater::api
