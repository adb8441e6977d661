#pragma once
#include "twin/agent/conduct.h"

namespace slackwater::twin {

// How a vehicle is under the helm of somebody outside: what is in force is `HelmState`, what puts
// it in force `Command`, what time makes of it `helm_due`.
//
// While it is, its own mission and its behaviour tree stand still; faults, the line, the power and
// the limits are looked at as ever, and it keeps clear as its scenario has it. One whose tree asks
// `reserve_holds` is taken back where its energy is needed for the way home: the tree goes on, and
// finds that out itself. Until that holds again no command leads it elsewhere.

/// Puts a mode in force from this time on. A velocity or thrusters that are in force already are
/// renewed; everything else begins anew where the vehicle takes itself to be.
void take_helm(const HelmDue& due, double t_s, const Agent& agent, AgentState& state);
/// Back to its own mission: a task goes on on its leg; a way home or back is laid anew from here.
void give_back(HelmCause cause, double t_s, const Agent& agent, AgentState& state);

/// Whether its energy is needed for its way home, as of its last tick.
[[nodiscard]] bool must_come_home(const Agent& agent, const AgentState& state) noexcept;

/// At the opening of a step, after its commands: what is over by then.
void mind_helm(const Agent& agent, double t_s, AgentState& state);

/// The reference of a step under the helm; not of thrusters and fins by hand.
/// @param stream_m_s  the water, as well as the vehicle knows it, NED
[[nodiscard]] Reference helm_reference(const Agent& agent, const Measured& measured,
                                       const Triple<double>& stream_m_s, AgentState& state);

}  // namespace slackwater::twin
