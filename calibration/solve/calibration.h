#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/residuals/parameter_layout.h"
#include "fields/current/steady_column.h"
#include "fields/current/wind_stress.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// What is known of a parameter before its day is seen: yesterday's posterior, aged (ageing.h), or
/// a product's own figure (layer_figure.h).
struct KnownParameter {
  std::string name;
  double value = 0;
  double sigma = 0;  ///< of the value, or of its logarithm for positive parameters; > 0
  std::string source = "the day before, aged";
};

/// One day at one place, ready to be fitted.
struct CalibrationInput {
  Angle latitude;
  double water_depth_m = 0;  ///< > 0
  VectorColumn
      current;  ///< day D, Eulerian, towards; levels are depths; instants or means, gaps allowed
  std::optional<VectorColumn>
      wind;  ///< 10 m, towards, one level, times around D; empty: term dropped, and said
  std::optional<SteadyForm> form;  ///< unset: `default_form`
  /// The column with memory: history of the wind, a trend of the interior and free inertial motion.
  /// Steady otherwise. three_layer has the trend alone.
  bool is_unsteady = false;
  std::vector<KnownParameter> known;  ///< replaces the general prior of these parameters
  DragLaw drag_law = DragLaw::paper_linear;
  /// Standard deviation of each component of the product's current about the steady model, at best:
  /// the noise of a regional analysis within a day. The day's own misfit replaces it where that is
  /// larger.
  double observation_sigma_m_s = 0.02;
  /// Beside it, stated per value of `current` (of a component, independent): values count by it.
  /// Empty: none is stated.
  std::vector<double> noise_m_s{};
};

/// One estimated quantity.
struct Parameter {
  std::string name;  ///< e.g. "eddy_viscosity"
  std::string unit;  ///< of value, prior and bounds
  double value = 0;
  double prior = 0;
  double prior_sigma = 0;  ///< of the value, or of its natural logarithm where `is_logarithmic`
  double lower = 0;
  double upper = 0;
  double sigma = 0;             ///< posterior, in the same terms as prior_sigma
  bool is_logarithmic = false;  ///< a positive quantity, estimated through its logarithm
  bool at_bound = false;
  bool weakly_determined = false;  ///< the day narrowed the prior by less than a fifth
  std::string source;              ///< where the prior comes from
};

/// How well one depth is explained. Vector errors of the residual, observation minus model.
struct MisfitAtDepth {
  double depth_m = 0;
  std::size_t n = 0;         ///< observations used, > 0
  double rms_m_s = 0;        ///< sqrt(mean |residual|^2)
  double bias_east_m_s = 0;  ///< mean residual
  double bias_north_m_s = 0;
};

/// A tidal line that the record cannot tell from inertial motion (fields/current/tide.h): no tide
/// was taken off for it, the memory carries it on.
struct NearInertialLine {
  double speed_rad_s = 0;           ///< counter-clockwise positive
  std::vector<double> modulus_m_s;  ///< in the whole record, per level
};

/// A fitted day.
struct Calibration {
  SteadyForm form = SteadyForm::finite_depth;
  ParameterLayout layout;  ///< which parameters there are, in which order
  UtcTime start{};         ///< 00:00 of D: phase of inertial motion, middle of the trend less 12 h
  DragLaw drag_law = DragLaw::paper_linear;
  Angle latitude;
  double water_depth_m = 0;  ///< as used: at least the deepest observed level
  bool wind_used = false;
  /// In the order of the layout.
  std::vector<Parameter> parameters;
  /// n x n, row-major, in the order of `parameters` and in the terms of their sigma (logarithms
  /// where so). Posterior: prior information plus that of the day, the day counted as
  /// `effective_observations`.
  std::vector<double> covariance;
  std::vector<MisfitAtDepth> misfit;  ///< levels with at least one observation used, by depth
  double rms_m_s = 0;                 ///< sqrt(mean |residual|^2) over all observations used
  std::size_t observations = 0;       ///< (time, level) pairs used
  double effective_observations = 0;  ///< independent pairs they are worth, see residual_memory.h
  double whitening_sigma_m_s = 0;     ///< what residuals were divided by in the end
  double misfit_sigma_m_s = 0;        ///< of a component of the residual, robust
  /// ln of Occam's factor: how much of what the priors allow the day still allows, less the price
  /// of leaving their centres (Laplace's approximation; MacKay 1992, Neural Computation 4, 415).
  double log_occam = 0;
  int iterations = 0;
  std::string termination;  ///< one sentence an operator can read
  std::vector<std::string> warnings;
  VectorColumn residual;  ///< observation minus model; status missing where the fit had no pair
  /// Observation minus the part that the wind makes: what the column remembers.
  VectorColumn remembered;
  std::vector<Horizontal> wind_driven_m_s;  ///< the wind's part at the times and levels of D
  std::vector<double> noise_m_s;            ///< CalibrationInput::noise_m_s
  /// In what is remembered; nothing where the tide was told from inertial motion.
  std::optional<NearInertialLine> near_inertial;
};

/// Fits the column to one day: one Ceres problem, robust loss per (time, level), priors beside the
/// data (column_rows.h holds the model).
///
/// The day is solved twice: roughly, to see how large its misfit is and how much of it repeats
/// itself from hour to hour and level to level (residual_memory.h); then fully, whitened by that
/// misfit where it exceeds the stated sigma, and with the data's weight reduced to the number of
/// independent observations, so that the priors and the covariance face what the day really knows.
/// A parameter that ends on a bound, and a direction that the day cannot determine, are flagged and
/// warned of. Wind samples may be 6 hours apart at most, see `StressSeries`; an unsteady fit
/// remembers `stress_history_h` of wind before the day.
///
/// @throws Error(invalid_input) for nothing to fit: no observation with a value (or none with wind
/// at its time), a
///         depth or sigma that is not positive. Error(not_converged) where no minimum was found.
/// Thread-safe. Milliseconds for 24 times x 35 levels
/// (tests/bench/calibrate_bench.cc).
[[nodiscard]] Calibration calibrate_day(const CalibrationInput& input);

/// How far back before a day the changes of the wind still count, h.
inline constexpr double stress_history_h = 72.0;

/// Probability of each form after the day, all the same before it; sums to 1.
///
///   ln p = -N ln sigma^2 + ln Occam,   N the independent observations of the day
///
/// N that of the form whose residual repeats itself least: what a poor form leaves is one slow
/// error and would count as few observations only because it explains so little.
/// sigma the robust misfit, 5 mm/s at least: no form is believed for fitting beyond that.
[[nodiscard]] std::vector<double> form_weights(const std::vector<Calibration>& forms);

/// The forward model's parameters at the optimum.
[[nodiscard]] SteadyParameters steady_parameters(const Calibration& calibration);
[[nodiscard]] SteadyParameters steady_parameters(const std::vector<Parameter>& parameters);

/// The parameter of that name, or null (a day without wind has no stress factor).
[[nodiscard]] const Parameter* find_parameter(const Calibration& calibration,
                                              std::string_view name);

}  // namespace slackwater::calibration
