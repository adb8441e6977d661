#pragma once
#include "api/door/http/router.h"

namespace slackwater::api::desk {

/// The desk: for browsers that ask for `/`.
[[nodiscard]] http::Response front_page(const http::Request& request);

/// What it asks for: `/desk/page.js`, `/desk/page.css`, `/desk/land-50m.json`.
void add_page_routes(http::Router& router);

}  // namespace slackwater::api::desk
