#pragma once
#include <string>

#include "api/door/edr/sample/answer.h"

namespace slackwater::api::edr {

/// An answer as CoverageJSON (`application/prs.coverage+json`): a Coverage, or a CoverageCollection
/// where there are several or none, with parameters and reference systems stated once.
///
/// Longitude and latitude are CRS84; the vertical axis is metres below (or above) mean sea level,
/// its direction inline; times are Gregorian, UTC. Values have at most six significant digits,
/// coordinates seven decimals; a missing value is null. Ranges of grids run over those of t, z, y,
/// x that the domain has, of series over t, of profiles over z, of trajectories over `composite`; a
/// point's have no axis. A trajectory that comes back to a place at the same instant says so once
/// (values of an axis are unique). Provenance, attribution and notes stand under
/// `slackwater:provenance`.
///
/// Cost: one allocation that grows; under 40 us for 50 levels of 10 parameters. Broken promises of
/// `Answer` are ContractViolations.
[[nodiscard]] std::string coverage_json(const Answer& answer);

}  // namespace slackwater::api::edr
