#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/mission/height_table.h"
#include "twin/mission/phase.h"
#include "twin/mission/wave_sector.h"

namespace slackwater::twin {

/// What an operation is limited by.
enum class LimitVariable {
  significant_wave_height,
  wave_peak_period,
  wind_speed_10m,
  wind_speed,  ///< mean, at the height of the work
  gust_speed,  ///< there
  current_speed,
  deck_motion,   ///< up and down, of the place a vehicle is launched from and comes back to
  fender_force,  ///< that a bow on a landing has to bear
  visibility,    ///< in air
  water_visibility,
  rain_rate,
  air_temperature,
  sea_surface_height,  ///< the tide's level, above mean sea level
};

/// How a variable is called in a limit's YAML, and what is known of it.
struct LimitWord {
  LimitVariable variable{};
  const char* key;      ///< with its unit; `least_` before it for a lower bound
  const char* unit;     ///< for people
  const char* meaning;  ///< for people: "significant wave height"
  Range range;
  bool is_served = true;  ///< by a forecast or by the run itself
  /// May be stated where nothing serves it; of what is served: where the forecast has none.
  bool may_be_assumed = !is_served;
};
[[nodiscard]] std::span<const LimitWord> limit_words() noexcept;
[[nodiscard]] const LimitWord& word_of(LimitVariable variable) noexcept;

/// A bound within which a task may go on. What equals it is within.
struct Limit {
  LimitVariable variable{};
  bool is_least = false;  ///< the value has to be at least the bound, not at most
  /// SI, but mm/h of rain and degrees Celsius. Of a table the least: who knows nothing of the sea
  /// lets no more pass than that.
  double bound = 0;
  /// Where it counts, NED; absent: where the vehicle is.
  std::optional<double> down_m;
  /// Of a height of waves: which of them it is of; absent: all. Others are no waves to it.
  std::optional<WaveSector> waves;
  std::optional<HeightTable> table;  ///< of a height of waves: bounds that go by the sea
  PhaseSet phases;
  bool may_be_missing = false;  ///< not checked where nobody knows the variable
  std::string source;
  std::string status;  ///< confirmed, estimate, unconfirmed
  bool operator==(const Limit&) const = default;

  /// False for what is no number.
  [[nodiscard]] bool holds(double value) const noexcept { return holds(value, bound); }
  /// @param in_force  the bound then: of a table that of the sea (`bound_of`)
  [[nodiscard]] bool holds(double value, double in_force) const noexcept {
    return is_least ? value >= in_force : value <= in_force;
  }
  /// How much of the limit a value takes up: above 1 it is exceeded.
  /// A level's zero is no end of it: there each metre beyond the bound makes it e times as much.
  [[nodiscard]] double share(double value) const noexcept { return share(value, bound); }
  [[nodiscard]] double share(double value, double in_force) const noexcept {
    if (variable == LimitVariable::sea_surface_height)
      return std::exp(is_least ? in_force - value : value - in_force);
    return is_least ? in_force / value : value / in_force;
  }
  /// Whether it goes by the vehicle's own heading.
  [[nodiscard]] bool goes_by_heading() const noexcept {
    return (waves && waves->goes_by_heading()) || (table && table->goes_by_heading());
  }
};
/// "significant wave height at most 1.5 m"; of a table "... at most 0.8 to 1.5 m by peak period".
[[nodiscard]] std::string text_of(const Limit& limit);

/// `limits` of YAML, a list of
///
///     {significant_wave_height_m: 1.5, phases: [work], source: DINW, status: confirmed}
///     {least_visibility_m: 500, if_missing: not_checked}
///     {wind_speed_m_s: 8, at_height_m: 90}       {current_speed_m_s: 0.5, at_depth_m: 20}
///     {significant_wave_height_m: 1.1, from_bow_deg: [45, 135], peak_period_between_s: [7, 30]}
///     {significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1.5, 1.1]}}
///
/// A mapping in the place of the height is a table (`read_height_table`), with `heading_deg` beside
/// it where the bow is not the vehicle's own.
///
/// @throws Error(invalid_input) for two variables in one, or none, and for bounds that cannot be
[[nodiscard]] std::vector<Limit> read_limits(const Config& config);

/// What the user knows and no forecast serves: `visibility_m: 5000`.
struct Assumption {
  LimitVariable variable{};
  double value = 0;
  bool operator==(const Assumption&) const = default;
};
/// `assume` of YAML, a mapping. @throws Error(invalid_input) for what the twin knows itself
[[nodiscard]] std::vector<Assumption> read_assumptions(const Config& config);
/// @param text  "visibility_m=5000"; others are Error(invalid_input)
[[nodiscard]] Assumption parse_assumption(const std::string& text);

}  // namespace slackwater::twin
