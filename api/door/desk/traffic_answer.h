#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/traffic/traffic_rule.h"
#include "api/door/desk/followed_logs.h"
#include "api/issued/site_state.h"

namespace slackwater::api::desk {

/// What is listened to, and how it is judged.
struct Listening {
  std::shared_ptr<const FollowedLogs> logs;  ///< null: nobody gave one
  TrafficRule rule;
};

/// `slackwater ais FILE --site SITE --at TIME --json`, of the logs that the server follows. Words:
/// at (UTC; the server's now). @throws Error(usage), Error(not_found)
[[nodiscard]] nlohmann::json traffic_answer(const Listening& listening,
                                            const IssuedFields& forecasts,
                                            const Freshness& freshness,
                                            const std::filesystem::path& store_folder,
                                            const std::string& site, const std::string& query);

}  // namespace slackwater::api::desk
