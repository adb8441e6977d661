#pragma once
#include <cstddef>
#include <vector>

#include "twin/control/autopilot.h"
#include "twin/scenario/manoeuvre_task.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// A manoeuvre made ready for one vehicle.
struct ManoeuvrePlan {
  bool is_there = false;
  ManoeuvreKind kind{};
  bool by_rudder = false;    ///< else by a yaw moment of the thrusters
  double most_yaw_n_m = 0;   ///< of these
  bool keeps_depth = false;  ///< what floats has none to keep
  double speed_m_s = 0;      ///< of the approach, or before a step says one
  double approach_s = 0;
  /// What the helm is put to, and for how long at most.
  struct Leg {
    double helm = 0;  ///< rad of the rudder, or share of the yaw moment; positive: bow to starboard
    double lasts_s = 0;
  };
  std::vector<Leg> legs;
  double side = 1;  ///< of the first helm: -1 to port
  double heading_change_rad = 0;
  double lasts_s = 0;  ///< at most, since the first helm; of steps since they began
  std::vector<KeptStep> steps;

  /// Orders that it gives at most, see `TaskOrder`.
  [[nodiscard]] std::size_t most_orders() const noexcept {
    return 5 + legs.size() + 3 * steps.size();
  }
};

/// How far a manoeuvre has come. Numbers only.
struct ManoeuvreState {
  double leg = 0;  ///< 0: the approach; then which helm is in force, from 1. Of steps: how many
  double leg_began_s = 0;  ///< since the task began
  double executed_s = 0;   ///< when the helm was first put over, likewise
  double turned_rad = 0;   ///< to starboard since then
  double heading_rad = 0;  ///< in the last step
  double last_s = 0;       ///< that step, of the run
  double speed_m_s = 0;    ///< that the autopilot keeps
  /// The propulsion of the approach, mean of its last fifth, held from then on.
  double settled_s = 0;
  double push_n = 0;
  double advance_m_s = 0;  ///< ahead through the water
  double voltage_v = 0;    ///< of the bus
};

/// What a manoeuvre orders, when: the times that its figures are counted from.
enum class Ordered {
  begin,    ///< it begins, with its approach; also anew
  heading,  ///< to be kept, rad; speed, m/s; depth, m
  speed,
  depth,
  helm,  ///< as `ManoeuvrePlan::Leg` has it
  over,
};
/// "helm": the word of logs.
[[nodiscard]] const char* name_of(Ordered what) noexcept;

/// Numbers only.
struct TaskOrder {
  double t_s = 0;   ///< of the run
  double task = 0;  ///< of the vehicle, from 0
  double what = 0;  ///< `Ordered`
  double value = 0;

  [[nodiscard]] bool is(Ordered wanted) const noexcept {
    return what == static_cast<double>(wanted);
  }
  bool operator==(const TaskOrder&) const = default;
};

/// @param speed_m_s  of the vehicle, where the task says none
/// @param voltage_v  of its bus
/// @throws Error(invalid_input) with the file and the line of the task: for a vehicle that flies, a
/// helm that it has not or beyond its range, a yaw moment for which its thrusters have no room
/// beside the thrust of the approach, a depth for what floats or beyond the one it is rated for
[[nodiscard]] ManoeuvrePlan plan_manoeuvre(const ManoeuvreTask& task, const Vehicle& vehicle,
                                           const Autopilot& autopilot, double speed_m_s,
                                           double voltage_v);

}  // namespace slackwater::twin
