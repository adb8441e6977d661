#pragma once
#include <map>
#include <string>
#include <vector>

#include "api/pipeline/forecast_column.h"
#include "api/pipeline/known_currents.h"
#include "api/pipeline/verify.h"

namespace slackwater::api {

/// Paired values of one method: forecast and truth at the same place, level and time.
struct Pairs {
  std::vector<Horizontal> forecast;
  std::vector<Horizontal> truth;
  std::vector<double> sigma_m_s;  ///< empty for baselines
  std::vector<double> depth_m;
  std::vector<double> lead_h;      ///< of the cell's centre
  std::vector<std::size_t> block;  ///< six-hour block of the truth's time, for the bootstrap
};

/// Pairs by method: "forecast" and every baseline that the column's record allows.
[[nodiscard]] std::map<std::string, Pairs> current_pairs(const ColumnData& column,
                                                         const ForecastPlan& plan,
                                                         const Snapshot& snapshot,
                                                         std::size_t column_index,
                                                         const Chosen<Horizontal>& truth);

}  // namespace slackwater::api
