#pragma once
#include <optional>
#include <string>

#include "fields/base/config.h"
#include "fields/service/snapshot.h"

namespace slackwater::twin {

/// Which waves a limit on their height is of, as a hull's tables have them: those that come from a
/// sector about its bow, those of some periods, or both. Sides are alike.
struct WaveSector {
  std::optional<Range>
      off_bow_rad;  ///< between the bow and where the waves come from: 0, head seas
  std::optional<Range> peak_period_s;
  std::optional<double> heading_rad;  ///< of the hull, from true north; absent: the vehicle's own
  bool operator==(const WaveSector&) const = default;

  /// Also where nobody knows the period, or the direction: then the waves may be of it.
  /// @param heading_rad  the vehicle's
  [[nodiscard]] bool holds(const SeaState& sea, double heading_rad) const noexcept;
  /// Whether it goes by the vehicle's own heading.
  [[nodiscard]] bool goes_by_heading() const noexcept { return off_bow_rad && !heading_rad; }
};

/// `from_bow_deg: [45, 135]`, `heading_deg: 210`, `peak_period_between_s: [8, 30]` of a limit;
/// nothing where it has none of them. @throws Error(invalid_input)
[[nodiscard]] std::optional<WaveSector> read_wave_sector(const Config& config);

/// "from 45 to 135 degrees off the bow (heading 210), peak period 8 to 30 s".
[[nodiscard]] std::string text_of(const WaveSector& sector);

}  // namespace slackwater::twin
