#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/desk/kept_sites.h"
#include "api/issued/site_state.h"
#include "fields/site/site.h"

namespace slackwater::api::desk {

/// Every site that has a forecast, or that the store describes: how its forecast is, and since
/// when. `GET /sites`.
[[nodiscard]] nlohmann::json sites_json(const IssuedFields& forecasts, const Freshness& freshness,
                                        KeptSites& kept);

/// What lies at a site, for a map; and the reach of its forecast. `GET /sites/{site}`.
/// @throws Error(not_found) for a site that neither has a forecast nor is described
[[nodiscard]] nlohmann::json site_json(const std::string& id, const IssuedFields& forecasts,
                                       const Freshness& freshness, KeptSites& kept);

/// The description of a site by its id; of no other file, whatever the id says.
/// @throws Error(not_found)
[[nodiscard]] Site described_site(const std::string& id, const std::filesystem::path& store_folder);

}  // namespace slackwater::api::desk
