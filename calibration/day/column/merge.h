#pragma once
#include "calibration/day/column/methods.h"
#include "calibration/provider/provider_forecast.h"

namespace slackwater::calibration {

/// Our own forecast and the provider's corrected one, at every value weighed by their variances:
///
///   x = (x_o / s_o^2 + p x_p / s_p^2) / (1/s_o^2 + p/s_p^2),   s^2 = 1 / (1/s_o^2 + p/s_p^2)
///
/// as if their errors were independent; what is wrong with that the blend's weights and the earned
/// spread see. p is 1, and falls to 0 over the last six hours before a time at which the provider
/// says nothing, so that its coming and going makes no jump. Where it is 0 our own stands.
/// @param own    with its spread
/// @param cells  whose values both are
[[nodiscard]] MethodForecast merged_with(const MethodForecast& own,
                                         const ProviderForecast& provider,
                                         const VectorColumn& cells);

/// p of each value: how far, in six hours, from the nearest time at which the level has no value;
/// at most 1.
[[nodiscard]] std::vector<double> presence_of(const BaselineForecast& made,
                                              const VectorColumn& cells);

}  // namespace slackwater::calibration
