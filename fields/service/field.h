#pragma once
#include <memory>
#include <span>
#include <vector>

#include "fields/service/column_layout.h"
#include "fields/service/current_table.h"
#include "fields/service/place.h"

namespace slackwater {

/// A forecast as issued, laid out so that wind, waves, current and bed are had at any place and
/// time.
///
/// Between columns as `ColumnLayout` says, linear in time between stamps, linear in depth between
/// levels. The vertical rule: depths count from mean sea level; the first level speaks for the
/// water above it, the deepest wet level for the water down to the bed, `carried` where that is far
/// (bed_rule.h). Above the surface, below the bed, on land, outside the area and outside the time
/// is a status, never a number. The bed is interpolated like all else, and a column whose own bed
/// is above a depth has no say there.
///
/// Immutable; all samplers are const, thread-safe, without locks and allocations. Batch calls are
/// the real interface: `out` has the length of `places`.
class Field {
 public:
  /// Keeps the snapshot. @throws ContractViolation for one without columns or times
  explicit Field(std::shared_ptr<const Snapshot> snapshot);

  [[nodiscard]] const Snapshot& snapshot() const noexcept { return *snapshot_; }
  [[nodiscard]] const ValidRange& range() const noexcept { return range_; }

  /// The Eulerian current, towards.
  /// @param member  0: the central forecast, with its sigma; another: one future of the ensemble,
  ///                sigma 0; `missing` where it is not held
  void sample_current(std::span<const Place> places, std::span<CurrentSample> out,
                      std::size_t member = 0) const noexcept;
  /// One place, many times and depths: the stencil is made once. @param out  times x depths
  void sample_profiles(double longitude_deg, double latitude_deg, std::span<const UtcTime> times,
                       std::span<const double> depths_m, std::span<CurrentSample> out,
                       std::size_t member = 0) const noexcept;
  void sample_profile(double longitude_deg, double latitude_deg, UtcTime time,
                      std::span<const double> depths_m, std::span<CurrentSample> out,
                      std::size_t member = 0) const noexcept;
  /// The mean wind, brought from 10 m to the height asked by the neutral logarithmic profile.
  void sample_wind(std::span<const Place> places, std::span<WindSample> out,
                   std::size_t member = 0) const noexcept;
  /// Heights and periods linear, the direction through vectors weighted by energy.
  void sample_sea(std::span<const Place> places, std::span<SeaSample> out) const noexcept;
  /// The level of the sea, smooth between stamps (`smooth_between`).
  /// @param member  0: the central forecast, with its sigma; another: the same off by an error of
  ///                its own, which keeps its share of sigma over the whole forecast; `missing`
  ///                where the forecast has no such member. Errors come in opposite pairs,
  ///                seeded by the forecast.
  void sample_sea_level(std::span<const Place> places, std::span<SeaLevelSample> out,
                        std::size_t member = 0) const noexcept;
  void sample_bed(std::span<const Place> places, std::span<BedSample> out) const noexcept;

  /// One place; the same bits as in a batch.
  [[nodiscard]] CurrentSample current(const Place& place, std::size_t member = 0) const noexcept;

 private:
  struct Spot {  ///< a stencil and the bed there
    ColumnStencil stencil;
    double water_depth_m = 0;
    SampleStatus status = SampleStatus::missing;  ///< ok: water
  };
  [[nodiscard]] WindSample wind_at(const Place& place, std::size_t member) const noexcept;
  [[nodiscard]] SeaSample sea_at(const Place& place) const noexcept;
  [[nodiscard]] SeaLevelSample level_at_place(const Place& place,
                                              std::size_t member) const noexcept;
  [[nodiscard]] Spot spot(double longitude_deg, double latitude_deg) const noexcept;
  [[nodiscard]] std::optional<TimePlace> when(UtcTime time) const noexcept;
  /// Whether there is water at a depth: ok, or carried. Columns whose own bed is above it lose
  /// their weight in `stencil`.
  [[nodiscard]] SampleStatus water(ColumnStencil& stencil, double depth_m) const noexcept;
  [[nodiscard]] double bed_m(const ColumnStencil& stencil) const noexcept;
  [[nodiscard]] SampleStatus known(const ColumnStencil& stencil, double depth_m) const noexcept;

  std::shared_ptr<const Snapshot> snapshot_;
  ColumnLayout layout_;
  std::vector<CurrentTable> member_;
  std::vector<double> level_error_;  ///< of each member, in standard deviations
  std::vector<double> water_depth_m_;
  std::vector<double> known_to_m_;
  double shallowest_m_ = -1;        ///< of all beds; below 0 where one of them is no number
  double shallowest_known_m_ = -1;  ///< of the depths down to which all columns know the water
  double stamps_per_ms_ = 0;        ///< where stamps are even; else 0
  ValidRange range_;
};

}  // namespace slackwater
