#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/status.h"
#include "fields/service/averaged_currents.h"
#include "fields/service/provenance.h"
#include "fields/service/sea_level.h"
#include "fields/service/wind_policy.h"

namespace slackwater {

/// Sea state at one time; NaN where the forecast has none.
struct SeaState {
  double significant_height_m = 0;
  double peak_period_s = 0;
  double from_direction_deg = 0;  ///< clockwise from true north, where waves come from
};

/// The forecast at one place: every array runs over Snapshot::time, current arrays over time x
/// depth (depth fastest), member arrays over member x time [x depth].
struct ForecastColumn {
  GeoPoint point;
  double water_depth_m = 0;
  std::string water_depth_source;            ///< "site", "bathymetry" or "deepest wet level"
  std::vector<Horizontal> current_m_s;       ///< member 0, the central one; Eulerian, towards
  std::vector<double> current_sigma_m_s;     ///< standard deviation of each component
  std::vector<SampleStatus> current_status;  ///< the same for all members
  /// Members 1, 2, ... of the current; member 0 is `current_m_s` and not kept twice. Empty where
  /// this column has none: no ensemble was made, or its members were left in the file.
  std::vector<Horizontal> member_m_s;
  std::vector<Horizontal> wind_m_s;     ///< at 10 m, towards; empty if the forecast has no wind
  std::vector<DataStatus> wind_source;  ///< per time
  /// Wind of members 1, 2, ...; member n of the wind drives member n of the current. Empty where
  /// all members share `wind_m_s`.
  std::vector<Horizontal> wind_member_m_s;
  /// Of members 1, 2, ...: the number, as its provider counts, of the weather ensemble's member
  /// whose wind it has. Empty where the winds are of no ensemble.
  std::vector<int> wind_member_number;
  std::vector<SeaState> sea;           ///< empty if the forecast has no waves
  std::vector<DataStatus> sea_source;  ///< per time
  /// Standard deviation of the error of ln(Hs + 0.3 m) per time (fields/wave/height_error.h); empty
  /// without waves, and of forecasts from before they said so (`height_spread_of`).
  std::vector<double> height_spread;
  SeaLevel sea_level;  ///< empty if the forecast has none
};

/// One forecast as issued: everything needed to answer "what is the water doing here, then".
/// Immutable.
struct Snapshot {
  std::string site_id;
  std::string site_name;
  UtcDay day;  ///< day D, the last calibrated day
  UtcTime issued;
  std::optional<WindPolicy> wind_policy;  ///< nothing: made up, its wind is nobody's forecast
  std::vector<UtcTime> time;              ///< hourly from the end of D, both ends included
  std::vector<double> depth_m;            ///< below mean sea level, ascending
  std::vector<ForecastColumn> columns;
  std::size_t members = 1;  ///< equally likely futures as issued, the central one among them
  std::uint64_t seed = 0;   ///< of the run: all randomness comes from (seed, stream name)
  bool degraded = false;
  bool contains_stokes = false;  ///< the currents it was fitted to still hold Stokes drift
  /// Wind or waves beyond D were not known at the issue time: no forecast that anybody could have
  /// made then.
  bool hindsight = false;
  /// No run of the wind was kept: the later analysis with a forecast's error drawn stands for one.
  bool simulated_wind = false;
  /// Whose members `wind_member_number` counts: "PRODUCT issued TIME"; empty where none has one.
  std::string wind_ensemble;
  /// The currents it was fitted to are means over hours; nothing: instants, or means that hold the
  /// tide.
  std::optional<AveragedCurrents> averaged;
  std::string headline;  ///< one sentence a coordinator reads first
  std::vector<std::string> attributions;
  Provenance provenance;
};

/// Whether a column has a current at any time and depth.
[[nodiscard]] bool has_currents(const ForecastColumn& column) noexcept;
/// Whether any column has waves.
[[nodiscard]] bool has_waves(const Snapshot& forecast) noexcept;
/// The current of a member over time x depth, a view; empty where the column does not hold it.
[[nodiscard]] std::span<const Horizontal> current_of_member(const ForecastColumn& column,
                                                            std::size_t member) noexcept;
/// The wind that belongs to a member, over time, a view; the central wind where all members share
/// it, empty where the column does not hold it.
[[nodiscard]] std::span<const Horizontal> wind_of_member(const ForecastColumn& column,
                                                         std::size_t member) noexcept;

/// The current at one place, depth and time.
struct CurrentSample {
  Horizontal velocity_m_s{};
  double sigma_m_s = 0;  ///< standard deviation of each component
  SampleStatus status = SampleStatus::missing;
};

/// Quantiles of each component of the current.
struct CurrentQuantiles {
  Horizontal p10_m_s{};
  Horizontal p50_m_s{};
  Horizontal p90_m_s{};
};

/// The one definition of the quantiles that file, profile and pages show: those of a normal about
/// the central forecast with its standard deviation,
///
///   p10, p50, p90 = W - z sigma, W, W + z sigma  (east and north alike),  z = normal_p90
///
/// Sigma is the calibrated spread, and the maker of the members scales them to it. Members are not
/// counted out: the p10 of twenty draws scatters by 0.38 sigma (sqrt(p (1 - p) / n) / density).
///
/// @param central  a sample of member 0 that has a value
[[nodiscard]] CurrentQuantiles quantiles_of(const CurrentSample& central) noexcept;

}  // namespace slackwater
