#pragma once
#include "twin/mission/read_behaviour_tree.h"

namespace slackwater::twin {

/// What the leaves of a vehicle's tree may ask for (`twin/agent/conduct.h` answers them), in
/// this order.
enum class ConductAction {
  carry_on,   ///< its tasks, from where it left them
  hold,       ///< where it is, until somebody else is asked
  come_home,  ///< by a way that it can go
};
enum class ConductCondition {
  within_limits,  ///< all limits of its phase, for as long as it is to wait before it goes on
  reserve_holds,  ///< the energy for the way home, its margin and the reserve
  carrier_stays,  ///< or its line hangs from none: it goes on, and not home
  link_up,        ///< or none is needed: it goes by itself
  gnss_up,        ///< or it has no receiver
  thrusters_up,
  tether_free,
};
[[nodiscard]] const LeafNames& conduct_leaves();

/// What a vehicle does where its mission says nothing else:
///
/// It carries on with its tasks while all its limits hold, its link and its receiver are there and
/// its tether is free, else it holds; after half an hour of that, and as soon as the energy for the
/// way home runs short, a thruster is lost or the carrier that its line hangs from turns for home,
/// it comes home, and whoever has turned for home does not turn back.
[[nodiscard]] const BehaviourTree& standard_behaviour();

}  // namespace slackwater::twin
