#pragma once
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "api/door/http/router.h"

// For whom `/health`, `/health/fresh` and `/metrics` are: what monitors ask, and nobody else needs.

namespace slackwater::api::http {

/// Who may ask them.
enum class Monitoring {
  everyone,
  health,  ///< everyone `/health` and `/health/fresh`; `/metrics` as `local`
  local,   ///< who is trusted (trust.h): a client on this machine, or with the token
  nobody   ///< there are no such paths
};

/// Their names, in that order.
inline constexpr std::array<std::string_view, 4> monitoring_words{"everyone", "health", "local",
                                                                  "nobody"};

/// Throws Error(usage) for another word.
[[nodiscard]] Monitoring monitoring_named(std::string_view word);

struct MonitoringHandlers {
  Handler health;   ///< for balancers (health.h)
  Handler fresh;    ///< for monitors
  Handler metrics;  ///< metrics.h
};

/// Adds the paths that there are. Who may not ask one is told so with 403, however it is written.
void add_monitoring_routes(Router& router, Monitoring who, MonitoringHandlers handlers);

/// What the document of `/api` says of them: OpenAPI 3.0, to be merged into it (RFC 7396). It has a
/// security scheme `operator`.
[[nodiscard]] nlohmann::json monitoring_document(Monitoring who);

}  // namespace slackwater::api::http
