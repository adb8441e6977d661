#pragma once
#include <optional>
#include <string>

namespace slackwater {

/// The level from which the nautical charts of a place count depths and tides: a plane below mean
/// sea level that somebody has stated, with their word for it.
struct ChartDatum {
  std::string name;                   ///< "LAT", "MLLW", "chart datum of Brest"
  double below_mean_sea_level_m = 0;  ///< at the site; Z0 of tide tables
  std::string source;                 ///< the chart or table it was read from

  /// CF: water_surface_height_above_reference_datum, from the height above mean sea level.
  [[nodiscard]] double above_m(double above_mean_sea_level_m) const noexcept {
    return above_mean_sea_level_m + below_mean_sea_level_m;
  }
  bool operator==(const ChartDatum&) const = default;
};

/// "over mean sea level; chart datum (LAT) is 5.93 m below it", or that the site states none.
[[nodiscard]] std::string datum_words(const std::optional<ChartDatum>& datum);

}  // namespace slackwater
