#include "api/door/http/health.h"

namespace slackwater::api::http {

Handler health_handler(std::string version, std::shared_ptr<const Metrics> metrics,
                       std::function<HealthFacts()> facts, Asker asker) {
  return [version = std::move(version), metrics = std::move(metrics), facts = std::move(facts),
          asker](const Request&) {
    const HealthFacts found = facts ? facts() : HealthFacts{};
    nlohmann::ordered_json document{
        {"status", found.status}, {"uptime_s", metrics->uptime().count()}, {"version", version}};
    for (const auto& [name, value] : found.facts) document[name] = value;
    document.update(found.details);
    const bool is_well = found.can_serve && (found.is_current || asker == Asker::balancer);
    Response response;
    response.status = is_well ? 200 : 503;
    response.media_type = "application/json";
    response.body = document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    return response;
  };
}

}  // namespace slackwater::api::http
