#pragma once
#include "twin/agent/conduct.h"

namespace slackwater::twin {

// A vehicle on the deck of another, or on something firm at its home: it is not stepped. It goes
// into the water or the air beside where it stands, and comes aboard from near there. A line that
// hangs from the deck is taken aboard with it, and laid anew when it is launched. One whose mission
// is over is recovered: whatever comes then does not befall it.

/// Takes a task `aboard` on: comes alongside and aboard, stands there for its time with what its
/// battery gets, and is launched where its next task is another.
/// @param company  whose carrier is as of the last barrier; without one it is at home
/// @return whether it was moved, or its battery filled
bool come_and_go(const Agent& agent, double t_s, const Company& company, AgentState& state);

/// Whether it has a place on a deck: a carrier, or a time aboard among its tasks.
[[nodiscard]] bool goes_aboard(const Agent& agent) noexcept;
/// As near as a crane's hook or a landing pad takes it: an estimate.
inline constexpr double boarding_reach_m = 3;
/// Where a vehicle of its kind, which conducts itself, meets a deck: in the water beside it, at its
/// own depth of home, or over it.
/// @param deck_m  its place on the deck, NED
[[nodiscard]] Triple<double> boarding_place(const Agent& agent, const Triple<double>& deck_m);

/// Whether it is so near its place there, and so slow beside it, that it can be taken up; on a line
/// that is caught somewhere, or hangs from one that capsized or ran aground, it cannot.
[[nodiscard]] bool is_alongside(const Agent& agent, const AgentState* carrier,
                                const AgentState& state);
void come_aboard(const Agent& agent, double t_s, const AgentState* carrier, AgentState& state);

/// Its mission being over, takes it out of the water or the air: to its place on the deck or its
/// firm home, where it has one and is alongside. Any other is taken up where it lies, if it came
/// home: by its way home, by a recovery as its last task, or where it is, or its last place, is
/// within reach of its home. What ended elsewhere stays out. No events of vessels, which are in
/// port then.
/// @return whether it was moved
bool recover(const Agent& agent, double t_s, const AgentState* carrier, AgentState& state);

/// Whether it is aboard since its mission is over, and on nobody's deck: who takes its helm puts it
/// out again.
[[nodiscard]] bool is_recovered(const Agent& agent, const ConductState& own) noexcept;
/// Where it lies, as one that is launched.
void put_out(const Agent& agent, double t_s, AgentState& state);

/// Where it would come aboard by now.
void keep_boarding_place(const Agent& agent, const AgentState* carrier, AgentState& state);

/// Moves it along with its carrier. @return whether it has one
bool carry(const Agent& agent, const AgentState* carrier, AgentState& state);

}  // namespace slackwater::twin
