#pragma once
#include "api/ask/run/scenario_run.h"
#include "twin/rehearse/resurvey.h"

namespace slackwater::api {

/// What of a run's inspections is to be flown again; empty: nothing.
[[nodiscard]] twin::Resurvey resurvey_of(const twin::Scenario& scenario,
                                         const ScenarioResult& result);

}  // namespace slackwater::api
