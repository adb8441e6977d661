#pragma once
#include "twin/search/mammal_duty.h"
#include "twin/search/person_search.h"

namespace slackwater::twin {

/// `search` of a vehicle's conduct:
///
///     search: {object: person_upright, lookout: small_boat, radius_m: 30, elapsed: 2min,
///              visibility_m: 10000, last_known: {north_m, east_m}, person: NAME,
///              diffusivity_m2_s: 0.5}
///
/// @throws Error(invalid_input)
[[nodiscard]] PersonSearch read_person_search(const Config& config);

/// `mammals` of a vehicle's conduct:
///
///     mammals: {animal: harbour_porpoise, watch: observer, count: 4, half_side_m: 2000,
///               radius_m: 500, clear_for: 30min, noise_for: 15min, noise: {north_m, east_m},
///               again_after: 20min}
///
/// `noise_for` is how long a schedule of the watch's own lasts; where a vehicle's work is the noise
/// (`noise_by` of the conduct), that is as long as it is, and `again_after` counts.
///
/// @throws Error(invalid_input)
[[nodiscard]] MammalDuty read_mammal_duty(const Config& config);

}  // namespace slackwater::twin
