#pragma once
#include <memory>

#include "api/door/http/router.h"
#include "api/door/sessions/session_host.h"

namespace slackwater::sessions {

/// The paths of sessions (api/door/people/session_routes.h), and those by which supervisors begin
/// and end them:
///
///     GET  /sessions/{id}                                  200, as in the list
///     POST /sessions             {"begin": "night-cp"}     201, Location: /sessions/night-cp
///     POST /sessions/{id}/end                              202
void add_routes(api::http::Router& router, const std::shared_ptr<SessionHost>& host);

/// Whether a request goes to one of the two that write. They ask for a supervisor's token
/// themselves: `http::ServerOptions::guards_itself`.
[[nodiscard]] bool is_for_supervisors(const api::http::Request& request);

}  // namespace slackwater::sessions
