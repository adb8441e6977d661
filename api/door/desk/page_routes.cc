#include "api/door/desk/page_routes.h"

#include "api/door/http/page_part.h"
#include "api/web/assets.h"

namespace slackwater::api::desk {

using http::page_part;
using http::Request;
using http::Response;

Response front_page(const Request&) {
  Response page = page_part("text/html; charset=utf-8", web::desk_page().html);
  page.headers.emplace_back("Vary", "Accept");
  return page;
}

void add_page_routes(http::Router& router) {
  router.add("GET", "/desk/page.js", [](const Request&) {
    return page_part("text/javascript; charset=utf-8", web::desk_page().script);
  });
  router.add("GET", "/desk/page.css", [](const Request&) {
    return page_part("text/css; charset=utf-8", web::desk_page().style);
  });
  router.add("GET", "/desk/land-50m.json",
             [](const Request&) { return page_part("application/json", web::desk_page().data); });
}

}  // namespace slackwater::api::desk
