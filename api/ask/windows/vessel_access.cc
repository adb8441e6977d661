#include "api/ask/windows/vessel_access.h"

#include <algorithm>

#include "api/program/named_sheet.h"
#include "twin/mission/read_seconds.h"
#include "twin/rehearse/limit_ahead.h"
#include "twin/risk/workability/phase_plan.h"

namespace slackwater::api {
namespace {

/// Both in ascending order; what touches is one.
twin::StepRanges joined_ranges(twin::StepRanges ranges, const twin::StepRanges& more) {
  for (const twin::StepRange& next : more) {
    if (!ranges.empty() && next.begin <= ranges.back().end)
      ranges.back().end = std::max(ranges.back().end, next.end);
    else
      ranges.push_back(next);
  }
  return ranges;
}

double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

std::optional<VesselAccess> vessel_access(const Site& site, const std::filesystem::path& folder) {
  if (!site.access) return std::nullopt;
  const Config sheet = load_sheet("vessels", "access: vessel", site.access->vessel, folder);
  VesselAccess vessel;
  (void)sheet.optional_text("id");
  vessel.name = sheet.text("name");
  vessel.passage = site.access->passage;
  vessel.transfer = std::chrono::round<Duration>(
      std::chrono::duration<double>(twin::read_seconds(sheet, "transfer", {0, 7200})));
  vessel.limits = twin::read_limits(sheet);
  for (const twin::Limit& limit : vessel.limits)
    if (twin::only_a_run_shows(limit.variable))
      sheet.refuse("limits", "found \"" + twin::text_of(limit) +
                                 "\", which only a run shows; expected a limit of what is "
                                 "forecast, put this one into the task's sheet");
  sheet.expect_all_read();
  return vessel;
}

twin::StepRanges steps_of_access(const VesselAccess& vessel, twin::PhaseSet phases,
                                 std::size_t lead, double work_s, double contingency_s,
                                 Duration step) {
  using twin::Phase;
  const double passage_s = seconds(vessel.passage), transfer_s = seconds(vessel.transfer);
  // What is left of the last step before she leaves lies before the way, not after it.
  const double spare_s = static_cast<double>(lead) * seconds(step) - passage_s - transfer_s;
  const twin::PhasePlan out{{{Phase::transit, spare_s + passage_s}, {Phase::launch, transfer_s}}};
  const twin::PhasePlan home{
      {{Phase::work, work_s}, {Phase::recovery, transfer_s}, {Phase::return_home, passage_s}}};
  twin::StepRanges after_start = twin::steps_of(home, phases, contingency_s, seconds(step));
  for (twin::StepRange& range : after_start) {
    range.begin += lead;
    range.end += lead;
  }
  return joined_ranges(twin::steps_of(out, phases, 0, seconds(step)), after_start);
}

}  // namespace slackwater::api
