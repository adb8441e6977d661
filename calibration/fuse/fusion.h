#pragma once
#include <vector>

#include "calibration/fuse/fusion_settings.h"
#include "calibration/fuse/instrument_errors.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// A product's column drawn towards an instrument near it.
struct FusedColumn {
  VectorColumn column;            ///< the product's times and levels
  std::vector<double> sigma_m_s;  ///< of a component, per value; 0 where there is none
  /// Of which the instrument's noise at that time makes: independent from time to time; 0 where it
  /// was not heard.
  std::vector<double> noise_m_s;
  std::size_t times_observed = 0;
  /// Share of the instrument's difference from the product that counts at the product's place.
  double weight = 0;
};

/// Fuses a product with an observed series by their stated errors.
///
/// At each time of the product the difference d between instrument and product (at the instrument's
/// depths, the product interpolated) is a sum of the product's error e at the site, a difference r
/// between the two places, and the instrument's noise. e and r have one shape in depth and time
/// (error_filter.h), so that the best estimate of e is a fixed share of the best estimate of e + r:
///
///   e^ = w s^,   w = (P exp(-D/L) + M) / (P + M + R(D)),   Var e^ = w^2 Var s^ + (P + M - w^2 S) C
///
/// with P the product's error variance, R(D) what a distance D costs, M the variance that the
/// product lacks altogether (a product without tide, or of daily means, beside an instrument that
/// sees it: observed less product variance and less the instrument's noise, where positive; it
/// counts as quick and is shared by both places). (with M the shapes differ a little, and w is that
/// of the sums). What of the instrument's error stays for days joins R(D), its noise is that of
/// each value. The difference is carried over gaps and beyond the last observation as long as its
/// slow part is remembered; then the product is left as it is. Nothing later than a time is used
/// for it but the next sample (and M, which is of the whole record given).
///
/// @param product   levels are depths (at least one); missing values stay missing
/// @param observed  levels are depths; instants or means; any times
/// @param distance_m  between the two places, >= 0; beyond `farthest_m` the product is returned
///                    as is
/// @param errors    of this instrument; per level of `observed`, or empty
[[nodiscard]] FusedColumn fuse(const VectorColumn& product, const VectorColumn& observed,
                               double distance_m, const FusionSettings& settings = {},
                               const MooredInstrumentErrors& errors = {});

/// Standard deviation of a component of the difference that a product and an instrument at this
/// distance may show: sqrt(P + R(D) + what lasts of the instrument's error).
[[nodiscard]] double expected_difference(double distance_m, const MooredInstrumentErrors& errors,
                                         const FusionSettings& settings = {});

/// How much an instrument at this distance counts where the product lacks nothing: w above.
[[nodiscard]] double weight_at(double distance_m, const FusionSettings& settings = {});

}  // namespace slackwater::calibration
