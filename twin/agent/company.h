#pragma once
#include <span>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// Whom a vehicle that conducts itself goes with, and what it waits for from them: as of the last
/// barrier, before anybody decides anything, so that their order in the file says nothing.
///
/// A carrier with a task `stand_by` holds its place while those that it carries are at work. Their
/// tasks `aboard` with `until: stand_by` divide their work by the carrier's places: the first of
/// them ends at its first `stand_by`, and that ends when all have come to their second one, aboard.
struct Company {
  const AgentState* carrier = nullptr;  ///< null: it has none
  bool carrier_stands_by = false;       ///< at the place of the vehicle's next sortie
  bool carrier_is_gone = false;         ///< turned for home, or stepped no more
  bool has_line_out = false;            ///< of those that it carries
  bool are_back = true;                 ///< those that it carries, from their sortie here, or ended
};

/// @param carried  by it, by their places in the run
[[nodiscard]] Company company_of(std::span<const Agent> agents, std::span<const AgentState> states,
                                 std::size_t own, std::span<const std::size_t> carried);

/// How many of a mission's tasks up to that under way begin a sortie from a place of the carrier's.
[[nodiscard]] std::size_t sortie_of(const Mission& mission, const MissionState& state) noexcept;
/// Likewise the places at which a carrier stands by.
[[nodiscard]] std::size_t stand_of(const Mission& mission, const MissionState& state) noexcept;

}  // namespace slackwater::twin
