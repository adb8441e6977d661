#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/store/content_files.h"
#include "data/store/database.h"
#include "data/store/rows.h"

namespace slackwater::store {

/// Rows of the tables forecast and forecast_input. No transactions here: the caller holds one.

/// The new id. Throws Error(not_found) where an input granule is not in the store (it was pruned
/// meanwhile).
std::int64_t insert_forecast(Database& database, const ForecastRow& row, const SealedFile& content);
/// The stored forecast that is this one: issued at once for one site by one version of the program,
/// from the same granules, with the same summary (options and site among it) and the same content.
/// The first where there are several.
[[nodiscard]] std::optional<std::int64_t> same_forecast(Database& database, const ForecastRow& row,
                                                        const std::string& content_sha256);
[[nodiscard]] std::vector<ForecastRow> select_forecasts(Database& database,
                                                        const ForecastQuery& query);

}  // namespace slackwater::store
