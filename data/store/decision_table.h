#pragma once
#include <cstdint>
#include <vector>

#include "data/store/database.h"
#include "data/store/decision.h"

namespace slackwater::store {

/// Rows of the table decision, which is only added to. No transactions here: the caller holds one.

/// The new id. Throws Error(not_found) where its forecast is not in the store.
std::int64_t insert_decision(Database& database, const DecisionRow& row);
/// In order of (start, id).
[[nodiscard]] std::vector<DecisionRow> select_decisions(Database& database,
                                                        const DecisionQuery& query);

}  // namespace slackwater::store
