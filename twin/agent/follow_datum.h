#pragma once
#include "twin/agent/conduct.h"
#include "twin/control/moving_frame.h"

namespace slackwater::twin {

// How a search that follows the drift is joined to a run: the frame of its tasks, and what stands
// in the way of a pattern that comes along over ground.

/// Of a vehicle that searches in a drifting frame: where its datum begins, and the water and wind
/// that it is thought to drift in, those of the central forecast. Nothing for others.
[[nodiscard]] std::optional<DatumSource> datum_source(const Agent& agent, const Conduct& plan,
                                                      const Triple<double>& start_m);

/// The datum at the start of a run: it has drifted for as long as the person, in the water and wind
/// of then.
[[nodiscard]] DatumState begin_datum(const DatumSource& source, const PersonSearch& search);

/// Once a tick: the datum takes the drift of where it is now, and a waypoint that has come to lie
/// in a structure, or too near to one, is left out by a vehicle that is at it.
void follow_datum(const Agent& agent, double t_s, AgentState& state);

/// The frame of the datum now; the ground for who has none.
[[nodiscard]] MovingFrame datum_frame(const Agent& agent, const AgentState& state,
                                      double t_s) noexcept;
/// Whether the vehicle's task under way is in that frame.
[[nodiscard]] bool goes_with_datum(const Agent& agent, const AgentState& state) noexcept;

/// What an autopilot is to do in a step, and what it is told of itself, in one frame: that of the
/// datum for who searches in it, unless that would lead into something, else the ground.
struct Asked {
  Measured measured;
  Reference reference;
  Triple<double> position_m;  ///< where it truly is, in the frame of its route
};
/// Asks the helm or the mission, and lets the vehicle keep clear.
/// @param stream_m_s  the water, as well as the vehicle knows it, NED
[[nodiscard]] Asked asked_of(const Agent& agent, const Lookout& around, const Measured& measured,
                             const Triple<double>& stream_m_s, double t_s, AgentState& state);

}  // namespace slackwater::twin
