#include "api/door/people/session_routes.h"

#include "api/door/http/page_part.h"
#include "api/door/http/problem.h"
#include "api/door/http/trust.h"
#include "api/door/people/answers.h"
#include "api/door/people/hands_routes.h"
#include "api/program/paths.h"
#include "api/web/assets.h"
#include "fields/base/error.h"

namespace slackwater::people {

using api::http::page_part;
using api::http::PathParameters;
using api::http::Request;
using api::http::Response;
using nlohmann::json;

namespace {

using Find = std::function<std::shared_ptr<Session>(const PathParameters&)>;
using Answer = std::function<Response(const Session&, const Request&, const PathParameters&)>;

/// For whoever may read the session, by the token.
api::http::RouteHandler read_by(Find find, Answer answer) {
  return [find = std::move(find), answer = std::move(answer)](
             const Request& request, const PathParameters& parameters) -> api::http::Outcome {
    const auto session = find(parameters);
    const std::string_view token = api::http::bearer_of(request.authorization);
    if (auto no = session->refusal_to_read(token, request.path)) return *std::move(no);
    return answer(*session, request, parameters);
  };
}

}  // namespace

void add_page_routes(api::http::Router& router) {
  router.add("GET", "/session", [](const Request&) {
    return page_part("text/html; charset=utf-8", web::session_page().html);
  });
  router.add("GET", "/session/page.js", [](const Request&) {
    return page_part("text/javascript; charset=utf-8", web::session_page().script);
  });
  router.add("GET", "/session/page.css", [](const Request&) {
    return page_part("text/css; charset=utf-8", web::session_page().style);
  });
  add_hands_routes(router, api::hand_detector_folder());
}

void add_routes(api::http::Router& router, const ServedSessions& sessions) {
  using api::http::bearer_of;
  add_page_routes(router);
  router.add("GET", "/sessions",
             [list = sessions.list](const Request&) { return json_response(list()); });
  const std::string path = "/sessions/{session}";
  const auto named = [find = sessions.find](const PathParameters& parameters) {
    return find(parameters.at("session"));
  };
  router.add("GET", path + "/check",
             [find = sessions.find](const Request& request, const PathParameters& parameters) {
               const auto session = find(parameters.at("session"));
               if (auto no = session->refusal_of(bearer_of(request.authorization), request.path))
                 return *std::move(no);
               Response response;
               response.status = 204;
               return response;
             });
  router.add("GET", path + "/actions",
             read_by(named, [](const Session& session, const Request&, const PathParameters&) {
               json rows = json::array();
               for (const Action& action : session.actions())
                 if (is_told(action)) rows.push_back(action_json(action));
               return json_response({{"actions", rows}});
             }));
  router.add("GET", path + "/surfaces/{vehicle}/{surface}",
             read_by(named, [](const Session& session, const Request& request,
                               const PathParameters& parameters) {
               return session.surface(parameters.at("vehicle"), parameters.at("surface"),
                                      request.path);
             }));
  router.add("GET", path + "/socket",
             [find = sessions.find](const Request& request, const PathParameters& parameters) {
               return api::http::websocket_route(find(parameters.at("session")))(request);
             });
}

void add_routes(api::http::Router& router, const std::shared_ptr<Session>& session) {
  // Sessions that a server begins have no cameras.
  const auto the_one = [session](const PathParameters&) { return session; };
  router.add("GET", "/sessions/" + session->id() + "/pictures/{vehicle}/{sensor}",
             read_by(the_one, [](const Session& one, const Request& request,
                                 const PathParameters& parameters) {
               return one.picture(parameters.at("vehicle"), parameters.at("sensor"), request.path);
             }));
  add_routes(router, {[session] {
                        return json{{"sessions", json::array({session->summary()})}};
                      },
                      [session](const std::string& id) {
                        if (id == session->id()) return session;
                        throw Error(ErrorKind::not_found,
                                    "found no session '" + id + "', expected " + session->id());
                      }});
}

}  // namespace slackwater::people
