#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "api/door/http/message.h"
#include "api/door/http/metrics.h"

namespace slackwater::api::http {

/// What the composition root knows of the state of the service.
struct HealthFacts {
  /// One word for people and monitors: "ok", or what is wrong.
  std::string status = "ok";
  /// False: clients are better served elsewhere (a balancer takes this instance out).
  bool can_serve = true;
  /// False: what is served is no longer current. Said, but no reason to send clients elsewhere:
  /// another instance over the same data would be no better.
  bool is_current = true;
  /// Name and value, e.g. {"disk_free", "12 GB"}.
  std::vector<std::pair<std::string, std::string>> facts;
  /// An object, whose members the document has as well.
  nlohmann::ordered_json details = nlohmann::ordered_json::object();
};

/// Who asks, by what it does with the status code.
enum class Asker {
  balancer,  ///< 503 where clients are better served elsewhere
  monitor    ///< 503 there, and where somebody should look
};

/// `/health`: {"status", "uptime_s", "version", ...facts, ...details}, as 200 or 503.
/// @param version  of the program
/// @param facts    asked at every call, from any thread; may be empty
[[nodiscard]] Handler health_handler(std::string version, std::shared_ptr<const Metrics> metrics,
                                     std::function<HealthFacts()> facts,
                                     Asker asker = Asker::balancer);

}  // namespace slackwater::api::http
