#include "api/http/health.h"

#include <nlohmann/json.hpp>

namespace slackwater::api::http {

Handler health_handler(std::string version, std::shared_ptr<const Metrics> metrics,
                       std::function<HealthFacts()> facts) {
  return [version = std::move(version), metrics = std::move(metrics),
          facts = std::move(facts)](const Request&) {
    const HealthFacts found = facts ? facts() : HealthFacts{};
    const bool is_well = found.is_healthy && !found.is_degraded;
    nlohmann::ordered_json document{{"status", is_well ? "ok" : "degraded"},
                                    {"uptime_s", metrics->uptime().count()},
                                    {"version", version}};
    for (const auto& [name, value] : found.facts) document[name] = value;
    Response response;
    response.status = found.is_healthy ? 200 : 503;
    response.media_type = "application/json";
    response.body = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    return response;
  };
}

}  // namespace slackwater::api::http
