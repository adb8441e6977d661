#pragma once
#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// How water blurs: stated, of one attenuation length, c r = 1.
struct ForwardScatter {
  double per_length = 0;  ///< share of a place's light that is turned aside: 1 - exp(-this c r)
  double spread_rad = 0;  ///< standard deviation by which, as seen from the camera: this (c r)^1/2
};

/// The light of a picture after scattering forwards: of a pixel whose place is at an optical way c
/// r (at most 8), the share 1 - exp(-s c r) is laid about it as a normal distribution with the
/// standard deviation f spread (c r)^(1/2) pixels; what would fall outside of the picture is
/// mirrored at its edge, for as much comes in from there. So no light is won or lost, and an even
/// picture of one range stays even: how much of it comes at all is the beam's attenuation alone
/// (light_frame.h), by which the inspection goes. The form is McGlamery's and Jaffe's, light that
/// is lost to the beam and arrives beside it, with the width of a walk of many small turns.
/// Sources: Jaffe (1990), IEEE J. Oceanic Eng. 15(2), 101-111; McGlamery (1980), Proc. SPIE 208,
/// 221-231. Their filter is of another shape, and theirs adds light: stand-ins.
///
/// The width is held at eight levels; a pixel's light is shared between the two about its own so
/// that its variance is right. Sky and open water are smooth, and not scattered. Colours alike.
/// The same bits on any number of threads.
/// @param attenuation_per_m  c of green
[[nodiscard]] LightFrame scattered_forwards(const LightFrame& light, const ForwardScatter& scatter,
                                            const Pinhole& camera, const FrameHits& hits,
                                            double attenuation_per_m, int threads);

}  // namespace slackwater::twin
