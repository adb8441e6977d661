#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "fields/wind/dryden_gust.h"
#include "twin/agent/coarse.h"
#include "twin/agent/common_picture.h"
#include "twin/agent/sense.h"
#include "twin/clearance/nearest_pass.h"
#include "twin/control/autopilot.h"
#include "twin/environment/environment.h"
#include "twin/inspection/inspection_state.h"
#include "twin/search/noisy_work.h"
#include "twin/state/conduct_state.h"
#include "twin/state/headway.h"
#include "twin/state/helm_state.h"
#include "twin/state/line_top.h"
#include "twin/state/milestones.h"
#include "twin/state/mission.h"
#include "twin/state/thrust_use.h"
#include "twin/step/vehicle_state.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// Why a vehicle is stepped no further. The others go on.
enum class Halt {
  none,
  diverged,      ///< its state is no number, or one that no vehicle has
  outside_area,  ///< of the forecast
  outside_time,
  aground,     ///< the bed, or land
  no_data,     ///< the forecast has no value there
  struck,      ///< a structure; the sea, by one that flies
  capsized,    ///< rolled or pitched beyond a right angle, afloat
  no_headway,  ///< the water, or the wind, is faster than it
};
[[nodiscard]] std::string_view name_of(Halt halt) noexcept;

struct ReadyConduct;
struct Inspection;

/// Of a vehicle whose work is noisy: whose word it waits for.
struct NoiseZone {
  std::vector<std::size_t> watchers;  ///< by their places in the run
  ZoneRule rule;
};

/// A vehicle of a run: what does not change while it runs. Shared by any threads.
struct Agent {
  std::string name;
  std::shared_ptr<const Vehicle> vehicle;
  std::shared_ptr<const EnvironmentSampler> water;  ///< what it lives in
  std::shared_ptr<const Autopilot> autopilot;  ///< one for all of a kind: it stays in the cache
  Mission mission;
  StepPlan plan;
  std::size_t steps_per_barrier = 1;
  std::optional<DrydenFilter> gusts;
  std::optional<Tether> tether;
  Triple<double> tether_top_m;  ///< where it is fixed; of a carrier's deck `AgentState::top`
  std::optional<Navigation>
      navigation;  ///< nothing: it knows the truth, and no instrument is looked at
  std::optional<HeadwayWatch> headway;           ///< nothing: it is not watched
  std::optional<std::size_t> carrier;            ///< by its place in the run
  Triple<double> deck_m;                         ///< where on it, the carrier's body axes
  std::shared_ptr<const ReadyConduct> conduct;   ///< null: it does its tasks, come what may
  std::shared_ptr<const Inspection> inspection;  ///< null: it looks at nothing
  std::optional<NoiseZone> zone;                 ///< nothing: it may be as noisy as it likes
  std::optional<Clearance> clearance;            ///< nothing: it goes as if it were alone
  /// That pass by and keep their courses; shared by all vehicles of the run, null: none.
  std::shared_ptr<const std::vector<TrafficVessel>> vessels;
  double depth_bound_m = 0;          ///< of leaving its depth (`note_depth`); 0: nobody asks
  std::optional<CoarsePlan> coarse;  ///< nothing: water and tether are met in full at each step
  HelmRule helm;                     ///< how long it goes on without a word from outside
};

/// All that changes of it: a value, copied for a checkpoint.
struct AgentState {
  VehicleState<double> vehicle;
  ControlState control;
  MissionState mission;
  DrydenFilter::State gust;
  Rng gust_rng{0, ""};
  TetherState<double> tether;
  LineTop top;       ///< of its tether
  LinesBorne borne;  ///< by it, as a carrier
  NavigationState navigation;
  HeadwayState headway;
  ConductState conduct;
  HelmState helm;
  ClearanceState clearance;
  NearestPasses nearest;
  CoarseState coarse;
  Milestones milestones;
  ThrustUse thrust;
  InspectionState inspection;
  Halt halt = Halt::none;
  double halted_at_s = 0;
  /// Of the last step, for logs and observers.
  Triple<double> water_m_s;  ///< NED, current and waves
  Triple<double> wind_m_s;   ///< NED, gusts and all
  double elevation_m = 0;
  double tether_n = 0;
  bool is_retired = false;  ///< from a run that goes on without it
  bool is_hosted = false;   ///< its physics are made elsewhere; see `HostPhysics`
};

/// Whether it goes: it has not halted, is not retired and stands on nobody's deck.
[[nodiscard]] inline bool moves(const AgentState& state) noexcept {
  return state.halt == Halt::none && !state.conduct.is_aboard && !state.is_retired;
}

/// Whether the physics of its steps are ours.
[[nodiscard]] inline bool is_stepped(const AgentState& state) noexcept {
  return moves(state) && !state.is_hosted;
}

/// A node of the tether that is caught stays where it is.
inline void hold_snag(AgentState& state) noexcept {
  if (!state.conduct.is_snagged) return;
  state.tether.node_m[state.conduct.snag_node] = state.conduct.snag_m;
  state.tether.velocity_m_s[state.conduct.snag_node] = {};
}

/// Where a vehicle meets the wind: one that flies where it is, a craft that floats at the height
/// that its coefficients are for. @param at_m  NED
[[nodiscard]] Triple<double> wind_place_m(const Vehicle& vehicle,
                                          const Triple<double>& at_m) noexcept;

/// What the vehicle goes by: the truth, or what it makes of its instruments.
[[nodiscard]] Measured known_of(const Agent& agent, const AgentState& state);

/// What a step of a vehicle is made with.
struct StepInput {
  VehicleCommand<double> command;
  Surroundings<double> around;
};

/// Looks at the surroundings, asks the mission and the autopilot what to do, and lets the tether
/// pull: all of a step but the motion itself, which follows with `step` or, eight at a time,
/// `step_block`.
/// @param seen  of a vehicle that keeps clear: what it looks at
/// @return false where the agent halts
[[nodiscard]] bool prepare(const Agent& agent, double t_s, const Lookout& seen, AgentState& state,
                           StepInput& input);

/// Along each axis, of a vehicle and of any place that it is sent to: far beyond every forecast.
inline constexpr double farthest_from_origin_m = 1e6;

/// Whether a step left numbers that a vehicle can have.
[[nodiscard]] inline bool is_sound(const BodyState<double>& body, double state_of_charge) noexcept {
  constexpr double fastest_m_s = 200, fastest_rad_s = 200, longest = 1.001;
  // False for what is no number; all are asked, without a branch.
  const auto is_within = [](const Triple<double>& v, double most) -> bool {
    return (std::abs(v.x) <= most) & (std::abs(v.y) <= most) & (std::abs(v.z) <= most);
  };
  const Attitude<double>& q = body.attitude;
  return is_within(body.position_m, farthest_from_origin_m) &
         is_within(body.nu.linear, fastest_m_s) & is_within(body.nu.angular, fastest_rad_s) &
         is_within({q.x, q.y, q.z}, longest) & (std::abs(q.w) <= longest) & (state_of_charge >= 0);
}
void halt(AgentState& state, Halt why, double t_s) noexcept;

}  // namespace slackwater::twin
