#pragma once
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/door/http/router.h"
#include "api/issued/site_state.h"

namespace slackwater::api::edr {

/// The routes of OGC API-EDR 1.1 over the forecasts of a store. Handlers parse, sample and write;
/// they hold no physics and take no lock but to read an older forecast for the first time.
/// @param base_url  as clients see the service, without a slash at its end;
/// empty: from the Host header, where that is localhost or an address in numbers; else links begin
/// with a slash
/// @param freshness  when the list of sites calls a forecast old
void add_routes(http::Router& router, std::shared_ptr<IssuedFields> forecasts,
                const std::string& base_url = {}, const Freshness& freshness = {});
/// What a server has beside these routes.
struct Beside {
  nlohmann::json interface;  ///< merged into the document of `/api` (RFC 7396)
  http::Handler front_page;  ///< for browsers that ask for `/`; empty: the list of links
};
void add_routes(http::Router& router, std::shared_ptr<IssuedFields> forecasts,
                const std::string& base_url, const Freshness& freshness, const Beside& beside);

/// Header fields that answers carry beside those of HTTP, for
/// `http::ServerOptions::exposed_fields`.
[[nodiscard]] std::vector<std::string> own_header_fields();

}  // namespace slackwater::api::edr
