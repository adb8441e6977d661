#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A spinning scanner: so many channels from its lowest to its highest elevation, fired at as many
/// bearings all round, clockwise from its axis as seen from above its deck.
struct LidarSheet {
  int channels = 64;
  int columns = 2048;
  double lowest_rad = -0.4;
  double highest_rad = 0.4;
  double noise_sd_m = 0.02;
  double step_m = 0.001;  ///< that ranges are told in
  /// Of a white place (albedo 1) that is met squarely at the longest range in clear air, a pulse
  /// comes back with so many times the least that is told: less is a drop-out.
  double headroom = 5;
  double dropout = 0.002;  ///< share of pulses that are lost anyway
  /// Drops in the air, of spray or rain: how many a pulse meets on a metre of its way out.
  double drops_per_m = 0;
  double drops_told = 0.2;  ///< share of those met that throw back enough to be told as a range
};

/// What one turn of a scanner measured, channel by channel.
struct LidarScan {
  int channels = 0;
  int columns = 0;
  std::vector<float> range_m;       ///< as told, with noise, some of drops; NaN: nothing came back
  std::vector<float> true_range_m;  ///< of what the pulse met; NaN: nothing within reach
  std::vector<std::uint16_t> instance;  ///< 1 + the thing's place; 0: nothing
  std::vector<float> intensity;         ///< of the least that is told
};

/// Unit, NED, of a channel and a column.
[[nodiscard]] Triple<double> lidar_direction(const LidarSheet& sheet, const Pose& pose, int channel,
                                             int column) noexcept;

/// A turn. What comes back of a pulse is, of the least that is told,
///
///   headroom A cos(i) (r_max / r)^2 exp(-2 c r)
///
/// with A the albedo of red, near what lidars see (an estimate), i off the normal: a Lambert face
/// that the whole beam meets. Water throws nothing back but within 2 degrees of squarely (a
/// mirror). A pulse meets its first drop at an exponential range of mean 1/drops_per_m: where that
/// is before what it would meet, or nothing stands within reach, the drop is told as its range, or
/// none is. So of pulses at r a share 1 - exp(-drops_per_m r) is lost. Noise is normal, drop-outs
/// even; both rest on (seed, channel, column) alone.
/// @param caster  of the scene's things, in their order, with the sea among them
[[nodiscard]] LidarScan scanned(const RenderScene& scene, const RayCaster& caster,
                                const LidarSheet& sheet, const Pose& pose, double least_range_m,
                                double most_range_m, double attenuation_per_m, std::uint64_t seed,
                                int threads);

}  // namespace slackwater::twin
