#pragma once
#include <filesystem>
#include <functional>
#include <memory>

#include "api/door/desk/traffic_answer.h"
#include "api/door/http/router.h"
#include "api/issued/site_state.h"

namespace slackwater::api::desk {

struct DeskSettings {
  std::shared_ptr<const IssuedFields> forecasts;
  Freshness freshness;
  std::filesystem::path store_folder, data_folder;
  std::size_t missions_at_once = 1;
  bool by_clock = true;  ///< `freshness.now` is the machine's clock, and not one that somebody set
  Listening listening{};
};

/// What people decide from, as the commands answer it:
///
///     GET /sites, /sites/{site}, /sites/{site}/{windows,report,plan,verification,sources,
///                                               decisions,workability,climate,bed,
///                                               slack,traffic,texts}
///     POST /sites/{site}/what-if
///     POST /sites/{site}/decisions: the only one that writes to the store
///     GET, POST /missions    GET /missions/{mission}    POST /missions/{mission}/cancel
///
/// POST is work that costs cores: it is for this machine, and for who carries the server's token.
/// `interface_document` has their OpenAPI.
void add_routes(http::Router& router, const DeskSettings& settings);

}  // namespace slackwater::api::desk
