#include "twin/inspection/instrument/quality.h"

#include <algorithm>
#include <cmath>

#include "twin/inspection/instrument/seen_light.h"

namespace slackwater::twin {
namespace {

/// A place of a surface as an instrument looks at it.
struct Sight {
  const Instrument& instrument;
  const Pose& pose;
  Triple<double> way_m;  ///< from the instrument to the place: q
  Triple<double> normal;
  double range_m = 0;

  /// P s: along the line of sight onto the surface.
  [[nodiscard]] Triple<double> laid_on(const Triple<double>& s) const {
    return s - (dot(normal, s) / dot(normal, way_m)) * way_m;
  }
  /// How fast what it is pointed at runs over the surface, m/s.
  [[nodiscard]] double runs_m_s() const {
    return length_of(laid_on(pose.velocity_m_s + cross(pose.turning_rad_s, way_m)));
  }
};

void measure(const FrameFootprint& frame, const Sight& sight, LookQuality& quality) {
  const double depth_m = dot(sight.way_m, sight.pose.axis);
  const Triple<double> down = cross(sight.pose.axis, sight.pose.right);
  const double wide = 2 * std::tan(frame.horizontal_rad / 2) / frame.pixels_wide;
  const double high = 2 * std::tan(frame.vertical_rad / 2) / frame.pixels_high;
  quality.ground_sampling_m =
      std::abs(depth_m) * std::max(wide * length_of(sight.laid_on(sight.pose.right)),
                                   high * length_of(sight.laid_on(down)));
  quality.blur_m = frame.exposure_s * sight.runs_m_s();
}

void measure(const FanFootprint& fan, const Sight& sight, LookQuality& quality) {
  const Triple<double> along = cross(sight.pose.right, sight.pose.axis);
  const Triple<double> across = (1 / sight.range_m) * cross(along, sight.way_m);
  quality.ground_sampling_m =
      std::max({sight.range_m * fan.beam_across_rad * length_of(sight.laid_on(across)),
                sight.range_m * fan.beam_along_rad * length_of(sight.laid_on(along)),
                sight.runs_m_s() / fan.pings_per_s});
}

void measure(const SpotFootprint& spot, const Sight& /*sight*/, LookQuality& quality) {
  quality.ground_sampling_m = spot.spot_m;
}

void measure(const RoundFootprint& round, const Sight& sight, LookQuality& quality) {
  quality.ground_sampling_m = round.detail_m * sight.range_m / sight.instrument.most_range_m;
}

}  // namespace

std::optional<LookQuality> quality_of(const Instrument& instrument, const Pose& pose,
                                      const Clarity& clarity, const Triple<double>& centre_m,
                                      const Triple<double>& normal) noexcept {
  Sight sight{instrument, pose, centre_m - pose.position_m, normal, 0};
  sight.range_m = length_of(sight.way_m);
  const double range_m = sight.range_m;
  if (!(range_m > 0 && range_m >= instrument.least_range_m && range_m <= instrument.most_range_m))
    return std::nullopt;
  LookQuality quality;
  quality.range_m = range_m;
  quality.incidence_cosine = -dot(sight.way_m, normal) / range_m;
  constexpr double edge_on = 1e-3;
  if (std::holds_alternative<RoundFootprint>(instrument.footprint))
    quality.incidence_cosine = std::abs(quality.incidence_cosine);
  else if (!(quality.incidence_cosine > edge_on))
    return std::nullopt;
  std::visit([&](const auto& footprint) { measure(footprint, sight, quality); },
             instrument.footprint);
  const SeenLight seen = seen_light(instrument, clarity, centre_m.z, range_m);
  if (instrument.kind != InstrumentKind::lidar && is_lost(seen.contrast)) return std::nullopt;
  quality.contrast = seen.contrast;
  quality.light = seen.light;
  quality.detail_m =
      std::hypot(quality.ground_sampling_m, quality.blur_m) / (quality.contrast * quality.light);
  if (!std::isfinite(quality.detail_m)) return std::nullopt;
  return quality;
}

}  // namespace slackwater::twin
