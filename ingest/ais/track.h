#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "ingest/ais/report.h"

namespace slackwater::ingest {

/// When a position was taken, of a report received at `received`: the newest instant whose second
/// is the report's, at most `early` after the receipt for clocks that differ. Without a second, the
/// receipt.
///
/// Reports are heard late: in our real logs by 1 s (shore) and 4 s (satellite) in the median, and
/// by up to a minute where a station relays them, which makes a vessel jump back. On the way along
/// the course between successive reports of vessels under way, the error against speed times time
/// falls from 26.1 to 7.0 m (root mean square, 864 pairs of the Danish log) and from 16.2 to 6.6 m
/// (41 pairs of the satellite's). A delay over 58 s cannot be seen.
[[nodiscard]] UtcTime time_of_position(UtcTime received,
                                       const std::optional<int>& utc_second) noexcept;

/// Where a vessel was and how it moved over ground.
struct AisPosition {
  UtcTime time{};  ///< by `time_of_position`
  GeoPoint point;
  std::optional<double> speed_over_ground_m_s;
  std::optional<Angle> course_over_ground;
  std::optional<Angle> heading;
  bool operator==(const AisPosition&) const = default;
};

/// All that a log says of one vessel.
struct AisTrack {
  std::uint32_t mmsi = 0;
  AisClass speaker = AisClass::a;  ///< by its positions, else by what it says of itself
  AisIdentity identity;            ///< the newest of each particular
  std::size_t reports = 0;         ///< messages of all types
  /// Times strictly ascending; may be empty. Those of type 27, to a tenth of a minute, count only
  /// where the vessel tells none that are finer: between finer ones they would make it jump.
  std::vector<AisPosition> positions;
};

/// What is known of a vessel, with what was heard in place of what was known.
void renew(AisIdentity& known, const AisIdentity& heard);

/// Sorts reports to vessels.
class AisTrackCollector {
 public:
  void add(const AisReport& report);
  [[nodiscard]] std::size_t vessels() const noexcept { return tracks_.size(); }
  [[nodiscard]] std::size_t positions() const noexcept { return positions_; }

  /// The tracks by MMSI, positions sorted by time. Of several at one time, as when several stations
  /// hear one message, the first in the log is kept.
  [[nodiscard]] std::vector<AisTrack> take() &&;

 private:
  std::map<std::uint32_t, AisTrack> tracks_;
  std::map<std::uint32_t, std::vector<AisPosition>> coarse_;  ///< of type 27
  std::size_t positions_ = 0;
};

}  // namespace slackwater::ingest
