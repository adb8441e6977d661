#include "api/door/foxglove/client_request.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace slackwater::api::foxglove {
namespace {

using Json = nlohmann::json;

/// Of what a client sent, in a text for it.
constexpr std::size_t longest_named = 60;
constexpr std::size_t most_statuses = 5;

constexpr std::array<std::string_view, 10> writing_operations{"advertise",
                                                              "unadvertise",
                                                              "getParameters",
                                                              "setParameters",
                                                              "subscribeParameterUpdates",
                                                              "unsubscribeParameterUpdates",
                                                              "subscribeConnectionGraph",
                                                              "unsubscribeConnectionGraph",
                                                              "fetchAsset",
                                                              "callService"};

constexpr const char* read_only = "this door is read-only: it takes subscribe and unsubscribe";

/// Lists and objects by their kind alone: what is within them may be nested beyond all measure.
std::string shown(const Json& json) {
  if (json.is_array()) return "a list of " + std::to_string(json.size());
  if (json.is_object()) return "an object";
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > longest_named) text = text.substr(0, longest_named) + "...";
  return text;
}

std::string parts_of(const Json& subscription) {
  const auto part = [&](const char* key) {
    const auto found = subscription.find(key);
    return std::string(key) + " " + (found == subscription.end() ? "missing" : shown(*found));
  };
  return part("id") + ", " + part("channelId");
}

/// An unsigned number of 32 bits, which is all that a binary message has room for.
std::optional<std::uint32_t> id_of(const Json& json) {
  if (!json.is_number_unsigned()) return std::nullopt;
  const auto number = json.get<std::uint64_t>();
  if (number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

std::optional<std::uint32_t> id_in(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : id_of(*found);
}

/// Statuses that say what is wrong with entries, and how many more there were.
class Complaints {
 public:
  void add(std::string message) {
    if (++count_ <= most_statuses) statuses_.push_back({Level::error, std::move(message)});
  }
  std::vector<Status> taken() {
    if (count_ > most_statuses) {
      statuses_.back().message += " (and " + std::to_string(count_ - most_statuses) + " more)";
    }
    return std::move(statuses_);
  }

 private:
  std::size_t count_ = 0;
  std::vector<Status> statuses_;
};

/// Calls `visit` with each entry of the list of that name.
template <typename Visit>
void for_each_entry(const Json& message, const char* key, Complaints& complaints,
                    const Visit& visit) {
  const auto list = message.find(key);
  if (list == message.end() || !list->is_array()) {
    return complaints.add("expected a list '" + std::string(key) + "'; found " +
                          (list == message.end() ? "none" : shown(*list)));
  }
  for (const Json& entry : *list) visit(entry);
}

ClientRequest subscribe_request(const Json& message) {
  ClientRequest request;
  Complaints complaints;
  for_each_entry(message, "subscriptions", complaints, [&](const Json& entry) {
    const auto id = entry.is_object() ? id_in(entry, "id") : std::nullopt;
    const auto channel = entry.is_object() ? id_in(entry, "channelId") : std::nullopt;
    if (id && channel) return request.subscribe.push_back({*id, *channel});
    complaints.add(
        "a subscription has an id and a channelId, whole numbers from 0 to 4294967295; found " +
        (entry.is_object() ? parts_of(entry) : shown(entry)));
  });
  request.statuses = complaints.taken();
  return request;
}

ClientRequest unsubscribe_request(const Json& message) {
  ClientRequest request;
  Complaints complaints;
  for_each_entry(message, "subscriptionIds", complaints, [&](const Json& entry) {
    if (const auto id = id_of(entry)) return request.unsubscribe.push_back(*id);
    complaints.add("the id of a subscription is a whole number from 0 to 4294967295; found " +
                   shown(entry));
  });
  request.statuses = complaints.taken();
  return request;
}

ClientRequest told(Level level, std::string message) {
  return {{}, {}, {{level, std::move(message)}}};
}

}  // namespace

ClientRequest client_request(std::string_view text) {
  const Json message = Json::parse(text, nullptr, false);
  const auto op = message.is_object() ? message.find("op") : message.end();
  if (!message.is_object() || op == message.end() || !op->is_string()) {
    return told(Level::error, "expected a JSON object with a text 'op'; found " +
                                  (message.is_discarded() ? "no JSON" : shown(message)));
  }
  const auto& name = op->get_ref<const std::string&>();
  if (name == "subscribe") return subscribe_request(message);
  if (name == "unsubscribe") return unsubscribe_request(message);
  const bool is_known = std::find(writing_operations.begin(), writing_operations.end(), name) !=
                        writing_operations.end();
  if (is_known) return told(Level::warning, "'" + name + "' does nothing here: " + read_only);
  return told(Level::error, "unknown op " + shown(*op) + "; " + read_only);
}

Status binary_refusal(bool is_empty, std::uint8_t code) {
  if (is_empty) return {Level::error, "a binary message begins with its code; found none"};
  if (code == 1 || code == 2) {
    return {Level::warning, std::string(code == 1 ? "a message" : "a call of a service") +
                                " from a client does nothing here: " + read_only};
  }
  return {Level::error, "unknown binary code " + std::to_string(code) + "; " + read_only};
}

}  // namespace slackwater::api::foxglove
