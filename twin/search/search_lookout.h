#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/numbers/random.h"
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// How the chance to see something falls with its distance r.
enum class DetectionLaw {
  inverse_cube,    ///< the eye, that finds a wake or a person by the angle it fills
  definite_range,  ///< all within half the sweep width and nothing beyond: a camera's swath
};

/// What a look-out looks through.
struct SightConditions {
  double wind_10m_m_s = 0;
  double wave_height_m = 0;  ///< significant
  double visibility_m = 0;
};

/// Who looks out, for one kind of object.
///
/// The sweep width W is the area under the chance that a straight pass finds the object over its
/// lateral range: of as many objects as lie in a strip of that width, a pass finds.
struct SearchLookout {
  std::string name;
  DetectionLaw law = DetectionLaw::inverse_cube;
  std::vector<double> visibility_m;  ///< rising
  std::vector<double> width_m;       ///< at each of these
  /// The first that holds wind and waves.
  struct Weather {
    double most_wind_m_s = std::numeric_limits<double>::infinity();
    double most_wave_height_m = std::numeric_limits<double>::infinity();
    double factor = 1;
    bool operator==(const Weather&) const = default;
  };
  std::vector<Weather> weather;  ///< rougher and rougher, the last for all else
  bool operator==(const SearchLookout&) const = default;
};

/// Reads data/lookouts/NAME.yaml, for one kind of object:
///
///     name, source, status, law: inverse_cube | definite_range
///     visibility_m: [...], sweep_width_m: {person: [...], life_raft: [...]}
///     weather: [{wind_up_to_m_s, waves_up_to_m, factor}, ..., {factor}]
///
/// @param seen_as  a key of `sweep_width_m`
/// @throws Error(invalid_input) for a name or an object that is not there, and for a look-out that
///         sees farther in worse weather
[[nodiscard]] SearchLookout read_search_lookout(const std::string& name, std::string_view seen_as,
                                                const std::filesystem::path& data_folder);

/// W, m: linear between visibilities and down to 0 at none, held above the last.
[[nodiscard]] double sweep_width_m(const SearchLookout& lookout,
                                   const SightConditions& sight) noexcept;

/// The chance to have missed something falls by exp(-exposure) over a stretch of way. By the
/// inverse cube law
///
///   exposure = W^2/(8 pi) integral ds/r^3,
///
/// exact for a straight stretch, so that a straight pass at lateral range x has W^2/(4 pi x^2) and
/// its sweep width is W whatever the speed. Infinite once something is within a definite range.
/// One who moves slower than 0.5 m/s past the object (an estimate) looks out as if at that.
///
/// @param from_m, to_m  of the object from who looks out, in the plane, before and after `dt_s`
/// Source: Koopman (1956), Operations Research 4, 503; Koopman (1980), Search and Screening.
[[nodiscard]] double look_exposure(DetectionLaw law, double width_m, const Triple<double>& from_m,
                                   const Triple<double>& to_m, double dt_s) noexcept;

/// Whether it is found in a stretch of that exposure. Draws one number.
[[nodiscard]] bool detected(double exposure, Rng& rng) noexcept;

}  // namespace slackwater::twin
