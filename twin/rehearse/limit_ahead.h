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
  std::optional<HeightBound> by_sea{};  ///< of a table: the bound then
  /// The bound of the limit then.
  [[nodiscard]] double bound_of(const Limit& limit) const noexcept {
    return by_sea ? by_sea->at_most_m : limit.bound;
  }
};
/// The worst of it at some places, with any of some bows; with none, whatever the bow: then waves
/// come from wherever they are worst. What is known to break the limit breaks it whatever is
/// unknown elsewhere; else what is unknown anywhere is. Of a table the worst is what takes up most
/// of its bound.
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
  /// By member, of wave heights that have an error by future (`WaveFutures`); one where all have
  /// the same. Of a limit with a table each value is a share of the bound then, 1 at most.
  std::vector<std::vector<double>> members;
  /// Of such a limit, by step: the bound at the end of it that is worse in the central forecast.
  /// Period and direction are the same in all futures: a forecast has one of each.
  std::vector<HeightBound> by_sea;
  /// What the values are held against.
  [[nodiscard]] double bound_of(const Limit& of) const noexcept { return of.table ? 1 : of.bound; }
};

/// Reads the limits of a vehicle, each at the places of each of its phases (`places_of`), in every
/// member. The value of a step is the worst of those at its two ends and at all of the places:
/// between its stamps a forecast is linear, so that speeds and heights are nowhere worse in
/// between. Limits that only a run can show are left out.
/// @param ready    set up at the first time of the clock, in any member
/// @param members  of the forecast, whose waters are looked at
/// @param waves    futures of the waves; null: all members have those of the forecast
[[nodiscard]] std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                                   const StepClock& clock, std::size_t members,
                                                   const WaveFutures* waves);

/// The same of limits that are nobody's of the run (those of the vessel that brings it): at the
/// surface where an agent stands, with no bow that is known, whatever their phases.
/// @param limits  none that only a run can show
[[nodiscard]] std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                                   const std::vector<Limit>& limits,
                                                   const StepClock& clock, std::size_t members,
                                                   const WaveFutures* waves);

}  // namespace slackwater::twin
