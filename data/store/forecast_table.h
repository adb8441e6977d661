#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "data/store/content_files.h"
#include "data/store/database.h"
#include "data/store/rows.h"

namespace slackwater::store {

/// Rows of the tables forecast, forecast_input and score. No transactions here: the caller holds
/// one.

/// The new id. Throws Error(not_found) where an input granule is not in the store (it was pruned
/// meanwhile).
std::int64_t insert_forecast(Database& database, const ForecastRow& row, const SealedFile& content);
[[nodiscard]] std::vector<ForecastRow> select_forecasts(Database& database,
                                                        const ForecastQuery& query);
void replace_score(Database& database, const ScoreRow& score);
[[nodiscard]] std::vector<ScoreRow> select_scores(Database& database, std::int64_t forecast_id);

}  // namespace slackwater::store
