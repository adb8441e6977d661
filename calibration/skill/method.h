#pragma once
#include <array>
#include <string_view>

namespace slackwater::calibration {

/// Every forecast that is scored, blended or printed. All but `oracle_mean` know nothing of the
/// days after D. They stand in the order of their names: tables and JSON are printed in it.
enum class Method {
  day_mean,        ///< mean of D
  forecast,        ///< our own: as issued where it is scored, as calibrated where it is blended
  merged,          ///< our own and the provider's, by their errors: part of a blend, not scored
  oracle_mean,     ///< the mean of the forecast day itself: a yardstick, not a forecast
  persistence,     ///< the last value of D, held
  provider,        ///< the product's own forecast, as published by the issue time
  reference_slab,  ///< inertial slab driven by the wind, see reference_slab.h
  same_hour,       ///< the value 24 h before; beyond 24 h of lead the last day repeats
  tide_harmonic,   ///< mean + M2 S2 K1 O1 M4 of the last 15 days
  tide_phase,      ///< the value two M2 periods (24.84 h) before, repeated likewise
};

inline constexpr std::array all_methods{
    Method::day_mean,      Method::forecast,  Method::merged,         Method::oracle_mean,
    Method::persistence,   Method::provider,  Method::reference_slab, Method::same_hour,
    Method::tide_harmonic, Method::tide_phase};

/// The name in tables, pages and JSON, e.g. "reference-slab".
[[nodiscard]] std::string_view name_of(Method method) noexcept;

}  // namespace slackwater::calibration
