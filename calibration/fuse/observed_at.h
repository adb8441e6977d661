#pragma once
#include <optional>

#include "calibration/fuse/fusion_settings.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// One level of an observed series brought to the time cells of a product: averaged over a mean,
/// interpolated to an instant. Nothing where the observations fill too little of the cell, or the
/// neighbours lie too far apart. Uses nothing that lies outside the cell, or beyond the next
/// sample.
class ObservedLevel {
 public:
  ObservedLevel(const VectorColumn& observed, std::size_t level, const FusionSettings& settings);

  [[nodiscard]] std::optional<Horizontal> at(const TimeCell& cell) const;

  /// The share of a sample's noise variance that is left in `at`: that of a mean over the samples
  /// of a whole cell; all of it at an instant, which may be a sample itself.
  [[nodiscard]] double noise_left(const TimeCell& cell) const;

 private:
  [[nodiscard]] bool averages(const TimeCell& cell) const;
  [[nodiscard]] std::optional<Horizontal> at_instant(UtcTime time) const;
  [[nodiscard]] std::optional<Horizontal> over(const TimeCell& cell) const;

  Duration widest_gap_;
  double least_coverage_;
  Duration step_{};  ///< the usual one
  std::vector<TimeCell> cells_;
  std::vector<Horizontal> value_;
};

}  // namespace slackwater::calibration
