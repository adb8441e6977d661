#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "api/http/message.h"
#include "api/http/metrics.h"

namespace slackwater::api::http {

/// What the composition root knows of the state of the service.
struct HealthFacts {
  bool is_healthy = true;
  /// Name and value, e.g. {"disk_free", "12 GB"}.
  std::vector<std::pair<std::string, std::string>> facts;
  /// Something is wrong that the service works around: said, but no reason
  /// to send clients elsewhere.
  bool is_degraded = false;
};

/// `/health`: {"status": "ok" | "degraded", "uptime_s", "version", ...facts}; 200 where healthy
/// (and perhaps degraded), else 503.
/// @param version  of the program
/// @param facts    asked at every call, from any thread; may be empty
[[nodiscard]] Handler health_handler(std::string version, std::shared_ptr<const Metrics> metrics,
                                     std::function<HealthFacts()> facts);

}  // namespace slackwater::api::http
