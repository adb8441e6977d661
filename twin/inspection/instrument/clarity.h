#pragma once
#include "fields/base/config.h"
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

enum class Medium { water, air };

/// Contrast at which a black disc is lost from sight by day, exp(-4.8), Davies-Colley (1988).
inline constexpr double black_disc_contrast = 0.00822974704902003;

/// Beam attenuation c of water in which a black disc is lost from sight at a distance, level, by
/// day: c = 4.8 / y. Davies-Colley (1988), Limnol. Oceanogr. 33(4), 616-623; Zaneveld and Pegau
/// (2003), Optics Express 11(23), 2997-3009.
[[nodiscard]] double beam_attenuation_of_water(double black_disc_visibility_m) noexcept;
/// The same of air from the meteorological optical range V, at which 5 % of a beam is left:
/// c = -ln 0.05 / V. WMO-No. 8, part I, chapter 9.
[[nodiscard]] double beam_attenuation_of_air(double optical_range_m) noexcept;

/// The same medium by the same light, but as clear as that one sees so far: what is absorbed and
/// scattered is in proportion, as where nothing else is said (`read_clarity`).
[[nodiscard]] Clarity seen_through(const Clarity& own, double visibility_m, Medium medium) noexcept;

/// What is left of a beam after a way: exp(-c r), Beer and Lambert.
[[nodiscard]] double transmission(double beam_attenuation_per_m, double range_m) noexcept;

/// How clear water or air is:
///
///     clarity: {beam_attenuation_per_m: 0.6, daylight: 1, diffuse_attenuation_per_m: 0.15,
///               backscatter_per_m: 0.009}
///
/// or `visibility_m` in the place of the beam attenuation: in water that of a black disc, in air
/// the meteorological optical range. Daylight is 1 where nothing is said, and may be more: the
/// camera stops down. Of it fades K = c/4 with each metre of depth: with a Secchi depth Z,
/// K = 1.7/Z (Poole and Atkins 1929) and c + K = 8.7/Z (Preisendorfer 1986). Of a lamp's light is
/// scattered back b_b = 0.015 c, an estimate: 0.007 (coast) to 0.017 (harbour) of Petzold's waters,
/// as Mobley (1994), Light and Water, table 3.10 has them.
///
/// @throws Error(invalid_input) for none or both of the two; for a turbidity, which is scattered
///         light in NTU or FNU and says how far one sees only for the particles of one place
[[nodiscard]] Clarity read_clarity(const Config& config, Medium medium = Medium::water);

}  // namespace slackwater::twin
