#pragma once
#include <vector>

#include "twin/render/frame/truth_frame.h"
#include "twin/render/lens/picture.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// How well the picture with a mark can be told from the one without by somebody who knows both:
///
///   (sum over its pixels and three colours of (e - e_bare)^2 / (e_bare + read^2))^(1/2),
///
/// e electrons (picture.h), no more than the well holds: the signal to noise ratio of the ideal
/// observer of a known signal. Nobody does better, and below about 5 people do not see it at all.
/// Sources: Rose (1948), J. Opt. Soc. Am. 38(2), 196-208; Burgess (1999), J. Opt. Soc. Am. A 16(3),
/// 633-646. The steps of 8 bits are left out: they are finer than the noise where that counts.
///
/// @param light, bare  of the same camera and hits, with all marks and with none
/// @param truth        whose marks, by its pixels
/// @param gain         of the picture that was developed of `light`
/// @param marks        how many
/// @return of each mark by its number less 1; 0: no pixel shows it
[[nodiscard]] std::vector<double> told_from_noise(const LightFrame& light, const LightFrame& bare,
                                                  const TruthFrame& truth,
                                                  const ImageSensor& sensor, double gain,
                                                  std::size_t marks);

}  // namespace slackwater::twin
