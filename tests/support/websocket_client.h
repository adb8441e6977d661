#pragma once
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/support/http_client.h"

namespace slackwater::tests {

struct ReceivedFrame {
  bool is_final = true;
  std::uint8_t opcode = 0;  ///< 1 text, 2 binary, 8 close, 9 ping, 10 pong
  std::string payload;

  /// Of a close frame; 1005 where there is none.
  [[nodiscard]] std::uint16_t code() const {
    if (payload.size() < 2) return 1005;
    return static_cast<std::uint16_t>((static_cast<std::uint8_t>(payload[0]) << 8U) |
                                      static_cast<std::uint8_t>(payload[1]));
  }
};

/// The bytes of a frame (RFC 6455 §5.2), right or wrong.
/// @param first_byte  flags and opcode: 0x81 a text, 0x82 bytes, 0x88 close, 0x89 ping
[[nodiscard]] std::string client_frame(std::uint8_t first_byte, std::string_view payload,
                                       bool is_masked = true);

/// A WebSocket made by hand, so that nothing of the server tests itself. It answers no
/// pings unless told to.
class WebSocketClient {
 public:
  /// Shakes hands; see `handshake` for the answer.
  /// @param protocols    the client's list, "" for no such field
  /// @param field_lines  further ones, each ended by CRLF
  WebSocketClient(const ServerPlace& place, const std::string& path, const std::string& protocols,
                  const std::string& field_lines = {}, int receive_buffer_bytes = 0);

  [[nodiscard]] const HttpReply& handshake() const noexcept { return handshake_; }
  [[nodiscard]] HttpClient& connection() noexcept { return connection_; }

  bool send_text(std::string_view text) { return connection_.send(client_frame(0x81, text)); }
  bool send_bytes(std::string_view bytes) { return connection_.send(client_frame(0x82, bytes)); }
  bool send(std::uint8_t first_byte, std::string_view payload) {
    return connection_.send(client_frame(first_byte, payload));
  }
  /// The next frame; nothing where the connection ends or `within` passes. A frame of the server
  /// that is masked or has reserved bits is a failure of the test.
  [[nodiscard]] std::optional<ReceivedFrame> receive(
      std::chrono::milliseconds within = std::chrono::seconds(20));
  /// The code of the farewell, what comes before it having been read; 0 where none comes.
  [[nodiscard]] std::uint16_t receive_close(
      std::chrono::milliseconds within = std::chrono::seconds(20));

 private:
  HttpClient connection_;
  HttpReply handshake_;
};

}  // namespace slackwater::tests
