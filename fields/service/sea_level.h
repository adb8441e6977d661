#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "fields/grid/status.h"
#include "fields/interpolate/temporal.h"

namespace slackwater {

/// The level of the sea at one place over the stamps of a forecast: height of the surface above
/// mean sea level (the geoid), positive up. All three arrays run over Snapshot::time, or are empty:
/// no level is forecast here. A stamp without a value is NaN.
///
/// The tide moves the surface, not the datum: depths and heights count from mean sea level whatever
/// stands here.
struct SeaLevel {
  std::vector<double> level_m;     ///< of the central forecast
  std::vector<double> sigma_m;     ///< standard deviation
  std::vector<DataStatus> source;  ///< `forecast`: a product's own; `modelled`: harmonic tide

  [[nodiscard]] bool empty() const noexcept { return level_m.empty(); }
};

/// The level at one place and time.
struct SeaLevelSample {
  double level_m = 0;
  double sigma_m = 0;  ///< standard deviation; 0 for a member
  SampleStatus status = SampleStatus::missing;
};

/// Quantiles of the level: those of a normal about the central forecast, as of the current
/// (`quantiles_of`, snapshot.h).
struct SeaLevelQuantiles {
  double p10_m = 0;
  double p50_m = 0;
  double p90_m = 0;
};
/// @param central  a sample of member 0 that has a value
[[nodiscard]] SeaLevelQuantiles quantiles_of(const SeaLevelSample& central) noexcept;

/// A smooth series between even stamps: the polynomial through the six nearest of them, all that
/// there are where they are fewer. Of the M2 of Saint-Brieuc (3.6 m) with its M4 a line between
/// hours is 0.13 m off at half past; this is 1.8 mm in the first and the last hour, and better
/// between.
/// @return NaN where one of the six is
[[nodiscard]] double smooth_between(std::span<const double> values, TimePlace time) noexcept;

/// "product forecast", "harmonic tide".
[[nodiscard]] std::string_view text_of_level_source(DataStatus source) noexcept;

}  // namespace slackwater
