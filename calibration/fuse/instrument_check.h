#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/fuse/fusion_settings.h"
#include "calibration/fuse/instrument_errors.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// What an instrument is taken for.
enum class MooredInstrumentUse {
  used,
  ended,     ///< its last value is so old that little of it is remembered
  apart,     ///< it has no value at a time and depth of the product
  rejected,  ///< it contradicts the product in a way that water and products do not
};

/// An instrument after a look at its own past and at the product beside it.
struct MooredInstrumentVerdict {
  MooredInstrumentUse use = MooredInstrumentUse::used;
  std::string why;  ///< of one that is not used: a clause about "it"
  /// Of one that is used: what was left out and what counts for less, a clause each.
  std::vector<std::string> remarks;
  bool is_stuck_at_the_end = false;  ///< it was still sending, always the same
  VectorColumn column;               ///< without broken samples
  MooredInstrumentErrors errors;
};

/// Judges an instrument before it is fused with a product. In this order:
///
/// - broken samples are left out (broken_samples.h);
/// - an instrument that ended more than `slow_memory_h` ln 3 before `until` is not used: less than
///   a third of what it said of the slow error is remembered, and nothing of the quick;
/// - its noise is measured (instrument_noise.h), and what its maker states beyond that lasts;
/// - bias: the mean difference from the product over the whole record, or over the last lunar day,
///   is rejected beyond 5 sigma + |mean product| / 2, where sigma^2 = P + R(D) + the stated lasting
///   error is what the settings expect of a component. Five: products err by several sigma for
///   days where an eddy or a jet lies elsewhere, the more the stronger the mean flow that they
///   place; 0.5 m/s in slack water is no eddy of a shelf. Tide does not count: a lunar day and more
///   is averaged, and three quarters of its times must be there;
/// - sign, frame and clock by the tide (tide_agreement.h).
///
/// A product without tide, or one that errs by what products err, rejects nobody.
///
/// @param product, observed  over depths, nothing of either after `until`
/// @param stated_error_m_s   of a value of one component, where the file states it
[[nodiscard]] MooredInstrumentVerdict check_instrument(const VectorColumn& product,
                                                       const VectorColumn& observed,
                                                       double distance_m, UtcTime until,
                                                       std::optional<double> stated_error_m_s = {},
                                                       const FusionSettings& settings = {});

}  // namespace slackwater::calibration
