#include "tests/support/websocket_client.h"

#include <array>
#include <stdexcept>

namespace slackwater::tests {
namespace {

constexpr std::array<char, 4> mask{'\x37', '\xfa', '\x21', '\x3d'};

std::uint64_t number_of(const std::string& bytes) {
  std::uint64_t number = 0;
  for (const char c : bytes) number = (number << 8U) | static_cast<std::uint8_t>(c);
  return number;
}

}  // namespace

std::string client_frame(std::uint8_t first_byte, std::string_view payload, bool is_masked) {
  std::string frame(1, static_cast<char>(first_byte));
  const std::size_t width = payload.size() < 126 ? 0 : payload.size() < 65536 ? 2 : 8;
  const std::size_t length = width == 0 ? payload.size() : width == 2 ? 126 : 127;
  frame += static_cast<char>(length | (is_masked ? 0x80U : 0U));
  for (std::size_t i = width; i-- > 0;) {
    frame += static_cast<char>((payload.size() >> (8 * i)) & 0xffU);
  }
  if (!is_masked) return frame.append(payload);
  frame.append(mask.data(), mask.size());
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame += static_cast<char>(payload[i] ^ mask.at(i % mask.size()));
  }
  return frame;
}

WebSocketClient::WebSocketClient(const ServerPlace& place, const std::string& path,
                                 const std::string& protocols, const std::string& field_lines,
                                 int receive_buffer_bytes)
    : connection_(place, receive_buffer_bytes) {
  std::string request = "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n";
  request += "Connection: keep-alive, Upgrade\r\nUpgrade: websocket\r\n";
  request += "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  if (!protocols.empty()) request += "Sec-WebSocket-Protocol: " + protocols + "\r\n";
  connection_.send(request + field_lines + "\r\n");
  const auto reply = connection_.receive();
  if (!reply) throw std::runtime_error("no answer to the handshake");
  handshake_ = *reply;
}

std::optional<ReceivedFrame> WebSocketClient::receive(std::chrono::milliseconds within) {
  const auto until = std::chrono::steady_clock::now() + within;
  // Whole or not at all: over a slow link a part of a frame comes by itself.
  std::string taken;
  const auto next = [&](std::size_t count) {
    const auto left = until - std::chrono::steady_clock::now();
    auto bytes = connection_.receive_bytes(
        count, std::chrono::duration_cast<std::chrono::milliseconds>(left));
    if (bytes)
      taken += *bytes;
    else
      connection_.unread(taken);
    return bytes;
  };
  const auto head = next(2);
  if (!head) return std::nullopt;
  const auto first = static_cast<std::uint8_t>(head->at(0));
  const auto second = static_cast<std::uint8_t>(head->at(1));
  if ((first & 0x70U) != 0) throw std::runtime_error("reserved bits in a frame of the server");
  if ((second & 0x80U) != 0) throw std::runtime_error("a frame of the server is masked");
  std::uint64_t length = second;
  if (second >= 126) {
    const auto longer = next(second == 126 ? 2 : 8);
    if (!longer) return std::nullopt;
    length = number_of(*longer);
  }
  const auto payload = next(length);
  if (!payload) return std::nullopt;
  return ReceivedFrame{(first & 0x80U) != 0, static_cast<std::uint8_t>(first & 0x0fU), *payload};
}

std::uint16_t WebSocketClient::receive_close(std::chrono::milliseconds within) {
  const auto until = std::chrono::steady_clock::now() + within;
  for (;;) {
    const auto left = until - std::chrono::steady_clock::now();
    const auto frame = receive(std::chrono::duration_cast<std::chrono::milliseconds>(left));
    if (!frame) return 0;
    if (frame->opcode == 8) return frame->code();
  }
}

}  // namespace slackwater::tests
