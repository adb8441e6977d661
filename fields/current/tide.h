#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/angle.h"
#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/grid/status.h"

namespace slackwater {

/// One constituent of a current: W(t) = counter_clockwise e^{+i w t} + clockwise e^{-i w t}, W =
/// east + i north, m/s, t counted from `TideFit::reference`.
struct TideTerm {
  std::string name;
  double speed_rad_s = 0;
  Horizontal counter_clockwise{};
  Horizontal clockwise{};
  /// Power over the variance of its estimate; that of the carrier for an inferred term.
  double signal_to_noise = 0;
  /// The constituent it was inferred from, empty where it was fitted itself.
  std::string inferred_from;
  /// Closer to |f| than one Rayleigh width: tide and inertial motion cannot be told apart in this
  /// record, and the sense of rotation that they share is 0 here.
  bool near_inertial = false;
  double left_out_m_s = 0;  ///< the modulus that it had in the fit
};

/// A harmonic tide with its mean.
struct TideFit {
  UtcTime reference{};
  Horizontal mean{};  ///< of the record, m/s: not tide, kept because it was fitted together with it
  std::vector<TideTerm> terms;
  double residual_rms_m_s = 0;     ///< of the vector, over the values used
  std::vector<std::string> notes;  ///< what was inferred, flagged or dropped, and why
};

/// Harmonic analysis of a current series by least squares, both senses of rotation.
///
///   W(t) = W_0 + sum_k [ W+_k e^{+i w_k t} + W-_k e^{-i w_k t} ]
///
/// The record length T decides what is fitted (Rayleigh criterion); what cannot be split is carried
/// by its neighbour with the equilibrium amplitude ratio and the same phase lag:
///
///   T < 3 d      no tide: the mean alone
///   < 13.661 d   K1 (carrying O1, P1), M2 (S2, N2), M4
///   < 14.765 d   K1 (P1), O1 (Q1), M2 (S2, N2), M4
///   < 27.555 d   K1 (P1), O1 (Q1), M2 (N2), S2 (K2), M4, MS4
///   < 182.62 d   K1 (P1), O1, Q1, M2, N2, S2 (K2), M4, MS4, MN4, M6
///   longer       every constituent of the table
///
/// A constituent that the sampling cannot see (period below two steps, or averaged away in means)
/// is left out; one that makes the condition number exceed 1e3 or whose signal-to-noise ratio is
/// below 2 is dropped; each of these is named in `notes`. The noise of an estimate is that of the
/// residual, widened for its lag-one correlation. Values that are means over a cell are fitted as
/// means.
///
/// Where | |w| - |f| | T < 2 pi the record cannot tell a constituent from free inertial motion,
/// which keeps its phase for days and not for ever. The sense of rotation that the two share
/// (clockwise in the north, counter-clockwise in the south) is fitted, so that it does not leak
/// into its neighbours, and then left out of the tide, with its size stated; the other one stays.
///
/// @param time      ascending cells, instants or means
/// @param value     m/s; used where the status has a value
/// @param latitude  for the inertial frequency and its sense only
/// Throws ContractViolation where the lengths differ.  Cost: 5 ms for 30 days of hours.
/// Thread-safe. Source: Foreman (1977, 1978); Pawlowicz, Beardsley & Lentz (2002); nodal
/// corrections are left out.
[[nodiscard]] TideFit fit_tide(std::span<const TimeCell> time, std::span<const Horizontal> value,
                               std::span<const SampleStatus> status, Angle latitude);

/// The same with these constituents, nothing inferred and nothing dropped: the least-squares
/// solution of smallest norm. Error(not_found) for an unknown name.
[[nodiscard]] TideFit fit_prescribed_tide(std::span<const TimeCell> time,
                                          std::span<const Horizontal> value,
                                          std::span<const SampleStatus> status,
                                          std::span<const std::string_view> names);

/// Length of the record that has values, from the first to the last cell; an instant counts for one
/// usual step.
[[nodiscard]] Duration record_length(std::span<const TimeCell> time,
                                     std::span<const SampleStatus> status);

/// The tide without the mean, at an instant or as the exact average over a mean's interval, m/s.
[[nodiscard]] Horizontal tidal_oscillation(const TideFit& fit, const TimeCell& cell) noexcept;
/// Mean and tide, at an instant or as the exact average over a mean's interval, m/s.
[[nodiscard]] Horizontal tide_over(const TideFit& fit, const TimeCell& cell) noexcept;

}  // namespace slackwater
