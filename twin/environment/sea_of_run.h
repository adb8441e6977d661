#pragma once
#include <memory>
#include <string>
#include <vector>

#include "twin/environment/environment.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// The nodes at which the height of a run's sea is taken from the forecast are so far apart, from
/// the start on. Stamps of forecasts lie on them for a start at a whole ten minutes.
inline constexpr double sea_course_step_s = 600;

/// The sea that the vehicles of a run are in.
struct RunSea {
  std::shared_ptr<const SeaRealisation> waves;  ///< null: calm
  double peak_period_s = 0;                     ///< that they were made of
};

/// Makes it for a scenario.
///
/// One that the scenario states is the same at all times. That of the forecast is one JONSWAP
/// system of the state at the origin, as `EnvironmentSampler::sea` has it, which is what limits
/// look at: of its largest height during the run, with the period and the direction of the start.
/// Its height then follows that state (height_course.h): in proportion at the nodes, linear in
/// between. Where the start is calm, or its period too short for the largest height
/// (`steepest_height_m`), period and direction are those of the time when it is largest. Where
/// nobody knows the waves at some time they stay as high as before, with a warning; where nobody
/// does at any, the sea is calm, with one.
///
/// @param environment  of the run: field, member, origin, epoch, waves and stated sea
[[nodiscard]] RunSea sea_of_run(const Scenario& scenario, const Environment& environment,
                                std::vector<std::string>& warnings);

}  // namespace slackwater::twin
