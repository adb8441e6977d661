#pragma once
#include <span>

#include "calibration/skill/baseline.h"

namespace slackwater::calibration {

/// The baseline `reference-slab`: per level k, W = east + i north, t in hours, lead from the end
/// t_D of D.
///
///   W_k(t) = a_k + b_k s(t) + c_k exp(-(r + i f)(t - t_D))
///
/// by ridge least squares on D with penalties n (0, 1.5e-4, 1e-3) on |a|^2, |b|^2, |c|^2, n
/// samples, SI units; r of {1/24, 1/48, 1/96} per hour with the smallest squared misfit, summed
/// over levels. s is `slab_response` to the wind, linear in time between its stamps, at the whole
/// hours before and after t_D, from rest 72 h before D or at the first whole hour with a wind;
/// before that it is 0. After D the same sum with the wind as stored, or held, plus the mean
/// residual of the last 3 h of D (samples centred later than t_D - 3 h) decaying as exp(-lead/24
/// h). Where the record of a level is at least 15 days long its tide (mean + M2 S2 K1 O1 M4) is
/// taken out first, all but the mean, and added again at the end. Samples that are means are
/// explained by the mean of the model over their interval. Without wind, or with a wind that begins
/// after D, the term b is dropped.
///
/// A level needs 3 values on D; with fewer it is missing.
/// Source: the page "Baselines of the D -> D+1 current forecast", whose table it reproduces.
[[nodiscard]] BaselineOutcome reference_slab_forecast(const BaselineInput& input,
                                                      std::span<const TimeCell> truth_time);

}  // namespace slackwater::calibration
