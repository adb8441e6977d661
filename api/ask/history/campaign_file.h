#pragma once
#include <filesystem>

#include "api/ask/history/campaign.h"

namespace slackwater::api {

/// Reads a campaign's YAML. @throws Error(invalid_input) with file, line and key
[[nodiscard]] CampaignFile load_campaign(const std::filesystem::path& file);

}  // namespace slackwater::api
