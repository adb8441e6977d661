#pragma once
#include "fields/base/config.h"
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// Beam attenuation c of water in which a black disc is lost from sight at a distance, level, by
/// day: c = 4.8 / y. Davies-Colley (1988), Limnol. Oceanogr. 33(4), 616-623; Zaneveld and Pegau
/// (2003), Optics Express 11(23), 2997-3009.
[[nodiscard]] double beam_attenuation_of_water(double black_disc_visibility_m) noexcept;
/// The same of air from the meteorological optical range V, at which 5 % of a beam is left:
/// c = -ln 0.05 / V. WMO-No. 8, part I, chapter 9.
[[nodiscard]] double beam_attenuation_of_air(double optical_range_m) noexcept;

/// What is left of a beam after a way: exp(-c r), Beer and Lambert.
[[nodiscard]] double transmission(double beam_attenuation_per_m, double range_m) noexcept;

/// How clear the water is:
///
///     clarity: {beam_attenuation_per_m: 0.6, daylight: 1, diffuse_attenuation_per_m: 0.15}
///
/// or `visibility_m`, that of a black disc, in the place of the beam attenuation. Daylight is 1
/// where nothing is said; of it fades K = c/4 with each metre of depth: with a Secchi depth Z,
/// K = 1.7/Z (Poole and Atkins 1929) and c + K = 8.7/Z (Preisendorfer 1986).
///
/// @throws Error(invalid_input) for none or both of the two; for a turbidity, which is scattered
///         light in NTU or FNU and says how far one sees only for the particles of one place
[[nodiscard]] Clarity read_clarity(const Config& config);

}  // namespace slackwater::twin
