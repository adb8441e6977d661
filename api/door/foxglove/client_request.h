#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/foxglove/messages.h"

namespace slackwater::api::foxglove {

struct Subscription {
  std::uint32_t id = 0;       ///< the client's
  std::uint32_t channel = 0;  ///< ours

  bool operator==(const Subscription&) const = default;
};

struct Status {
  Level level = Level::error;
  std::string message;

  bool operator==(const Status&) const = default;
};

/// What a client wants, as far as it can be read, and what it is to be told about the rest. An
/// entry that is wrong does not spoil those beside it.
struct ClientRequest {
  std::vector<Subscription> subscribe;
  std::vector<std::uint32_t> unsubscribe;
  std::vector<Status> statuses;  ///< few, whatever came
};

/// Reads a text of a client. Throws nothing: what is no JSON, names no known operation, or asks for
/// what a read-only door does not do (advertise, parameters, services, assets, the graph) becomes a
/// status.
[[nodiscard]] ClientRequest client_request(std::string_view text);
/// The answer to a binary message of a client: it publishes, or calls a service.
[[nodiscard]] Status binary_refusal(bool is_empty, std::uint8_t code);

}  // namespace slackwater::api::foxglove
