#pragma once
#include <memory>

#include "api/door/http/router.h"
#include "api/door/people/playback/playback.h"

namespace slackwater::people {

/// The paths of a session (api/docs/session_wire.md) for a log that is watched again: the same
/// page, the list, the record and the socket, and no token anywhere.
void add_routes(api::http::Router& router, const std::shared_ptr<Playback>& playback);

}  // namespace slackwater::people
