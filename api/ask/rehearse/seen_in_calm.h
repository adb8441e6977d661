#pragma once
#include <optional>
#include <string>

#include "api/ask/rehearse/mission_file.h"
#include "twin/rehearse/calm_flight.h"

namespace slackwater::api {

/// A mission flown in dead calm (`twin::in_dead_calm`) until all is seen that is asked; nothing
/// where nothing is. The same mission is flown once in a process, whoever asks. Thread-safe.
[[nodiscard]] std::optional<twin::CalmFlight> calm_flight_of(const LoadedMission& mission);

/// A task must be able to succeed: what is asked to be seen has to be in reach where nothing is in
/// the way. A mission that is thinned on purpose, or that cannot be flown to its end for other
/// reasons, is let through: what it sees is told by its flights.
/// @return of the look that lacks most of what it asks for: what was found, what was expected, what
///         to do; empty: all is seen, or nothing is shown
[[nodiscard]] std::string unseen_in_calm(const LoadedMission& mission);
/// @throws Error(invalid_input) with those words
void expect_seen_in_calm(const LoadedMission& mission);

}  // namespace slackwater::api
