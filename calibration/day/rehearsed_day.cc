#include "calibration/day/rehearsed_day.h"

#include <algorithm>
#include <cmath>

#include "calibration/blend/blend.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {

std::vector<Method> candidate_methods() {
  std::vector<Method> methods;
  for (const Candidate& c : standard_candidates()) methods.push_back(c.method);
  return methods;
}

void add_errors(const std::vector<MethodForecast>& methods, const Chosen<Horizontal>& against,
                UtcTime end_of_day, RehearsedDay& rehearsed) {
  const VectorColumn& truth = against.column;
  using constants::nan;
  const std::vector<Method> candidates = candidate_methods();
  for (std::size_t t = 0; t < truth.times(); ++t) {
    const double lead_h = hours_between(end_of_day, truth.time[t].centre());
    const auto day = static_cast<std::size_t>(std::max(0.0, std::ceil(lead_h / 24.0) - 1));
    if (day >= rehearsed.lead.size()) continue;
    RehearsedLead& lead = rehearsed.lead[day];
    if (lead.errors.empty()) lead.errors.resize(candidates.size());
    for (std::size_t k = 0; k < truth.levels(); ++k) {
      const std::size_t o = truth.offset(t, k);
      for (std::vector<Horizontal>& errors : lead.errors) errors.emplace_back(nan, nan);
      lead.sigma_m_s.push_back(nan);
      lead.merged_sigma_m_s.push_back(nan);
      lead.noise_m_s.push_back(against.noise_m_s[o]);
      if (!has_value(truth.status[o])) continue;
      for (const MethodForecast& method : methods) {
        const auto found = std::find(candidates.begin(), candidates.end(), method.method);
        if (found == candidates.end() || !method.made.has(o)) continue;  // the oracle is none
        const auto c = static_cast<std::size_t>(found - candidates.begin());
        lead.errors[c].back() = method.made.value[o] - truth.value[o];
        if (method.method == Method::forecast) lead.sigma_m_s.back() = method.sigma_m_s[o];
        if (method.method == Method::merged) lead.merged_sigma_m_s.back() = method.sigma_m_s[o];
      }
    }
  }
}

void clear_absent(RehearsedLead& lead) {
  for (std::vector<Horizontal>& errors : lead.errors) {
    const bool any = std::any_of(errors.begin(), errors.end(), [](Horizontal e) {
      return std::isfinite(e.real()) && std::isfinite(e.imag());
    });
    if (!any) errors.clear();
  }
}

}  // namespace slackwater::calibration
