#pragma once
#include <filesystem>
#include <string>

#include "fields/base/config.h"
#include "fields/base/numbers/random.h"
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// Drift through the water against the 10 m wind W: slope W + offset, and how far tests lay off
/// that line.
struct LeewayLine {
  double slope = 0;  ///< m/s per m/s
  double offset_m_s = 0;
  double std_m_s = 0;
  bool operator==(const LeewayLine&) const = default;
};

/// What kind of thing drifts, as field tests have it.
struct LeewayObject {
  std::string name;
  std::string seen_as;  ///< what a lookout takes it for: a key of its sweep widths
  LeewayLine downwind;
  LeewayLine right;  ///< crosswind, right of downwind counted positive
  LeewayLine left;   ///< of those that drift to the left; its slope is most often negative
  /// How often it changes sides: 4 % an hour (Breivik and Allen 2008).
  double jibe_rate_per_s = 0.04 / 3600;
  bool operator==(const LeewayObject&) const = default;
};

/// Reads data/leeway/NAME.yaml:
///
///     name, source, status, seen_as: person
///     downwind: {slope_percent, offset_cm_s, std_cm_s}
///     crosswind_right, crosswind_left: the same
///     jibe_percent_per_h: 4
///
/// @throws Error(invalid_input) for a name that is not there, numbers that nothing drifts by
[[nodiscard]] LeewayObject read_leeway(const std::string& name,
                                       const std::filesystem::path& data_folder);

/// One line of one drifter.
struct DrawnLine {
  double slope = 0;
  double offset_m_s = 0;
};

/// One drifter of a kind: with s a standard deviation of its line and n standard normal,
///
///   slope' = slope + n s/(20 m/s),  offset' = offset + n s/2,
///
/// so that at 10 m/s drifters spread by s, by half of it in no wind. One n for downwind, one for
/// crosswind, which takes both sides further out or nearer in. Draws by which a drifter would run
/// into the wind are drawn anew.
/// Source: Breivik and Allen (2008), J. Marine Systems 69, 4.1.
struct LeewayDraw {
  DrawnLine downwind;
  DrawnLine right;
  DrawnLine left;
};
[[nodiscard]] LeewayDraw draw_leeway(const LeewayObject& object, Rng& rng);
/// One without a deviation: the lines themselves.
[[nodiscard]] LeewayDraw mean_leeway(const LeewayObject& object) noexcept;

/// m/s through the water, NED. None without wind, as an offset has no direction then.
/// @param wind_10m_m_s  NED, where to
[[nodiscard]] Triple<double> leeway_velocity(const LeewayDraw& drawn, bool is_left,
                                             const Triple<double>& wind_10m_m_s) noexcept;

}  // namespace slackwater::twin
