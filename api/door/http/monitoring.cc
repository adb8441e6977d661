#include "api/door/http/monitoring.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/door/http/interface_words.h"
#include "api/door/http/problem.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

using nlohmann::json;

/// The handler for those who are trusted; who is not learns what to do, and nothing else.
Handler for_trusted(Handler handler) {
  return [handler = std::move(handler)](const Request& request) -> Outcome {
    if (request.is_trusted) return handler(request);
    return problem(403,
                   "This path is for clients on the server's own machine, which ask 127.0.0.1 or "
                   "localhost and not through a proxy, and for who sends 'Authorization: Bearer "
                   "<token>'; the operator opens it to others by --monitoring.",
                   request.path);
  };
}

bool is_health_for_all(Monitoring who) {
  return who == Monitoring::everyone || who == Monitoring::health;
}

json described(const char* id, const char* summary, const char* answer, bool is_for_all) {
  json responses = openapi::refusals({"404"});
  responses["200"] = openapi::reference("responses", answer);
  responses["304"] = openapi::reference("responses", "NotModified");
  if (answer == std::string_view("Health"))
    responses["503"] = openapi::reference("responses", answer);
  json get = openapi::operation(id, "Service", summary, json::array(), std::move(responses));
  if (!is_for_all) get = openapi::for_operators(std::move(get), "403");
  return {{"get", std::move(get)}};
}

}  // namespace

Monitoring monitoring_named(std::string_view word) {
  const auto* const found = std::find(monitoring_words.begin(), monitoring_words.end(), word);
  if (found != monitoring_words.end())
    return static_cast<Monitoring>(found - monitoring_words.begin());
  throw Error(ErrorKind::usage, "--monitoring: found '" + std::string(word) +
                                    "', expected one of " + joined(monitoring_words, ", "));
}

void add_monitoring_routes(Router& router, Monitoring who, MonitoringHandlers handlers) {
  if (who == Monitoring::nobody) return;
  const auto add = [&](const char* path, Handler handler, bool is_for_all) {
    router.add("GET", path, is_for_all ? std::move(handler) : for_trusted(std::move(handler)));
  };
  add("/health", std::move(handlers.health), is_health_for_all(who));
  add("/health/fresh", std::move(handlers.fresh), is_health_for_all(who));
  add("/metrics", std::move(handlers.metrics), who == Monitoring::everyone);
}

json monitoring_document(Monitoring who) {
  if (who == Monitoring::nobody) return json::object();
  const bool for_all = is_health_for_all(who);
  json health = openapi::object({{"status", openapi::text()}, {"uptime_s", {{"type", "number"}}}});
  health["required"] = {"status", "uptime_s", "version"};
  return {{"paths",
           {{"/health", described("get_health", "Whether the service is well", "Health", for_all)},
            {"/health/fresh", described("get_health_fresh", "Whether the forecasts are new as well",
                                        "Health", for_all)},
            {"/metrics", described("get_metrics", "Counters for Prometheus", "Counters",
                                   who == Monitoring::everyone)}}},
          {"components",
           {{"schemas", {{"Health", std::move(health)}}},
            {"responses",
             {{"Health",
               openapi::answer("How the service is", openapi::reference("schemas", "Health"))},
              {"Counters",
               {{"description", "Prometheus text"},
                {"content", {{"text/plain", {{"schema", openapi::text()}}}}}}}}},
            {"securitySchemes", openapi::operator_scheme()}}}};
}

}  // namespace slackwater::api::http
