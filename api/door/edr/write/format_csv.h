#pragma once
#include <string>

#include "api/door/edr/sample/answer.h"

namespace slackwater::api::edr {

/// An answer as CSV (`text/csv`, RFC 4180): a header row, then a row for each point of each domain,
/// in the order t, z, y, x:
///
///   longitude,latitude,depth_m,time,eastward_sea_water_velocity [m/s],...
///
/// The column depth_m (or height_m) and that of the time stand where the answer has such an axis; a
/// missing value is an empty field. There is no line of comments, which readers would take for
/// data: provenance travels in the headers of `provenance_headers` (describe.h). Broken promises of
/// `Answer` are ContractViolations.
[[nodiscard]] std::string csv(const Answer& answer);

}  // namespace slackwater::api::edr
