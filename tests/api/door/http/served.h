#pragma once
#include <memory>
#include <utility>

#include "api/door/http/metrics.h"
#include "api/door/http/router.h"
#include "api/door/http/server.h"
#include "tests/support/http_client.h"

namespace slackwater::tests {

/// A body of 6 kB that compresses like JSON.
inline std::string long_body() {
  std::string body = "[";
  for (int i = 0; body.size() < 6000; ++i) body += std::to_string(i) + ".25, ";
  return body + "0]";
}

inline api::http::Response text_response(std::string body,
                                         std::string media_type = "application/json") {
  api::http::Response response;
  response.media_type = std::move(media_type);
  response.body = std::move(body);
  return response;
}

/// GET /short, GET /long (cacheable for a minute), GET /echo/{word}, POST /write.
inline api::http::Router example_router() {
  using namespace api::http;
  Router router;
  router.add("GET", "/short", [](const Request&) { return text_response("{}\n"); });
  router.add("GET", "/long", [](const Request&) {
    Response response = text_response(long_body());
    response.max_age_s = 60;
    return response;
  });
  router.add("GET", "/echo/{word}", [](const Request& request, const PathParameters& path) {
    return text_response(path.at("word") + "?" + request.query, "text/plain");
  });
  router.add("POST", "/write", [](const Request& request) {
    return text_response(std::to_string(request.body.size()), "text/plain");
  });
  return router;
}

/// A server on a free port, started.
class Served {
 public:
  explicit Served(api::http::Handler handler = example_router(),
                  api::http::ServerOptions options = {})
      : server_(std::move(options), std::move(handler)) {
    server_.start();
  }
  [[nodiscard]] HttpClient client(int receive_buffer_bytes = 0) const {
    return HttpClient(server_.port(), receive_buffer_bytes);
  }
  /// One that comes from an address of its own, in 127.0.0.0/8.
  [[nodiscard]] HttpClient client_from(const char* address) const {
    ServerPlace place(server_.port());
    place.from = address;
    return HttpClient(place);
  }
  [[nodiscard]] api::http::Server& server() noexcept { return server_; }
  /// Asks once, on a connection of its own.
  [[nodiscard]] std::optional<HttpReply> get(const std::string& target,
                                             const std::string& field_lines = {}) const {
    return client().get(target, field_lines);
  }

 private:
  api::http::Server server_;
};

}  // namespace slackwater::tests
