#pragma once
#include <nlohmann/json_fwd.hpp>

#include "data/store/session_action.h"

namespace slackwater::api {

/// A row of the record of a session, as api/docs/session.md has it.
[[nodiscard]] nlohmann::json action_json(const store::SessionAction& action);

}  // namespace slackwater::api
