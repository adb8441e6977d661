#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A side-scan sonar: two fans across its axis, one to port and one to starboard, each thin along
/// the axis and tall across it, whose echoes fall into bins of slant range.
struct SideScanSheet {
  double beam_rad = 0.0052;       ///< along the axis, between half-power points
  double upright_rad = 0.87;      ///< of each fan, likewise
  double depression_rad = 0.6;    ///< of each fan's middle, below the plane of axis and right
  int rays = 2048;                ///< cast on each side, in each slice
  int slices = 3;                 ///< that the fan is cut into along the axis
  int bins = 1024;                ///< of each side, from 0 to the longest range
  double absorption_db_m = 0.29;  ///< one way
  double mackenzie_db = -27;      ///< 10 log10(mu) of the bed: echo.h
  double noise_floor = 1e-12;     ///< intensity of noise in a bin, in the units of the picture
};

enum class ScanSide { port, starboard };

/// One ping: the port side and then the starboard one, each from near to far.
struct SideScanPing {
  int bins = 0;  ///< of each side
  double bin_m = 0;
  double taken_per_m = 0;        ///< x of what the water took of an echo, exp(-x r)
  std::vector<float> intensity;  ///< with speckle and noise; of a source of 1 at 1 m, both ways
  std::vector<float> mean;       ///< without
  /// 1 + the place of what throws back most of the bin's echo; 0: nothing, open water or a shadow.
  std::vector<std::uint16_t> instance;

  [[nodiscard]] std::size_t place(ScanSide side, int bin) const noexcept {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(bins) +
           static_cast<std::size_t>(bin);
  }
};

/// Unit, NED: to a side, so far below the plane of axis and right, and so far towards the axis from
/// the plane across it: cos(along) (cos(below) right + sin(below) down) + sin(along) axis.
[[nodiscard]] Triple<double> side_scan_direction(const Pose& pose, ScanSide side, double below_rad,
                                                 double along_rad) noexcept;

/// One ping. A fan is cast into from 1.5 half-power widths below its middle, straight down at most,
/// to as much above. Its rays stand evenly in the cotangent of their angle below the plane, which
/// is evenly over a level bed, and evenly in angle from 3 degrees below it upwards; so the bed far
/// off has as many as the bed near by. A ray stands for the angles half-way to both its neighbours:
/// it sees the plane of the triangle that it meets, and its echo (echo.h) is laid evenly over the
/// bins from where that plane is at one of them to where it is at the other. So no bin of a bed is
/// left out, however fine, and a shadow begins and ends within half of a ray's step.
///
/// Along the axis a fan is cut into slices over three half-power widths; each weighs by its
/// pattern, all of them together the beam's width.
///
/// Speckle and noise by (seed, side, bin) alone. Nothing comes by way of the surface.
/// @param caster  of the scene's things, in their order
/// @param pose    its axis along the track, its right to starboard
[[nodiscard]] SideScanPing side_scanned(const RenderScene& scene, const RayCaster& caster,
                                        const SideScanSheet& sheet, const Pose& pose,
                                        double least_range_m, double most_range_m,
                                        std::uint64_t seed, int threads);

}  // namespace slackwater::twin
