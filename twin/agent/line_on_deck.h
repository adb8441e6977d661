#pragma once
#include <span>

#include "twin/agent/agent.h"

namespace slackwater::twin {

// A tether that hangs from a place on another vehicle's deck: `deck_m` of its agent, body axes of
// the carrier. Its top goes with the deck, and pulls at it.

/// The place on a carrier's deck where a vehicle belongs, NED.
[[nodiscard]] Triple<double> deck_place(const Agent& agent, const AgentState& carrier);

/// The top of a vehicle's line on the deck of its carrier. One that is stepped no more stands
/// still.
/// @param t_s  that the carrier's state is of
[[nodiscard]] LineTop top_on_deck(const Agent& agent, const AgentState& carrier, double t_s);

/// At a barrier: the tops of all lines go to where their carriers are, and the carriers get the
/// pull of these lines for the steps until the next one. No allocation.
void move_tops(std::span<const Agent> agents, std::span<AgentState> states, double t_s);

/// A line of a vehicle's tether as it comes to rest in the current of a time, above and below its
/// lower end.
/// @throws Error(invalid_input) where it does not reach
[[nodiscard]] TetherState<double> hung_out(const Agent& agent, const Triple<double>& top_m,
                                           const Triple<double>& end_m, double length_m,
                                           double t_s);

/// Lays the line of a vehicle in the water anew: all of it, from its top to where the vehicle is,
/// as it has come to rest in the current of then. As long as it was, and parted where it had.
/// @throws Error(invalid_input) where it does not reach
void hang_line(const Agent& agent, double t_s, AgentState& state);

/// Takes the line aboard with the vehicle: nothing of it is in the water.
void stow_line(const Triple<double>& deck_m, AgentState& state);

}  // namespace slackwater::twin
