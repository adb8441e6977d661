#pragma once
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "api/door/http/router.h"
#include "api/door/people/session.h"

namespace slackwater::people {

/// The page /session itself and that of hands: of whatever is served beside them.
void add_page_routes(api::http::Router& router);

/// The sessions of a server. Called from any thread.
struct ServedSessions {
  std::function<nlohmann::json()> list;  ///< the answer to `GET /sessions`
  /// @throws Error(not_found) that names what there is
  std::function<std::shared_ptr<Session>(const std::string& id)> find;
};

/// The paths of sessions, as in api/docs/session_wire.md: the page, the list, the check of a token,
/// the record and the socket.
void add_routes(api::http::Router& router, const ServedSessions& sessions);
/// The same of a server that has but one, and what the cameras of its vehicles see.
void add_routes(api::http::Router& router, const std::shared_ptr<Session>& session);

}  // namespace slackwater::people
