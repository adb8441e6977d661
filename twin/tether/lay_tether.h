#pragma once
#include <functional>

#include "twin/tether/tether.h"

namespace slackwater::twin {

/// The water at rest in time: velocity at a depth, NED.
using SteadyWater = std::function<Triple<double>(double depth_m)>;

/// A line of `length_m` in an arc between its ends, bowed towards `bow`, at rest.
/// @throws Error(invalid_input) where the ends are farther apart than the line reaches without
///         parting, or more is paid out than the drum holds or less than is resolved
[[nodiscard]] TetherState<double> laid_out(const Tether& tether, const Triple<double>& top_m,
                                           const Triple<double>& vehicle_m, double length_m,
                                           const Triple<double>& bow);

/// The same line where it comes to rest in steady water, both ends held: the quasi-static shape.
/// @throws Error(not_converged) if it does not, which no line of the twin's tests does
[[nodiscard]] TetherState<double> settled(const Tether& tether, TetherState<double> state,
                                          const Triple<double>& top_m,
                                          const Triple<double>& vehicle_m,
                                          const SteadyWater& water);

/// The same as far as it comes in `most_steps` of 0.05 s, at rest: where a run starts. Lines that
/// hang slack in still water swing for hours before they lie as `settled` wants them, and none is
/// refused for that. Slower than 0.1 mm/s counts as rest.
[[nodiscard]] TetherState<double> hung(const Tether& tether, TetherState<double> state,
                                       const Triple<double>& top_m, const Triple<double>& vehicle_m,
                                       const SteadyWater& water, int most_steps = 3000);

/// The same in a sixth of the time, by `most_steps` of 0.2 s (`pull_long`, which holds the line
/// back for them): short lines may not have come to rest, which they do as the run begins.
[[nodiscard]] TetherState<double> hung_roughly(const Tether& tether, TetherState<double> state,
                                               const Triple<double>& top_m,
                                               const Triple<double>& vehicle_m,
                                               const SteadyWater& water, int most_steps = 750);

/// The water at the nodes of a line, for `pull`.
[[nodiscard]] WaterAtNodes<double> water_at_nodes(const TetherState<double>& state,
                                                  const Triple<double>& top_m,
                                                  const Triple<double>& vehicle_m,
                                                  const SteadyWater& water);

}  // namespace slackwater::twin
