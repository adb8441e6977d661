#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/spread.h"
#include "fields/base/frame.h"
#include "fields/base/random.h"
#include "fields/base/time.h"

namespace slackwater::calibration {

[[nodiscard]] std::vector<Horizontal> draw_wind_error(std::span<const UtcTime> times,
                                                      UtcTime end_of_day, const WindError& error,
                                                      Rng& random);
[[nodiscard]] std::vector<Horizontal> at_stamps(std::span<const UtcTime> samples,
                                                std::span<const Horizontal> departure,
                                                std::span<const UtcTime> stamps,
                                                UtcTime end_of_day);

}  // namespace slackwater::calibration
