#include "twin/risk/workability/phase_plan.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// Durations are sums of seconds: what is over a step by less than this is not.
constexpr double hair = 1e-6;

}  // namespace

double PhasePlan::duration_s() const noexcept {
  double sum_s = 0;
  for (const PlannedPhase& phase : phases) sum_s += phase.duration_s;
  return sum_s;
}

PhasePlan stretched(PhasePlan plan, double duration_s) {
  const double more_s = duration_s - plan.duration_s();
  if (!(more_s > 0)) return plan;
  double work_s = 0;
  std::size_t works = 0;
  for (const PlannedPhase& phase : plan.phases) {
    if (phase.phase != Phase::work) continue;
    work_s += phase.duration_s;
    ++works;
  }
  if (works == 0) {
    plan.phases.push_back({Phase::work, more_s});
    return plan;
  }
  for (PlannedPhase& phase : plan.phases) {
    if (phase.phase != Phase::work) continue;
    phase.duration_s +=
        more_s * (work_s > 0 ? phase.duration_s / work_s : 1 / static_cast<double>(works));
  }
  return plan;
}

StepRanges steps_of(const PhasePlan& plan, PhaseSet phases, double contingency_s, double step_s) {
  expects(contingency_s >= 0 && step_s > 0, "a contingency of 0 and more, a step of more than 0");
  StepRanges ranges;
  double from_s = 0;
  for (const PlannedPhase& phase : plan.phases) {
    const double to_s = from_s + phase.duration_s;
    if (phases.has(phase.phase) && phase.duration_s > 0) {
      const auto begin = static_cast<std::size_t>(std::floor(from_s / step_s + hair));
      const auto end = static_cast<std::size_t>(std::ceil((to_s + contingency_s) / step_s - hair));
      if (!ranges.empty() && begin <= ranges.back().end)
        ranges.back().end = std::max(ranges.back().end, end);
      else
        ranges.push_back({begin, std::max(end, begin + 1)});
    }
    from_s = to_s;
  }
  return ranges;
}

}  // namespace slackwater::twin
