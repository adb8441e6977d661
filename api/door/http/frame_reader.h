#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace slackwater::api::http {

/// The first byte of a frame without its flags (RFC 6455 §5.2).
enum class Opcode : std::uint8_t {
  continuation = 0,
  text = 1,
  binary = 2,
  close = 8,
  ping = 9,
  pong = 10
};

/// Why a socket ends (RFC 6455 §7.4.1).
namespace close_code {
constexpr std::uint16_t normal = 1000;
constexpr std::uint16_t going_away = 1001;
constexpr std::uint16_t protocol_error = 1002;
constexpr std::uint16_t no_code = 1005;  ///< the client gave none; never sent
constexpr std::uint16_t invalid_text = 1007;
constexpr std::uint16_t policy_violation = 1008;
constexpr std::uint16_t too_big = 1009;
constexpr std::uint16_t internal_error = 1011;
}  // namespace close_code

/// What has come in whole: a message, however many frames it came in, or a control frame.
struct Incoming {
  enum class Kind { text, binary, ping, pong, close, failed };
  Kind kind = Kind::failed;
  std::string bytes;       ///< payload; for `close` and `failed` the reason
  std::uint16_t code = 0;  ///< of `close`; of `failed` the one to answer with
};

/// Makes messages of what one client sends after the handshake, however it is cut (RFC 6455 §5).
/// Extensions are not spoken: reserved bits are errors. Knows no sockets; one thread. It holds one
/// message of at most the given size, and a read's worth of what comes after it.
class FrameReader {
 public:
  explicit FrameReader(std::size_t message_bytes) : message_bytes_(message_bytes) {}

  /// Room for bytes to come; say with `received` how many did.
  [[nodiscard]] std::span<char> room();
  void received(std::size_t bytes);
  /// The next thing that is whole; nothing where more bytes are needed. After `failed` no more.
  [[nodiscard]] std::optional<Incoming> next();

 private:
  struct Head {
    bool is_final = false;
    Opcode opcode = Opcode::continuation;
    std::size_t bytes = 0;    ///< of itself
    std::size_t payload = 0;  ///< that follow
  };
  /// What `next` makes of a frame: nothing where the message goes on.
  [[nodiscard]] std::optional<Incoming> taken(const Head& head, std::string payload);
  [[nodiscard]] std::optional<Head> head_of(std::string_view bytes);
  [[nodiscard]] std::optional<std::size_t> length_of(std::string_view bytes,
                                                     std::size_t short_form);
  [[nodiscard]] std::optional<Incoming> failure();
  void fail(std::uint16_t code, std::string why);

  std::size_t message_bytes_;
  std::string buffer_;
  std::size_t begin_ = 0;  ///< of what has not been taken
  std::size_t end_ = 0;    ///< of what has come
  std::string message_;    ///< the frames of it that have come
  std::optional<Opcode> message_opcode_;
  std::optional<Incoming> failure_;
};

/// Well-formed UTF-8 (RFC 3629): no overlong forms, no surrogates, nothing above U+10FFFF.
[[nodiscard]] bool is_utf8(std::string_view text) noexcept;

/// Of a frame from the server: final, not masked. 2, 4 or 10 bytes.
[[nodiscard]] std::string frame_head(Opcode opcode, std::size_t payload_bytes);
/// A control frame, whole; a payload beyond 125 bytes is cut off.
[[nodiscard]] std::string control_frame(Opcode opcode, std::string_view payload);
/// @param code  `no_code`: an empty one
[[nodiscard]] std::string close_frame(std::uint16_t code, std::string_view reason);

}  // namespace slackwater::api::http
