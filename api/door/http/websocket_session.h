#pragma once
#include <memory>

#include "api/door/http/session.h"

namespace slackwater::api::http {

/// A connection that has become a WebSocket, in one of these states:
///
///   open -> closing -> closed
///
/// Open, it reads messages for its handler and writes what others queue for it, several frames at
/// a time. Closing, the farewell of one side is on its way and that of the other awaited; who does
/// not answer within a second is closed all the same. A client that is silent is pinged, one that
/// takes nothing in within `Limits::write_time` (for each quarter of a megabyte) is closed.
///
/// Takes over a connected, non-blocking socket that nobody waits on; where it throws, it does not.
/// @param reply  with the head of the 101, not yet written, and a successor
[[nodiscard]] std::shared_ptr<Session> open_websocket(SessionSite& site, int descriptor, Peer peer,
                                                      Reply reply);

}  // namespace slackwater::api::http
