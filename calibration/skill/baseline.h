#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/skill/method.h"
#include "fields/base/angle.h"
#include "fields/base/time.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The methods that `make_baseline` has a recipe for.
inline constexpr std::array all_baselines{
    Method::persistence,   Method::day_mean,    Method::same_hour,     Method::tide_phase,
    Method::tide_harmonic, Method::oracle_mean, Method::reference_slab};

class ColumnTide;

/// All that a baseline may know at the end of day D.
struct BaselineInput {
  UtcDay day;                          ///< D, closed: [00:00, 24:00]
  const VectorColumn& current;         ///< history up to and including D, m/s; nothing later
  const VectorColumn* wind = nullptr;  ///< 10 m wind, m/s, towards, one level; null: no wind
  Angle latitude;                      ///< of the column
  /// The wind of the end of D held; else the wind as stored. The wind at 24:00 lies on the line
  /// between the stamps around it, so a caller that wants nothing later than D passes a wind column
  /// that ends with D.
  bool persist_wind = false;
  /// The tide of `current` on D where the caller has fitted it already, so that the baselines that
  /// need it share it; null: they fit it themselves.
  const ColumnTide* tide = nullptr;
  /// Values before lack the tide; `UtcTime::max()`: all of them are detided.
  UtcTime tide_since = UtcTime::min();
};

/// A baseline evaluated at the truth's own cells: the instant, or the average over a mean's
/// interval.
struct BaselineForecast {
  std::vector<Horizontal> value;     ///< truth times x levels of the current, level fastest, m/s
  std::vector<SampleStatus> status;  ///< ok, or missing where this level could not be forecast
  [[nodiscard]] bool has(std::size_t i) const noexcept { return has_value(status[i]); }
};

/// A forecast, or the reason why there is none ("record of 4.0 days; tide-harmonic needs 15").
struct BaselineOutcome {
  std::optional<BaselineForecast> forecast;
  std::string reason;
};

/// Makes one baseline; pure. Recipes of the page "Baselines of the D -> D+1 current forecast".
///
/// @param baseline    one of `all_baselines`
/// @param truth_time  cells to forecast, all after the end of D, in any order
/// @param truth       needed by `oracle_mean` alone: a column on the same levels that holds the
///                    truth; else ignored
/// Of currents without tide there is neither tide_harmonic nor tide_phase, and reference_slab does
/// without its tide: what they would carry on is weather.
/// Throws ContractViolation where the history reaches beyond D, or for a method without a recipe.
/// Cost: below 1 ms a column without tide.
[[nodiscard]] BaselineOutcome make_baseline(Method baseline, const BaselineInput& input,
                                            std::span<const TimeCell> truth_time,
                                            const VectorColumn* truth = nullptr);

}  // namespace slackwater::calibration
