#pragma once
#include <optional>
#include <vector>

#include "calibration/day/column/methods.h"
#include "calibration/day/part_failure.h"

namespace slackwater::calibration {

/// The methods of the standard candidates, in order.
[[nodiscard]] std::vector<Method> candidate_methods();

/// What a past day D' said of one day of lead, every method beside it.
struct RehearsedLead {
  std::vector<std::vector<Horizontal>> errors;  ///< per standard candidate; empty: absent
  std::vector<double> sigma_m_s;                ///< of our forecast, per value; unscaled
  std::vector<double> merged_sigma_m_s;         ///< of `merged`; NaN where there is none
  std::vector<double> noise_m_s;                ///< stated, of the truth
};

/// One past day D' forecast as if live and held against the days after it.
struct RehearsedDay {
  std::vector<RehearsedLead> lead;  ///< of D'+1, D'+2, ...; those without truth hold nothing
  bool simulated_wind = false;      ///< no run of the wind was kept: HorizonWind::simulated
  std::optional<Failure> failure;   ///< a bug that cost a forecast, or all of the day
};

/// Puts what the methods missed of the truth into the day, each value with the day of lead that it
/// is of; values beyond the days of lead that `day` has room for are left out.
/// @param truth  with its stated noise (`Chosen::noise_m_s`)
void add_errors(const std::vector<MethodForecast>& methods, const Chosen<Horizontal>& truth,
                UtcTime end_of_day, RehearsedDay& day);

/// A candidate without any value is absent.
void clear_absent(RehearsedLead& lead);

}  // namespace slackwater::calibration
