#pragma once
#include <memory>

#include "api/door/http/router.h"
#include "api/door/people/session.h"

namespace slackwater::people {

/// The paths of a session, as in api/docs/session.md: the page, the list, the check of a token, the
/// record and the socket.
void add_routes(api::http::Router& router, const std::shared_ptr<Session>& session);

}  // namespace slackwater::people
