#include "api/door/desk/page_routes.h"

#include "api/door/desk/page/assets.h"

namespace slackwater::api::desk {
namespace {

using http::Request;
using http::Response;

/// Of this build of the program: another one may be started in its place.
constexpr int page_max_age_s = 60;

/// Scripts, styles and connections of this server alone, and in nobody's frame.
Response page_part(const char* media_type, std::string_view body) {
  Response response;
  response.media_type = media_type;
  response.body = std::string(body);
  response.max_age_s = page_max_age_s;
  response.headers = {
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
       "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
      {"Referrer-Policy", "no-referrer"}};
  return response;
}

}  // namespace

Response front_page(const Request&) {
  Response page = page_part("text/html; charset=utf-8", slackwater::desk::desk_page_html());
  page.headers.emplace_back("Vary", "Accept");
  return page;
}

void add_page_routes(http::Router& router) {
  router.add("GET", "/desk/page.js", [](const Request&) {
    return page_part("text/javascript; charset=utf-8", slackwater::desk::desk_page_script());
  });
  router.add("GET", "/desk/page.css", [](const Request&) {
    return page_part("text/css; charset=utf-8", slackwater::desk::desk_page_style());
  });
  router.add("GET", "/desk/land-50m.json", [](const Request&) {
    return page_part("application/json", slackwater::desk::desk_page_land());
  });
}

}  // namespace slackwater::api::desk
