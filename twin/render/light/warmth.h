#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "fields/base/config.h"
#include "twin/render/scene/seen_class.h"

namespace slackwater::twin {

/// How warm a material is, and how much of what a black body would radiate it does.
struct SurfaceWarmth {
  double temperature_k = 288;  ///< where no sun falls on it
  double in_sun_k = 0;         ///< more, for each kW/m2 of the sun's beam that falls on it
  double emissivity = 0.95;    ///< in the camera's band
};

/// How warm all is, as data/warmth has it: stated, for no forecast of ours tells it. A stand-in for
/// a balance of heat: no wind cools, no shadow of a minute ago is left, no sun warms the far side.
struct Warmth {
  std::string name;
  std::string source;
  std::string status;
  double air_k = 288;
  double sky_overhead_k = 230;        ///< of a clear sky overhead, as a black body in the band
  double cloud_k = 278;               ///< of an overcast one, all over
  double attenuation_per_m = 0.0002;  ///< of clear air, in the band
  std::array<SurfaceWarmth, materials> surfaces;

  [[nodiscard]] const SurfaceWarmth& of(Material material) const noexcept {
    return surfaces[static_cast<std::size_t>(material)];
  }
};

/// One file of data/warmth:
///
///     name: Summer day
///     source: ...
///     status: estimate
///     air_c: 16
///     sky_overhead_c: -40
///     cloud_c: 6
///     attenuation_per_km: 0.25
///     surfaces:                       # each material by its name, but `none`
///       steel: {temperature_c: 17, in_sun_k: 14, emissivity: 0.8}
///
/// @throws Error(invalid_input)
[[nodiscard]] Warmth read_warmth(const Config& config);
/// @throws Error(invalid_input) for a name that is none of those in the folder, and as above
[[nodiscard]] Warmth read_named_warmth(const std::string& name,
                                       const std::filesystem::path& data_folder);

}  // namespace slackwater::twin
