#include "api/door/foxglove/broadcast.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "api/door/foxglove/client_request.h"
#include "api/door/foxglove/messages.h"
#include "api/door/http/websocket.h"
#include "fields/base/check.h"

namespace slackwater::api::foxglove {
namespace {

using http::Frame;
using http::WebSocket;
using http::Worth;
using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

constexpr std::uint16_t going_away = 1001;
/// Of one client; channels that were withdrawn count until it unsubscribes.
constexpr std::size_t most_subscriptions = 10'000;

Frame text_frame(std::string text, Worth worth) { return {true, std::move(text), nullptr, worth}; }

Bytes shared_bytes(bag::Payload payload) {
  return std::make_shared<const std::vector<std::uint8_t>>(payload.begin(), payload.end());
}

struct Message {
  std::uint64_t log_time_ns = 0;
  Bytes bytes;
};

struct Topic {
  std::string json;
  bag::Quality quality;
  std::vector<std::pair<std::shared_ptr<WebSocket>, std::uint32_t>> subscribers;  ///< and their ids
  std::optional<Message> last;  ///< of a transient-local channel

  [[nodiscard]] Worth worth() const {
    return quality.is_reliable ? Worth::reliable : Worth::best_effort;
  }
};

struct Client {
  std::shared_ptr<WebSocket> socket;
  std::map<std::uint32_t, std::uint32_t> channels;  ///< by the id of the subscription
};

std::string session_id_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::to_string(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

}  // namespace

/// The lock is held for bookkeeping and queueing alone; sockets are never waited for.
class Broadcast::Hub final : public http::WebSocketHandler {
 public:
  explicit Hub(const std::string& name) : info_(server_info_text(name, session_id_now())) {}

  std::uint32_t advertise(const bag::Channel& channel) {
    const std::lock_guard lock(mutex_);
    const std::uint32_t id = next_id_++;
    Topic& topic = topics_[id];
    topic.json = channel_json(id, channel);
    topic.quality = channel.quality;
    all_channels_.reset();
    send_all(text_frame(advertise_text(topic.json), Worth::essential));
    return id;
  }

  void unadvertise(std::uint32_t id) {
    const std::lock_guard lock(mutex_);
    expects(id < next_id_, "the channel was advertised");
    if (topics_.erase(id) == 0) return;
    all_channels_.reset();
    send_all(text_frame(unadvertise_text({&id, 1}), Worth::essential));
  }

  void publish(std::uint32_t id, std::uint64_t log_time_ns, bag::Payload payload) {
    const std::lock_guard lock(mutex_);
    expects(id < next_id_, "the channel was advertised");
    const auto found = topics_.find(id);
    if (found == topics_.end()) return;
    Topic& topic = found->second;
    if (topic.subscribers.empty() && !topic.quality.is_transient_local) return;
    const Message message{log_time_ns, shared_bytes(payload)};
    for (const auto& [socket, subscription] : topic.subscribers) {
      send(*socket, subscription, message, topic.worth());
    }
    if (topic.quality.is_transient_local) topic.last = message;
  }

  bool is_watched(std::uint32_t id) const {
    const std::lock_guard lock(mutex_);
    expects(id < next_id_, "the channel was advertised");
    const auto found = topics_.find(id);
    return found != topics_.end() && !found->second.subscribers.empty();
  }

  void set_time(std::uint64_t time_ns) {
    const std::lock_guard lock(mutex_);
    time_ns_ = time_ns;
    send_all(time_frame(time_ns));
  }

  Figures figures() const {
    const std::lock_guard lock(mutex_);
    Figures figures{clients_.size(), 0, sent_, dropped_};
    for (const auto& [id, topic] : topics_) figures.subscriptions += topic.subscribers.size();
    return figures;
  }

  void end() {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    for (const auto& [key, client] : clients_) client.socket->close(going_away, over);
  }

  // --- clients ---

  [[nodiscard]] std::vector<std::string> protocols() const override {
    // Two names of one protocol: the second is what newer bridges insist on.
    return {"foxglove.websocket.v1", "foxglove.sdk.v1"};
  }

  void opened(const std::shared_ptr<WebSocket>& socket, const http::Request&,
              const std::string&) override {
    const std::lock_guard lock(mutex_);
    clients_[socket.get()].socket = socket;
    count(socket->send(text_frame(info_, Worth::essential)));
    count(socket->send({true, {}, all_channels(), Worth::essential}));
    if (time_ns_) count(socket->send(time_frame(*time_ns_)));
    if (is_over_) socket->close(going_away, over);
  }

  void received_text(WebSocket& socket, std::string_view text) override {
    const ClientRequest request = client_request(text);
    const std::lock_guard lock(mutex_);
    Client& client = clients_.at(&socket);
    for (const Subscription& wanted : request.subscribe) subscribe(client, wanted);
    for (const std::uint32_t id : request.unsubscribe) unsubscribe(client, id);
    for (const Status& status : request.statuses) tell(socket, status);
  }

