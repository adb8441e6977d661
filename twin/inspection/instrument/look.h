#pragma once
#include <cstdint>
#include <limits>

#include "twin/inspection/instrument/instrument.h"

namespace slackwater::twin {

/// What a look goes through.
struct Clarity {
  double beam_attenuation_per_m = 0;     ///< c of the medium between, at the instrument's light
  double daylight = 1;                   ///< of what is needed, at the surface; 0: night
  double diffuse_attenuation_per_m = 0;  ///< K of daylight with depth
  double backscatter_per_m = 0;          ///< b_b: what is scattered back of a lamp's light
  bool operator==(const Clarity&) const = default;
};

/// Where an instrument is at a moment: NED of the run.
struct Pose {
  Triple<double> position_m;    ///< of the instrument
  Triple<double> axis;          ///< unit
  Triple<double> right;         ///< unit, of the picture or the fan
  Triple<double> velocity_m_s;  ///< of the instrument, over ground
  Triple<double> turning_rad_s;
};

/// How well a place is seen in one look.
struct LookQuality {
  double range_m = 0;
  double incidence_cosine = 0;   ///< 1: squarely
  double ground_sampling_m = 0;  ///< of a pixel or a beam on the surface, along its longer side
  double blur_m = 0;             ///< by motion while it is exposed, on the surface
  double contrast = 1;           ///< share of the light that comes from the place: seen_light.h
  double light = 1;              ///< of what is needed, at most 1
  /// The least detail that is made out: (sampling^2 + blur^2)^(1/2) / (contrast light).
  double detail_m = std::numeric_limits<double>::infinity();
};

/// The best that a patch was seen by one instrument so far. Single precision: there are many.
struct BestLook {
  float detail_m = std::numeric_limits<float>::infinity();  ///< infinite: not seen
  float range_m = 0;
  float incidence_cosine = 0;
  float ground_sampling_m = 0;
  float blur_m = 0;
  float contrast = 0;
  float light = 0;
  float t_s = 0;          ///< since the epoch
  float off_north_m = 0;  ///< where the vehicle took itself to be then, less where it was
  float off_east_m = 0;
  float off_down_m = 0;
  std::uint32_t looks = 0;  ///< in all

  [[nodiscard]] bool is_seen() const noexcept { return looks > 0; }
};

}  // namespace slackwater::twin
