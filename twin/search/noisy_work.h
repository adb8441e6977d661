#pragma once
#include <limits>

#include "twin/search/mammal_duty.h"

namespace slackwater::twin {

/// When the noisy work of another vehicle may go on: what the watches of a zone ask for together.
struct ZoneRule {
  double clear_for_s = 0;    ///< that somebody has watched without a sighting before noise begins
  double again_after_s = 0;  ///< the same from the last sighting or gap of the watch on, afterwards
};

/// What the watches tell the vehicle whose work is noisy.
struct ZoneReport {
  bool is_watched = false;                                   ///< by one of them, out there
  double seen_s = -std::numeric_limits<double>::infinity();  ///< the last animal in the zone
};
/// Of a watch as it stands.
/// @param is_there  the vehicle is not lost, and has not ended what it does
void add_to(ZoneReport& report, const MammalDutyState& watch, bool is_there) noexcept;

/// How a vehicle's noisy work stands.
struct NoisyWorkState {
  double clear_since_s = 0;  ///< the last sighting, or the last time that nobody watched
  Stretches noisy_s;         ///< when it made noise
  double stops = 0;          ///< for an animal
  bool is_clear = false;     ///< it may make noise
  bool is_seen = false;      ///< why not: for an animal; else nobody has watched for long enough
};

/// Hears the watches, before the vehicle decides what it does.
/// @param t_s  now; what they tell is of a tick before
void hear(const ZoneRule& rule, const ZoneReport& report, double t_s,
          NoisyWorkState& state) noexcept;
/// After it has decided. @param is_noisy  from now to the next look
void note_noise(bool is_noisy, double t_s, NoisyWorkState& state);

/// The noise that it made until `end_s`; what animals were within the radius of any of the watches
/// meanwhile, to a step of `dt_s`.
[[nodiscard]] NoiseRecord noise_made(const NoisyWorkState& state,
                                     std::span<const MammalDutyState* const> watches, double end_s,
                                     double dt_s);

}  // namespace slackwater::twin
