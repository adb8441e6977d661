#pragma once
#include <string>
#include <vector>

#include "api/ask/plan/linear_model.h"

namespace slackwater::api {

/// What came of a search.
struct LinearAnswer {
  std::vector<double> values;  ///< of the columns; empty where nothing was found in time
  double bound = 0;            ///< no values are worth more
  bool is_proven = false;      ///< and none are worth more than these
};

/// Solves a model by branch and cut (COIN-OR CBC). Silent; one thread and a fixed seed, so that a
/// search that ends before its time limit ends the same each time.
/// @param time_limit_s  of the wall clock, more than 0
/// @throws Error(internal) for a model that has no values at all, or no end: a bug of ours
[[nodiscard]] LinearAnswer maximise(const LinearModel& model, double time_limit_s);

/// "CBC 2.10.8".
[[nodiscard]] std::string solver_name();

}  // namespace slackwater::api
