#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "data/store/database.h"
#include "data/store/session_action.h"

namespace slackwater::store {

/// Rows of the tables session and session_action, which are only added to. No transactions here:
/// the caller holds one.

/// The new id.
std::int64_t insert_session(Database& database, const std::string& name, UtcTime begun);
void insert_actions(Database& database, std::int64_t session,
                    std::span<const SessionAction> actions);
/// In the order in which they began.
[[nodiscard]] std::vector<SessionRow> select_sessions(Database& database);
/// In order. Throws Error(not_found) where there is no such session.
[[nodiscard]] std::vector<SessionAction> select_actions(Database& database, std::int64_t session);

}  // namespace slackwater::store
