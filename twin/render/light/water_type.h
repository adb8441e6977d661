#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "fields/base/config.h"
#include "twin/inspection/instrument/clarity.h"

namespace slackwater::twin {

/// Red, green and blue, by one wavelength each: 600, 550 and 450 nm.
using Bands = std::array<double, 3>;
inline constexpr std::size_t green = 1;

/// How water takes the colours, as data/waters has it: Jerlov's types by their downward irradiance.
struct WaterType {
  std::string name;
  Bands diffuse_attenuation_per_m{};  ///< K_d
  std::string source;
  std::string status;
};

/// One file of data/waters:
///
///     name: Jerlov coastal 3
///     source: ...
///     status: confirmed
///     diffuse_attenuation_per_m: {red_600_nm: 0.33, green_550_nm: 0.19, blue_450_nm: 0.39}
///
/// @throws Error(invalid_input)
[[nodiscard]] WaterType read_water_type(const Config& config);
/// @throws Error(invalid_input) for a name that is none of those in the folder, and as above
[[nodiscard]] WaterType read_named_water_type(const std::string& name,
                                              const std::filesystem::path& data_folder);

/// What a look goes through, by colour.
struct ColouredClarity {
  Bands beam_attenuation_per_m{};     ///< c
  Bands diffuse_attenuation_per_m{};  ///< K
  double backscatter_per_m = 0;       ///< b_b, the same for all: particles are larger than waves
  double daylight = 1;                ///< of what is needed, at the surface
};

/// The clarity that the inspection goes by, in colours: green has its c, K and b_b to the bit, so
/// that both tell of one water. With s = K_d / K_d(green) of the type,
///
///   K = K(green) s,   c = c(green) + mu (K - K(green)),   but no less than b_b,
///
/// for absorption is what differs by colour, scattering hardly: K = a / mu with mu = 0.83, a mean
/// cosine of daylight near the surface. Sources: Kirk (1994), Light and Photosynthesis in Aquatic
/// Ecosystems, ch. 6 (K by a and mu; mu an estimate within its range); Jerlov (1976), Marine
/// Optics, table XXVII (K_d).
[[nodiscard]] ColouredClarity coloured(const Clarity& clarity, const WaterType& type) noexcept;
/// Air: all colours alike, fog and haze being droplets larger than the waves of light. No light
/// fades with height.
[[nodiscard]] ColouredClarity colourless(const Clarity& clarity) noexcept;

}  // namespace slackwater::twin
