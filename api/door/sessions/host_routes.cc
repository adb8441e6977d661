#include "api/door/sessions/host_routes.h"

#include <nlohmann/json.hpp>

#include "api/door/http/field_list.h"
#include "api/door/http/problem.h"
#include "api/door/http/trust.h"
#include "api/door/people/answers.h"
#include "api/door/people/session_routes.h"
#include "twin/run/printable.h"

namespace slackwater::sessions {
namespace {

using api::http::PathParameters;
using api::http::problem;
using api::http::Request;
using api::http::Response;
using nlohmann::json;

constexpr std::string_view all_sessions = "/sessions";

Response told(int status, const json& body) {
  Response response = people::json_response(body);
  response.status = status;
  return response;
}

Response refusal(const Refused& refused, const Request& request) {
  Response response = problem(refused.status, refused.text, request.path);
  if (refused.status == 401) response.headers.emplace_back("WWW-Authenticate", "Bearer");
  return response;
}

/// The name of the supervisor who asks; the answer to anybody else.
std::variant<std::string, Response> supervisor(const SessionHost& host, const Request& request) {
  if (!api::http::is_of_own_origin(request))
    return problem(403,
                   "found a page of another origin, expected this server's own; open /session here",
                   request.path);
  const auto known = host.supervisor_of(api::http::bearer_of(request.authorization));
  if (const auto* refused = std::get_if<Refused>(&known)) return refusal(*refused, request);
  const std::string& name = std::get<people::Grant>(known).name;
  return name.empty() ? "a supervisor" : name;
}

/// Browsers ask before they let a page of another origin send it.
bool is_json(std::string_view content_type) {
  const std::string_view type = content_type.substr(0, content_type.find(';'));
  return api::http::equal_ignoring_case(api::http::trimmed(type), "application/json");
}

/// The id in {"begin": "ID"}; nothing where it is something else.
std::optional<std::string> asked_to_begin(const std::string& body) {
  const json asked = json::parse(body, nullptr, false);
  if (!asked.is_object() || asked.size() != 1) return std::nullopt;
  const auto id = asked.find("begin");
  if (id == asked.end() || !id->is_string()) return std::nullopt;
  return id->get<std::string>();
}

Response begun(SessionHost& host, const Request& request) {
  auto by = supervisor(host, request);
  if (auto* no = std::get_if<Response>(&by)) return std::move(*no);
  if (!is_json(request.content_type))
    return problem(415,
                   "found Content-Type '" + twin::printable(request.content_type, 60) +
                       "', expected application/json",
                   request.path);
  const auto offer = asked_to_begin(request.body);
  if (!offer)
    return problem(400,
                   R"(found a body that is something else, expected {"begin": "ID"}, ID one of )"
                   R"(may_begin of GET /sessions)",
                   request.path);
  const auto outcome = host.begin(*offer, std::get<std::string>(by));
  if (const auto* refused = std::get_if<Refused>(&outcome)) return refusal(*refused, request);
  const auto& id = std::get<std::string>(outcome);
  Response response = told(201, {{"id", id}});
  response.headers.emplace_back("Location", std::string(all_sessions) + "/" + id);
  return response;
}

}  // namespace

void add_routes(api::http::Router& router, const std::shared_ptr<SessionHost>& host) {
  people::add_routes(router, {[host] { return host->list(); },
                              [host](const std::string& id) { return host->find(id); }});
  router.add("GET", std::string(all_sessions) + "/{session}",
             [host](const Request&, const PathParameters& parameters) -> Response {
               return told(200, host->summary(parameters.at("session")));
             });
  // The store may keep whoever begins a session waiting.
  router.add("POST", all_sessions, [host](const Request& request) {
    return api::http::LongWork{[host, request] { return begun(*host, request); }};
  });
  router.add("POST", std::string(all_sessions) + "/{session}/end",
             [host](const Request& request, const PathParameters& parameters) -> Response {
               auto by = supervisor(*host, request);
               if (auto* no = std::get_if<Response>(&by)) return std::move(*no);
               const std::string& id = parameters.at("session");
               const std::string state = host->end(id, std::get<std::string>(by));
               return told(202, {{"id", id}, {"state", state}});
             });
}

bool is_for_supervisors(const Request& request) {
  const std::string_view path = request.path;
  return path == all_sessions ||
         (path.starts_with(std::string(all_sessions) + "/") && path.ends_with("/end"));
}

}  // namespace slackwater::sessions
