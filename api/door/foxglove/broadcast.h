#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "api/door/http/message.h"
#include "data/bag/channel.h"

namespace slackwater::api::foxglove {

/// Of one broadcast; never used twice.
enum class ChannelId : std::uint32_t {};

/// Live topics for people's viewers, over the Foxglove WebSocket protocol, v1: a second door that
/// only shows. Give it to a server and publish from any thread:
///
///   Broadcast live("harbour");
///   router.add("GET", "/live", live.route());                  // ws://HOST:PORT/live
///   const ChannelId odometry = live.advertise(channel);        // data/bag/channel.h
///   live.set_time(now_ns);
///   live.publish(odometry, now_ns, payload);                   // CDR, encapsulated
///
/// Clients see the channels that there are and get the messages of those that they subscribe to; of
/// transient-local channels also the last one said before. A publisher never waits for a client:
/// what a slow one does not take in is dropped, best-effort messages first
/// (`http::Limits::websocket_queue_bytes`), and counted. Thread-safe.
class Broadcast {
 public:
  /// @param name  of the server, shown by viewers
  explicit Broadcast(const std::string& name);
  ~Broadcast();  ///< tells its clients that it is over
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;

  ChannelId advertise(const bag::Channel& channel);
  /// Ends the channel and all subscriptions to it. An id that was never given is a
  /// ContractViolation, one that has been withdrawn already does nothing.
  void unadvertise(ChannelId id);
  /// Cost: two locks and a look-up where nobody subscribes; else one copy of the payload, however
  /// many subscribe, and a place in a queue for each.
  /// @param log_time_ns  since 1970, on the clock of `set_time`
  void publish(ChannelId id, std::uint64_t log_time_ns, bag::Payload payload);
  /// Whether anybody subscribes to it, so that others need not make its messages.
  [[nodiscard]] bool is_watched(ChannelId id) const;
  /// Simulation time, for clients to follow; late ones get the last.
  void set_time(std::uint64_t time_ns);

  struct Figures {
    std::size_t clients = 0;
    std::size_t subscriptions = 0;
    std::uint64_t sent = 0;     ///< messages queued for clients, each client by itself
    std::uint64_t dropped = 0;  ///< messages and times that a slow client did not get
  };
  [[nodiscard]] Figures figures() const;

  /// What the path of the door answers; may outlive the broadcast.
  [[nodiscard]] http::Handler route() const;

 private:
  class Hub;
  std::shared_ptr<Hub> hub_;
};

}  // namespace slackwater::api::foxglove
