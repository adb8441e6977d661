#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "calibration/fit/fit_parameters.h"
#include "twin/handling/trial_error.h"

namespace slackwater::api {

inline constexpr std::size_t most_fitted_keys = 12;

/// How well a vehicle's file explains a trial, with numbers of it fitted and without. The file
/// itself stays as it is.
struct TrialFit {
  calibration::ParameterFit fit;  ///< named by their keys
  twin::TrialErrors before;       ///< with the numbers of the file
  twin::TrialErrors after;
  /// Measured columns that never change: their range, by which residuals are divided, is 0.
  std::vector<twin::TrialQuantity> left_out;
  std::size_t every_row = 1;  ///< that was fitted to: of long trials not every one
};

/// Fits numbers of a vehicle's file to a trial: the vehicle is flown again with each set of them,
/// and each measured column weighs as much as any other, for its residuals are divided by its range
/// over the trial. Angles are unwound from row to row, so that a turn too many counts as one.
///
/// Ours begins where the first row has it: what is wrong with that row is wrong with all that
/// follow, and no standard deviation knows of it. A trial begins best at rest, or with a row that
/// was smoothed. Of a vehicle that does not go straight by itself (open_loop.h) trials are short.
///
/// @param keys  dotted keys of numbers in the file, `damping.X_u`, `lift.N_ur`. Each begins with
/// the value of the file and stays between a tenth and ten times it, with its sign
/// @throws Error(invalid_input) for a key that the file has not, listing those near it; one that is
/// 0, given twice, or that no other number can stand for (a count of strips); a trial in which the
/// vehicle of the file diverges, naming when. Error(not_converged) of `fit_parameters`
[[nodiscard]] TrialFit fit_trial(const std::filesystem::path& vehicle_file,
                                 const std::filesystem::path& data_folder, const twin::Trial& trial,
                                 const std::vector<std::string>& keys,
                                 const calibration::FitOptions& options = {});

}  // namespace slackwater::api
