#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "api/ask/rehearse/rehearsal.h"
#include "twin/run/set_up.h"
#include "twin/scenario/scenario.h"

namespace slackwater::bench {

inline constexpr double hour_s = 3600;
inline constexpr std::size_t all_starts = 24, all_members = 50;

[[nodiscard]] UtcTime first_start();

/// An hour and more of a tethered ROV up and down a monopile in 35 m, as cp_anode has it, in limits
/// that are looked at and that the current of some starts exceeds.
/// @param more  YAML of the mission; empty: as every mission is
[[nodiscard]] twin::Scenario pile_mission(const std::string& more = {});

/// A sheared tide of 0.55 m/s at most: a current of its own for each start. The members of a start
/// differ in their seas.
[[nodiscard]] twin::Surround tidal_water(const twin::Scenario& mission);

[[nodiscard]] double cpu_seconds();

/// What came of a rehearsal of its only vehicle, start by start and member by member.
struct Flown {
  std::size_t flights = 0;
  double flown_s = 0;  ///< of all of them together
  double cpu_s = 0;
  double wall_s = 0;
  double first_answer_s = 0;
  bool none_broke = true;  ///< they went on, or stopped for what stops a mission
  std::vector<double> energy_j;
  std::vector<double> covered;  ///< share; empty: it inspects nothing
  std::uint64_t rays = 0;
};
[[nodiscard]] Flown flown(const twin::Scenario& mission, std::size_t starts, std::size_t members,
                          int threads);

}  // namespace slackwater::bench
