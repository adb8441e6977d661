#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/sensor/adcp.h"

namespace slackwater::twin {

/// What speaks against a bin's velocity.
enum class BinFlaw : std::uint8_t {
  none,
  side_lobe,  ///< fewer than three beams are free of what the boundary throws into side lobes
  no_water,   ///< nobody knows the current there: outside of the forecast, below its bed
};
[[nodiscard]] const char* name_of(BinFlaw flaw) noexcept;

/// A bin of a profile. NaN where there is no value.
struct ProfileBin {
  double distance_m = 0;  ///< of its centre along the instrument's axis
  double depth_m = 0;     ///< of that place below mean sea level
  /// Of approach along each beam, folded into the ambiguity, with noise: what the instrument
  /// itself hears.
  std::array<float, 4> approach_m_s{};
  Triple<double> velocity_m_s;       ///< of the water over ground, NED, as told
  Triple<double> true_velocity_m_s;  ///< the bin's mean along the axis
  double error_m_s = 0;              ///< by which the two planes of beams disagree; NaN with three
  BinFlaw flaw = BinFlaw::none;
};

/// One ping, or the mean of as many as the sheet says.
struct CurrentProfile {
  std::array<Triple<double>, 4> beams;      ///< unit, NED
  std::array<float, 4> boundary_range_m{};  ///< of what each beam meets; NaN: nothing in reach
  std::vector<ProfileBin> bins;
};

/// The profile that an acoustic Doppler current profiler (twin/sensor/adcp.h) makes at a moment, as
/// that one does, but that its beams meet the triangles of a scene: bed, piles, the sea's waves.
/// Along each beam, with v the instrument's velocity and u the water's, orbital motion of waves
/// included, averaged over the bin (`bin_mean`),
///
///   s = fold((v - u) . b) + sd/sqrt(pings) e,
///
/// and the water's velocity is v less what least squares over the beams make of s: exact, but for
/// the noise, where all beams meet the same water, and for any flow that is linear in depth for an
/// instrument that stands level. v is the log's: no error of its own.
///
/// A beam that meets something at range r knows no bin that reaches beyond r cos(slant)^2 along the
/// axis: the boundary, r cos(slant) off, throws its echo into the side lobe that looks at it
/// squarely. So the last 1 - cos(slant) of the way to it is lost, 6 % at 20 degrees.
///
/// @param pose    its axis is the instrument's, whichever way that looks; beam azimuths count from
///                right x axis, forward of one that looks down, towards right
/// @param water   velocity, NED; NaN where there is none
/// @param seed    noise by (seed, beam, bin) alone
[[nodiscard]] CurrentProfile profiled(const RayCaster& caster, const Adcp& adcp,
                                      const WaterAt& water, const Pose& pose, double most_range_m,
                                      std::uint64_t seed);

}  // namespace slackwater::twin
