#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/history/campaign.h"

namespace slackwater::api {

/// For programs: api/docs/json.md has the schema.
[[nodiscard]] nlohmann::json campaign_json(const History& history, const CampaignFile& campaign,
                                           const CampaignAnswer& answer);
/// For people: a line for each date and fleet.
[[nodiscard]] std::string campaign_text(const History& history, const CampaignFile& campaign,
                                        const CampaignAnswer& answer);

/// "04-01".
[[nodiscard]] std::string date_text(const std::chrono::month_day& date);
/// The date so many hours after a date, in a year without 29 February; a year later with "+1y".
[[nodiscard]] std::string date_after(const std::chrono::month_day& date, double after_h);

}  // namespace slackwater::api