  void received_bytes(WebSocket& socket, std::span<const std::uint8_t> bytes) override {
    const Status refused = binary_refusal(bytes.empty(), bytes.empty() ? 0 : bytes.front());
    const std::lock_guard lock(mutex_);
    tell(socket, refused);
  }

  void closed(WebSocket& socket) override {
    const std::lock_guard lock(mutex_);
    const auto client = clients_.find(&socket);
    if (client == clients_.end()) return;
    for (const auto& [id, channel] : client->second.channels) forget(socket, channel);
    clients_.erase(client);
  }

 private:
  static constexpr const char* over = "the broadcast is over";

  static Frame time_frame(std::uint64_t time_ns) {
    return {false, time_bytes(time_ns), nullptr, Worth::best_effort};
  }

  void count(std::size_t dropped) { dropped_ += dropped; }

  void tell(WebSocket& socket, const Status& status) {
    count(socket.send(text_frame(status_text(status.level, status.message), Worth::reliable)));
  }

  void send_all(const Frame& frame) {
    for (const auto& [key, client] : clients_) count(client.socket->send(frame));
  }

  void send(WebSocket& socket, std::uint32_t subscription, const Message& message, Worth worth) {
    ++sent_;
    count(socket.send(
        {false, message_data_head(subscription, message.log_time_ns), message.bytes, worth}));
  }

  void subscribe(Client& client, const Subscription& wanted) {
    const std::string at = "subscription " + std::to_string(wanted.id) + ": ";
    const auto refuse = [&](const std::string& why) {
      tell(*client.socket, {Level::error, at + why});
    };
    const auto topic = topics_.find(wanted.channel);
    if (client.channels.contains(wanted.id)) return refuse("the id is in use already");
    if (topic == topics_.end()) {
      return refuse("there is no channel " + std::to_string(wanted.channel));
    }
    auto& subscribers = topic->second.subscribers;
    const bool has_one = std::any_of(subscribers.begin(), subscribers.end(),
                                     [&](const auto& one) { return one.first == client.socket; });
    if (has_one) {
      return refuse("channel " + std::to_string(wanted.channel) + " is subscribed to already");
    }
    if (client.channels.size() >= most_subscriptions) {
      return refuse("a client has at most " + std::to_string(most_subscriptions) +
                    " subscriptions");
    }
    client.channels.emplace(wanted.id, wanted.channel);
    subscribers.emplace_back(client.socket, wanted.id);
    const auto& last = topic->second.last;
    if (last) send(*client.socket, wanted.id, *last, topic->second.worth());
  }

  void unsubscribe(Client& client, std::uint32_t id) {
    const auto found = client.channels.find(id);
    if (found == client.channels.end()) {
      return tell(*client.socket,
                  {Level::warning, "there is no subscription " + std::to_string(id)});
    }
    // Where the channel has been withdrawn there is nothing to forget: viewers unsubscribe then.
    forget(*client.socket, found->second);
    client.channels.erase(found);
  }

  void forget(const WebSocket& socket, std::uint32_t channel) {
    const auto topic = topics_.find(channel);
    if (topic == topics_.end()) return;
    std::erase_if(topic->second.subscribers,
                  [&](const auto& one) { return one.first.get() == &socket; });
  }

  /// The advertisement of all channels, made once for all clients that come until they change.
  const Bytes& all_channels() {
    if (all_channels_) return all_channels_;
    std::string list;
    for (const auto& [id, topic] : topics_) list += (list.empty() ? "" : ",") + topic.json;
    const std::string text = advertise_text(list);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    all_channels_ = shared_bytes({bytes, text.size()});
    return all_channels_;
  }

  const std::string info_;
  mutable std::mutex mutex_;
  std::uint32_t next_id_ = 0;
  std::map<std::uint32_t, Topic> topics_;
  std::unordered_map<const WebSocket*, Client> clients_;
  std::optional<std::uint64_t> time_ns_;
  Bytes all_channels_;  ///< null: to be made
  bool is_over_ = false;
  std::uint64_t sent_ = 0;
  std::uint64_t dropped_ = 0;
};

Broadcast::Broadcast(const std::string& name) : hub_(std::make_shared<Hub>(name)) {}
Broadcast::~Broadcast() { hub_->end(); }

ChannelId Broadcast::advertise(const bag::Channel& channel) {
  return ChannelId{hub_->advertise(channel)};
}

void Broadcast::unadvertise(ChannelId id) { hub_->unadvertise(static_cast<std::uint32_t>(id)); }

void Broadcast::publish(ChannelId id, std::uint64_t log_time_ns, bag::Payload payload) {
  hub_->publish(static_cast<std::uint32_t>(id), log_time_ns, payload);
}

bool Broadcast::is_watched(ChannelId id) const {
  return hub_->is_watched(static_cast<std::uint32_t>(id));
}

void Broadcast::set_time(std::uint64_t time_ns) { hub_->set_time(time_ns); }

Broadcast::Figures Broadcast::figures() const { return hub_->figures(); }

http::Handler Broadcast::route() const { return http::websocket_route(hub_); }

}  // namespace slackwater::api::foxglove
