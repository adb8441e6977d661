#pragma once
#include "calibration/day/given/forecast_plan.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {

/// Over this a run of wind or waves takes over from another: two six-hourly steps would hide it, an
/// hourly jump would be water that moves by itself.
inline constexpr Duration join_ramp = std::chrono::hours(6);

/// What may be looked at of wind and waves under a policy.
[[nodiscard]] Knowledge knowledge_of(WindPolicy policy, UtcTime end_of_day, const BestInputs& best);

/// Products where any are known, else moored instruments, joined over `join_ramp`; with `persist`
/// nothing that is valid after D. @param like  Choice::like
[[nodiscard]] Chosen<Horizontal> choose_input(const VectorRecord& record, WindPolicy policy,
                                              UtcTime end_of_day, const BestInputs& best,
                                              const std::vector<Stretch>* like = nullptr);
[[nodiscard]] Chosen<double> choose_input(const ScalarRecord& record, WindPolicy policy,
                                          UtcTime end_of_day, const BestInputs& best,
                                          const std::vector<Stretch>* like = nullptr);

/// The same with all that was analysed later, but no run that was published later.
[[nodiscard]] Chosen<Horizontal> choose_analysed(const VectorRecord& record, UtcTime end_of_day,
                                                 const BestInputs& best);

/// Whether any value was not known at `best.known_by`.
[[nodiscard]] bool looks_ahead(const Chosen<Horizontal>& chosen, const BestInputs& best);
[[nodiscard]] bool looks_ahead(const Chosen<double>& chosen, const BestInputs& best);

}  // namespace slackwater::calibration
