#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/vehicle/fit_trial.h"

namespace slackwater::api {

/// For people: a table of the errors in a trial, angles in degrees, and where both were last.
[[nodiscard]] std::string trial_text(const twin::Trial& trial, const twin::TrialRun& run,
                                     const twin::TrialErrors& errors);
/// For programs: the same in SI.
///   {name, rows, compared_rows, lasts_s, diverged_after_s|null, current_m_s: [north, east, down],
///    errors: [{quantity, unit, values, rms, bias, largest, range, rms_of_range|null}],
///    end: {after_s, off_m, way_m, off_of_way|null} | null}
[[nodiscard]] nlohmann::json trial_json(const twin::Trial& trial, const twin::TrialRun& run,
                                        const twin::TrialErrors& errors);

/// For people: what was fitted, how well it is known, what it made of the errors, and the lines for
/// the vehicle's file.
[[nodiscard]] std::string fit_text(const TrialFit& fit);
/// For programs: {ended, has_converged, residuals, effective_residuals, every_row, rms_before,
/// rms_after, keys: [{key, before, value, standard_deviation|null, is_determined, low, high,
/// ended_on: null|"low"|"high"}], correlation: [[...]], errors: [{quantity, unit, rms_before,
/// rms_after}], left_out: [quantity], yaml}
[[nodiscard]] nlohmann::json fit_json(const TrialFit& fit);

/// What may be put into the vehicle's file: what the trial determines, to six digits. Those in a
/// list, and those that ended on a bound, as comments. Empty: it determines nothing.
[[nodiscard]] std::string fitted_yaml(const TrialFit& fit);

}  // namespace slackwater::api
