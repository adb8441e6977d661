#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/site/site.h"
#include "twin/mission/limit.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::api {

/// The vessel that brings a task to its turbine and home again. A start is when the work begins:
/// before it she has gone out and people have gone over, after it they come back and she goes home.
struct VesselAccess {
  std::string name;
  Duration passage{};   ///< from port to the farm, and home again the same
  Duration transfer{};  ///< of people, before the work and after it
  std::vector<twin::Limit> limits;

  /// How long before a start she leaves port, and how long after the work she is back.
  [[nodiscard]] Duration way() const noexcept { return passage + transfer; }
};

/// That of a site's `access`, its sheet looked for in `data/vessels` and then beside `folder`.
/// @throws Error(not_found), Error(invalid_input): also for limits that only a run can show
[[nodiscard]] std::optional<VesselAccess> vessel_access(const Site& site,
                                                        const std::filesystem::path& folder);

/// The steps at which a limit of hers counts, after she has left port; she leaves a whole number of
/// steps before the start, `lead`. The contingency of the work may make her wait for it.
/// @param work_s         planned, from the start to the last of it; @param contingency_s  beyond it
/// @param step           of the grid
[[nodiscard]] twin::StepRanges steps_of_access(const VesselAccess& vessel, twin::PhaseSet phases,
                                               std::size_t lead, double work_s,
                                               double contingency_s, Duration step);

}  // namespace slackwater::api
