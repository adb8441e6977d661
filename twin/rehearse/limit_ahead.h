#pragma once
#include <span>
#include <vector>

#include "fields/base/step_clock.h"
#include "twin/rehearse/planned_work.h"
#include "twin/risk/wave_futures.h"
#include "twin/run/set_up.h"

namespace slackwater::twin {

/// What nothing but a run can show: the motion of a deck, the force on a fender.
[[nodiscard]] bool only_a_run_shows(LimitVariable variable) noexcept;

/// What the variable of a limit is for a vehicle at a place: what a run that has it there looks at.
/// @param there  scratch: a state of the agent; its position is set
[[nodiscard]] double value_at(const Limit& limit, const Agent& agent, const Triple<double>& place_m,
                              double t_s, AgentState& there);
/// Where a limit is looked at in a phase: in the middle, if its value does not change with height
/// or the limit names one; of the wind at the vehicle as high as it comes and as low; of the
/// current also at the forecast's own levels in between, on the straight way from one to the other.
/// Between its levels a forecast is linear, so that a speed is nowhere greater there.
/// @param depth_m  the forecast's levels, ascending
[[nodiscard]] std::vector<Triple<double>> places_of(const Limit& limit, const PhaseReach& reach,
                                                    std::span<const double> depth_m);

/// The bows with which it is looked at there: those of the phase, where the limit goes by them and
/// has no heading of its own.
[[nodiscard]] std::vector<Course> bows_of(const Limit& limit, const PhaseReach& reach);

struct WorstValue {
  double value = 0;  ///< NaN: nobody knows, where it comes to
  Triple<double> place_m;
};
/// The worst of it at some places, with any of some bows; with none, whatever the bow: then waves
/// come from wherever they are worst. What is known to break the limit breaks it whatever is
/// unknown elsewhere; else what is unknown anywhere is.
[[nodiscard]] WorstValue worst_at(const Limit& limit, const Agent& agent,
                                  const std::vector<Triple<double>>& places_m,
                                  const std::vector<Course>& bows, double t_s, AgentState& there);

/// The values of one limit over the steps of a grid, at the places of one phase.
struct LimitAhead {
  std::size_t agent = 0;  ///< of the run
  std::size_t limit = 0;  ///< of its conduct
  Phase phase = Phase::work;
  std::vector<Triple<double>> places_m;
  std::vector<Course> bows;
  /// By member; one where all members have the same.
  std::vector<std::vector<double>> members;
};

/// Reads the limits of a vehicle, each at the places of each of its phases (`places_of`), in every
/// member. The value of a step is the worst of those at its two ends and at all of the places:
/// between its stamps a forecast is linear, so that speeds and heights are nowhere worse in
/// between. Limits that only a run can show are left out.
/// @param ready    set up at the first time of the clock, in any member
/// @param waves    futures of the waves; null: all members have those of the forecast
[[nodiscard]] std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                                   const StepClock& clock, std::size_t members,
                                                   const WaveFutures* waves);

}  // namespace slackwater::twin
