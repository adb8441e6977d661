#pragma once
#include <filesystem>
#include <functional>
#include <memory>

#include "api/door/http/router.h"
#include "api/issued/site_state.h"

namespace slackwater::api::desk {

struct DeskSettings {
  std::shared_ptr<const IssuedFields> forecasts;
  Freshness freshness;
  std::filesystem::path store_folder, data_folder;
  std::size_t missions_at_once = 1;
};

/// What people decide from, as the commands answer it:
///
///     GET /sites, /sites/{site}, /sites/{site}/{windows,report,plan,verification,sources,
///                                               decisions,workability,climate,slack,
///                                               texts}
///     POST /sites/{site}/what-if
///     GET, POST /missions    GET /missions/{mission}    POST /missions/{mission}/cancel
///
/// `interface_document` has their OpenAPI.
void add_routes(http::Router& router, const DeskSettings& settings);

/// Whether a request goes to a path that takes POST. Their handlers ask whether it is
/// trusted: `http::ServerOptions::guards_itself`.
[[nodiscard]] bool is_guarded_here(const http::Request& request);

}  // namespace slackwater::api::desk
