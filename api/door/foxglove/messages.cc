#include "api/door/foxglove/messages.h"

#include <nlohmann/json.hpp>

namespace slackwater::api::foxglove {
namespace {

constexpr char message_data_code = 1;
constexpr char time_code = 2;

/// Bytes that are not UTF-8 become U+FFFD: a text has to be that.
std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <typename Number>
void append_little_endian(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) {
    bytes += static_cast<char>((number >> (8 * i)) & 0xffU);
  }
}

}  // namespace

std::string server_info_text(std::string_view name, std::string_view session_id) {
  return text_of({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities", {"time"}},
                  {"supportedEncodings", nlohmann::ordered_json::array()},
                  {"metadata", nlohmann::ordered_json::object()},
                  {"sessionId", session_id}});
}

std::string status_text(Level level, std::string_view message) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}});
}

std::string channel_json(std::uint32_t id, const bag::Channel& channel) {
  return text_of({{"id", id},
                  {"topic", channel.topic},
                  {"encoding", "cdr"},
                  {"schemaName", channel.type},
                  {"schema", channel.definition},
                  {"schemaEncoding", "ros2msg"}});
}

std::string advertise_text(std::string_view channels) {
  return R"({"op":"advertise","channels":[)" + std::string(channels) + "]}";
}

std::string unadvertise_text(std::span<const std::uint32_t> ids) {
  return text_of({{"op", "unadvertise"},
                  {"channelIds", nlohmann::ordered_json(std::vector(ids.begin(), ids.end()))}});
}

std::string message_data_head(std::uint32_t subscription, std::uint64_t log_time_ns) {
  std::string bytes(1, message_data_code);
  append_little_endian(bytes, subscription);
  append_little_endian(bytes, log_time_ns);
  return bytes;
}

std::string time_bytes(std::uint64_t time_ns) {
  std::string bytes(1, time_code);
  append_little_endian(bytes, time_ns);
  return bytes;
}

}  // namespace slackwater::api::foxglove
