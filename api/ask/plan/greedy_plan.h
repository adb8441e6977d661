#pragma once
#include "api/ask/plan/plan_model.h"

namespace slackwater::api {

/// What adds a job to a draft, in any way that breaks no rule: the one of most probability, then
/// the earliest. @return whether there was one
bool add_where_it_fits(const PlanProblem& problem, std::size_t job, PlanDraft& draft);

/// A plan at once: the job that is worth most goes first, each where it fits. A floor for what a
/// search finds, and what there is where it has found nothing in its time.
[[nodiscard]] PlanDraft greedy_draft(const PlanProblem& problem);

/// Moves each job of a draft to the earliest start that is as probable, with the same people and
/// things, and adds jobs that still fit. The draft is worth no less for it.
void tidy(const PlanProblem& problem, PlanDraft& draft);

}  // namespace slackwater::api
