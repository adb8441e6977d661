#pragma once
#include <optional>
#include <span>
#include <vector>

#include "twin/inspection/instrument/pose.h"
#include "twin/render/scene/scene_of_run.h"
#include "twin/run/set_up.h"
#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// The lines of a run's vehicles at a moment, each as it comes to rest in the current of then
/// between its ends: what it does beyond that, as the vehicle pulls and the sea works at it, a log
/// does not tell. Left out is the line of a vehicle that is not there, or so near its place beside
/// the deck that it could be aboard (`twin::boarding_reach_m`), where it is wound up; and one whose
/// ends are farther apart than it is long: it has parted.
/// @param vehicles  where each of the run's vehicles is, in its order
[[nodiscard]] std::vector<twin::SeenTether> seen_tethers(
    const twin::ReadyRun& run, const twin::Scenario& scenario,
    std::span<const std::optional<twin::Carriage>> vehicles, double t_s);

}  // namespace slackwater::api
