#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/skill/method.h"
#include "calibration/skill/score.h"
#include "fields/base/time.h"
#include "fields/service/forecast_origin.h"
#include "fields/service/wind_policy.h"

namespace slackwater::calibration {

/// The lower end of the deepest band.
inline constexpr double whole_column_m = 1e5;

/// Both ends included, metres below mean sea level; or metres above the bed.
struct DepthBand {
  double from_m = 0;
  double to_m = 0;
  bool above_bed = false;  ///< from_m and to_m are heights above the bed
  bool operator==(const DepthBand&) const = default;
};

/// Whether a level belongs to a band. A level given as deeper than the water stands on the bed.
[[nodiscard]] bool holds(const DepthBand& band, double depth_m, double water_depth_m) noexcept;

/// The whole column and the bands that operators speak of: 0-5, 5-20, 20-50, below 50 m, and the
/// 5 m above the bed.
[[nodiscard]] std::vector<DepthBand> standard_bands();

/// "0,150" or "0,5,20,50": edges of neighbouring bands. Throws Error(usage).
[[nodiscard]] std::vector<DepthBand> parse_bands(const std::string& text);

/// (from, to] hours after the end of D.
struct LeadBin {
  double from_h = 0;
  double to_h = 24;
  bool operator==(const LeadBin&) const = default;
};

/// What is scored. Vectors go by a name for both components; CF has one for the speed alone.
inline constexpr const char* current_variable = "sea_water_velocity";
inline constexpr const char* wind_variable = "wind";
inline constexpr const char* wave_variable = "sea_surface_wave_significant_height";

struct VerifyOptions {
  std::optional<UtcDay> from;  ///< day D, both ends included
  std::optional<UtcDay> to;
  std::vector<std::int64_t> forecasts;     ///< only these ids of the store; empty: all in the range
  UtcTime issued_before = UtcTime::max();  ///< only forecasts of the store issued earlier
  std::optional<ForecastOrigin> only;      ///< only forecasts of the store of this origin
  UtcTime truth_until = UtcTime::max();    ///< truth that ends later is not looked at
  /// The forecasts were made from an archive, whenever it was read: what came in after their issue
  /// is not hidden from the baselines.
  bool from_archive = false;
  ForecastOrigin origin = ForecastOrigin::forecast;  ///< of the forecasts that are scored
  std::vector<DepthBand> bands;  ///< empty: the whole column and the standard bands
  std::vector<LeadBin> leads{{0, 24}, {24, 48}, {48, 72}};  ///< whole hours
  bool by_hour = true;      ///< also each hour of lead, for the first band
  bool per_column = false;  ///< each column beside the pooled figures
  bool traces = false;      ///< keep what a page draws of each forecast
  int threads = 1;
};

/// What the errors of a variable are counted in: "m s-1", or "m" for the height of waves.
/// @param variable  of a SkillEntry
[[nodiscard]] std::string_view unit_of(std::string_view variable);

/// One line of skill: a method against the truth, for one issued forecast, band and lead. Like with
/// like: a baseline is scored over the values (column, level, time) that our forecast has too, and
/// carries our own error over exactly those; our forecast stands over all of its own.
struct SkillEntry {
  std::string variable;  ///< `current_variable`, `wind_variable` or `wave_variable`
  std::string site;
  std::optional<std::size_t> column;  ///< nothing: pooled over columns
  UtcDay day{};
  UtcTime issued{};
  ForecastOrigin origin = ForecastOrigin::forecast;  ///< issued, or made over the past
  WindPolicy wind = WindPolicy::best;
  std::optional<DepthBand> band;  ///< nothing for wind and waves
  LeadBin lead;
  Method method = Method::forecast;
  VectorScore vector;                 ///< for currents and wind
  std::optional<ScalarScore> scalar;  ///< for waves
  /// RMSE of our forecast over exactly these values, in the unit of the variable. Empty for our
  /// forecast itself, and where it has no value in this band and lead at all.
  std::optional<double> forecast_rmse;
  /// Of the RMSE, over the hours of lead in their order; empty where they are few.
  std::optional<Interval95> interval;
  std::string truth;            ///< the dataset or station it was held against
  Duration truth_averaging{0};  ///< of its values (`averaging_of`); 0: instants
  bool hindsight = false;       ///< the forecast was made so (`Snapshot::hindsight`)
  bool simulated_wind = false;  ///< it was driven so (`Snapshot::simulated_wind`)
};

/// The RMSE of an entry, in the unit of its variable.
[[nodiscard]] double rmse_of(const SkillEntry& entry) noexcept;

}  // namespace slackwater::calibration
