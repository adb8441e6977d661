#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/angle.h"
#include "fields/base/time.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// What a forecast is compared with. All but `oracle_mean` know nothing of the days after D.
enum class Baseline {
  persistence,     ///< the last value of D, held
  day_mean,        ///< mean of D
  same_hour,       ///< the value 24 h before; beyond 24 h of lead the last day repeats
  tide_phase,      ///< the value two M2 periods (24.84 h) before, repeated likewise
  tide_harmonic,   ///< mean + M2 S2 K1 O1 M4 of the last 15 days
  oracle_mean,     ///< the mean of the forecast day itself: a yardstick, not a forecast
  reference_slab,  ///< inertial slab driven by the wind, see reference_slab.h
};

inline constexpr std::array all_baselines{
    Baseline::persistence,   Baseline::day_mean,    Baseline::same_hour,     Baseline::tide_phase,
    Baseline::tide_harmonic, Baseline::oracle_mean, Baseline::reference_slab};

/// The name in `verify --json`, e.g. "reference-slab".
[[nodiscard]] std::string_view name_of(Baseline baseline) noexcept;
[[nodiscard]] std::optional<Baseline> baseline_from(std::string_view name) noexcept;

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
/// @param truth_time  cells to forecast, all after the end of D, in any order
/// @param truth       needed by `oracle_mean` alone: a column on the same levels that holds the
/// truth; else ignored Throws ContractViolation where the history reaches beyond D.  Cost: below 1
/// ms a column without tide.
[[nodiscard]] BaselineOutcome make_baseline(Baseline baseline, const BaselineInput& input,
                                            std::span<const TimeCell> truth_time,
                                            const VectorColumn* truth = nullptr);

}  // namespace slackwater::calibration
