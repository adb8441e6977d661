#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace slackwater::tests {

/// An answer as a client reads it; the names of the fields in lower case.
struct HttpReply {
  int status = 0;
  std::map<std::string, std::string> fields;
  std::string body;

  [[nodiscard]] std::string field(const std::string& name) const {
    const auto found = fields.find(name);
    return found == fields.end() ? std::string() : found->second;
  }
};

/// Where a server listens: a port, of this machine unless told otherwise.
struct ServerPlace {
  ServerPlace(std::uint16_t at_port, const char* at = "127.0.0.1")  // NOLINT: mostly a port
      : port(at_port), address(at) {}
  std::uint16_t port;
  const char* address;         ///< IPv4
  const char* from = nullptr;  ///< the client's own address, IPv4; null: the system's choice
};

/// A TCP connection that sends what it is told to, right or wrong, and reads answers
/// by their Content-Length. Plain POSIX, so that nothing of the server's library tests itself.
class HttpClient {
 public:
  /// @param receive_buffer_bytes  0: the system's
  explicit HttpClient(const ServerPlace& place, int receive_buffer_bytes = 0);
  ~HttpClient();
  HttpClient(HttpClient&& other) noexcept;
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;
  HttpClient& operator=(HttpClient&&) = delete;

  /// @return whether all of it went; false where the server has closed
  bool send(std::string_view text);
  /// The next answer; nothing where the connection ends or `within` passes first.
  [[nodiscard]] std::optional<HttpReply> receive(
      bool has_body = true, std::chrono::milliseconds within = std::chrono::seconds(20));
  /// Puts bytes back that were read too early.
  void unread(const std::string& bytes) { received_.insert(0, bytes); }
  /// The next bytes, whatever they are.
  [[nodiscard]] std::optional<std::string> receive_bytes(std::size_t count,
                                                         std::chrono::milliseconds within);
  /// Whether the server closes (or resets) the connection, all it sent having been read.
  [[nodiscard]] bool is_closed_within(std::chrono::milliseconds time);
  void close_for_writing();
  /// Closes with a reset instead of a farewell.
  void reset();

  /// GET of a target, with further field lines, each ended by CRLF.
  [[nodiscard]] std::optional<HttpReply> get(const std::string& target,
                                             const std::string& field_lines = {});

 private:
  /// Reads some more. @return false at the end, or when the time has passed
  bool read_more(std::chrono::steady_clock::time_point until);

  int descriptor_ = -1;
  std::string received_;
};

}  // namespace slackwater::tests
