#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "data/bag/channel.h"

// What the server says in the Foxglove WebSocket protocol, v1 (docs/spec.md of
// foxglove/ws-protocol): JSON texts, and binary messages that begin with an operation code.
// Integers are little endian, times nanoseconds since 1970.

namespace slackwater::api::foxglove {

/// How a status is shown to people.
enum class Level { info = 0, warning = 1, error = 2 };

/// The first message to every client.
/// @param session_id  the same for one broadcast, another for the next: clients tell by it whether
///                    they came back to what they knew
[[nodiscard]] std::string server_info_text(std::string_view name, std::string_view session_id);
[[nodiscard]] std::string status_text(Level level, std::string_view message);
/// One channel of an `advertise` message: CDR with its schema as "ros2msg".
[[nodiscard]] std::string channel_json(std::uint32_t id, const bag::Channel& channel);
/// @param channels  texts of `channel_json`, separated by commas
[[nodiscard]] std::string advertise_text(std::string_view channels);
[[nodiscard]] std::string unadvertise_text(std::span<const std::uint32_t> ids);
/// The 13 bytes before the payload of a message.
[[nodiscard]] std::string message_data_head(std::uint32_t subscription, std::uint64_t log_time_ns);
/// The time of the server, which may run faster or slower than the client's.
[[nodiscard]] std::string time_bytes(std::uint64_t time_ns);

}  // namespace slackwater::api::foxglove
