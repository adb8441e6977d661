#pragma once
#include <optional>
#include <span>
#include <string>

#include "api/log/helm_turns.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"
#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// How near a vehicle came to its limits in some stretches of its run, by the rows of the log, each
/// of which stands until the next one. What is between two rows is not seen.
struct AtLimits {
  /// From structures: of the vehicle's own envelope, else of the scenario's `clearance`; nothing:
  /// none is set.
  std::optional<double> stand_off_m;
  std::optional<double> nearest_structure_m;  ///< its origin to a face, negative inside
  std::size_t stand_off_breaches = 0;         ///< times that it came nearer than `stand_off_m`
  double inside_stand_off_s = 0;
  double near_stand_off_s = 0;     ///< beyond it, but by no more than a quarter of it
  std::optional<double> fence_m;   ///< of its envelope, about its home
  std::size_t fence_breaches = 0;  ///< times that it went out
  double outside_fence_s = 0;
  double near_fence_s = 0;              ///< inside, in the outer quarter of its radius
  std::optional<double> reserve_share;  ///< of its battery
  double below_reserve_s = 0;
  std::size_t limits_broken = 0;  ///< of its conduct, that called it off its task
  std::string stopped_by;         ///< "struck", "aground", ...; empty: it did not halt then
};

/// @param vehicle  its place in the log
/// @return nothing: the log has no scenario, or that no such vehicle (it joined later)
[[nodiscard]] std::optional<AtLimits> at_limits_in(const ingest::TrajectoryFile& log,
                                                   std::size_t vehicle,
                                                   const twin::VehicleAccount& account,
                                                   const twin::Scenario* scenario,
                                                   std::span<const Stretch> stretches);

}  // namespace slackwater::api
