#include "api/door/http/page_part.h"

#include <string>

namespace slackwater::api::http {
namespace {

constexpr int page_max_age_s = 60;

}  // namespace

Response page_part(std::string_view media_type, std::string_view body, PageMay may) {
  const std::string wasm = may == PageMay::compile_wasm ? " 'wasm-unsafe-eval'" : "";
  Response response;
  response.media_type = std::string(media_type);
  response.body = std::string(body);
  response.max_age_s = page_max_age_s;
  response.headers = {
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'" + wasm +
           "; style-src 'self'; img-src 'self' data:; "
           "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
      {"Referrer-Policy", "no-referrer"}};
  return response;
}

}  // namespace slackwater::api::http
