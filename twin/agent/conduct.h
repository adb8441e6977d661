#pragma once
#include <array>

#include "twin/agent/agent.h"
#include "twin/agent/company.h"
#include "twin/mission/conduct.h"

namespace slackwater::twin {

// How a vehicle's behaviour tree is joined to its motion: at a barrier the tree is ticked, which
// says what the vehicle does (its tasks, a hold, the way home); in each step `conducted_reference`
// gives the reference for that.

/// Where somebody was last known to be, and what he is thought to drift in.
struct DatumSource {
  Triple<double> last_known_m;
  std::shared_ptr<const EnvironmentSampler> water;  ///< the central forecast's
};

/// A plan for one vehicle with all that is worked out once.
struct ReadyConduct {
  Conduct plan;
  Triple<double> home_m;
  std::uint64_t steps_per_tick = 1;  ///< of the barrier
  /// What it draws at speeds through the water or air that are `speed_step_m_s` apart, from 0.
  std::vector<double> cruise_w;
  double speed_step_m_s = 0;
  double top_speed_m_s = 0;
  double full_j = 0;  ///< of the battery; 0: it has none, or its bus is held
  double bow_mass_kg = 0;
  std::array<double, most_mounts> idle_thruster{};  ///< as they turn when it is launched
  /// The structure that it starts at, by its place in the environment.
  std::optional<std::size_t> worked_at;
  std::optional<Cleaning> cleaning;
  std::optional<DatumSource> datum;  ///< of one whose search follows the drift
  bool minds_reserve = false;        ///< its tree asks `reserve_holds`
};
/// Whether what is left in its battery is enough for its way home, with margin and reserve, as of
/// its last tick. One without a battery has no such worry.
[[nodiscard]] bool reserve_holds(const ReadyConduct& conduct, const ConductState& state) noexcept;
/// What it draws at a speed of 0 or more: linear between those of its table, the last two carried
/// on beyond.
[[nodiscard]] double cruise_w_at(const ReadyConduct& conduct, double speed_m_s) noexcept;

/// @param start_m  where it starts
/// @throws Error(invalid_input) for a limit on what nobody knows there, a thruster that it does not
///         have, a tether fault without a tether
[[nodiscard]] ReadyConduct ready_conduct(const Conduct& plan, const Agent& agent,
                                         const Triple<double>& start_m, double barrier_s,
                                         double voltage_v);
[[nodiscard]] ConductState begun(const ReadyConduct& conduct, const Agent& agent,
                                 const AgentState& state, std::uint64_t seed);

/// The structure that is nearest to a place; nothing where there is none.
[[nodiscard]] std::optional<std::size_t> structure_at(const Agent& agent,
                                                      const Triple<double>& place_m);
/// A line that is laid out there lies about nothing yet.
void begin_winding(const Agent& agent, std::optional<std::size_t> worked_at,
                   const Triple<double>& place_m, ConductState& own);

/// Ticks the tree of a vehicle that has one, between steps, and lets it come aboard or be launched
/// where its tasks say so.
/// @param company  whom it goes with
/// @param changes  scratch, so that a tick allocates nothing
/// @return whether it was moved, or its battery filled, otherwise than by its steps
bool tick_conduct(const Agent& agent, double t_s, AgentState& state, const Company& company,
                  std::vector<StatusChange>& changes);

/// The reference of a step for what it is doing; that of its mission where it has no conduct.
/// @param datum  the frame of what drifts; the reference of such a task is in it
[[nodiscard]] Reference conducted_reference(const Agent& agent, const Measured& measured,
                                            const MovingFrame& datum, double t_s,
                                            AgentState& state);
/// The route and place that it follows in that.
[[nodiscard]] const MissionState& way_of(const AgentState& state) noexcept;

/// What it takes, by reckoning, to get home from where it is: the way round structures at the speed
/// of its guidance in the water or wind of now. Infinite where that is faster than it.
struct WayHome {
  double length_m = 0;
  double time_s = 0;
  double energy_j = 0;
};
[[nodiscard]] WayHome way_home(const Agent& agent, double t_s, const AgentState& state);

/// What the variable of a limit is for a vehicle now, from the forecast that it lives in, the run,
/// or what is assumed; no number where nobody knows it.
[[nodiscard]] double value_of(const Limit& limit, const Agent& agent, double t_s,
                              const AgentState& state);
/// The bound of a limit for it now: of a table that of the sea there, with the bow that it has.
[[nodiscard]] double bound_of(const Limit& limit, const Agent& agent, double t_s,
                              const AgentState& state);
[[nodiscard]] HeightBound height_bound_of(const HeightTable& table, const Agent& agent, double t_s,
                                          const AgentState& state);

}  // namespace slackwater::twin
