#include "api/door/people/playback/playback_routes.h"
#include "api/door/people/answers.h"

#include "api/door/people/session_routes.h"
#include "api/door/people/told.h"

namespace slackwater::people {
namespace {

using api::http::Request;
using api::http::Response;
using nlohmann::json;

}  // namespace

void add_routes(api::http::Router& router, const std::shared_ptr<Playback>& playback) {
  const std::string path = std::string("/sessions/") + Playback::id;
  // Of this machine alone, as the socket is.
  const auto add = [&](const std::string& at, std::function<Response()> answer) {
    router.add("GET", at, [playback, answer = std::move(answer)](const Request& request) {
      if (auto refusal = playback->refusal(request)) return *std::move(refusal);
      return answer();
    });
  };
  add_page_routes(router);
  add("/sessions", [playback] {
    return json_response({{"sessions", json::array({playback->summary()})}});
  });
  add(path + "/check", [] {
    Response response;
    response.status = 204;
    return response;
  });
  add(path + "/actions", [playback] {
    json rows = json::array();
    for (const Action& action : playback->run().actions) rows.push_back(action_json(action));
    return json_response({{"actions", rows}});
  });
  router.add("GET", path + "/socket", api::http::websocket_route(playback));
}

}  // namespace slackwater::people
