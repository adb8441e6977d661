#include "tests/support/http_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace slackwater::tests {
namespace {

using std::chrono::steady_clock;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

HttpReply parse_head(const std::string& head) {
  HttpReply reply;
  if (head.rfind("HTTP/1.1 ", 0) != 0) throw std::runtime_error("no status line: " + head);
  reply.status = std::stoi(head.substr(9, 3));
  std::size_t from = head.find("\r\n") + 2;
  while (from < head.size()) {
    const std::size_t end = head.find("\r\n", from);
    const std::size_t colon = head.find(": ", from);
    if (end == std::string::npos || colon == std::string::npos || colon > end) break;
    reply.fields[lower(head.substr(from, colon - from))] = head.substr(colon + 2, end - colon - 2);
    from = end + 2;
  }
  return reply;
}

}  // namespace

HttpClient::HttpClient(const ServerPlace& place, int receive_buffer_bytes)
    : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_buffer_bytes > 0) {
    ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &receive_buffer_bytes,
                 sizeof receive_buffer_bytes);
  }
  const auto at = [](const char* address, std::uint16_t port) {
    sockaddr_in found{};
    found.sin_family = AF_INET;
    found.sin_port = htons(port);
    ::inet_pton(AF_INET, address, &found.sin_addr);
    return found;
  };
  if (place.from != nullptr) {
    const sockaddr_in own = at(place.from, 0);
    if (::bind(descriptor_, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) {
      ::close(descriptor_);
      throw std::runtime_error("cannot come from " + std::string(place.from));
    }
  }
  const sockaddr_in address = at(place.address, place.port);
  if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ::close(descriptor_);
    throw std::runtime_error("cannot connect to port " + std::to_string(place.port));
  }
}

HttpClient::~HttpClient() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

HttpClient::HttpClient(HttpClient&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), received_(std::move(other.received_)) {}

bool HttpClient::send(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL);
    if (n <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool HttpClient::read_more(steady_clock::time_point until) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(until - steady_clock::now()).count();
  pollfd waiting{descriptor_, POLLIN, 0};
  if (::poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(0, left))) <= 0) return false;
  std::array<char, 65536> bytes{};
  const ssize_t n = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
  if (n <= 0) return false;
  received_.append(bytes.data(), static_cast<std::size_t>(n));
  return true;
}

std::optional<HttpReply> HttpClient::receive(bool has_body, std::chrono::milliseconds within) {
  const auto until = steady_clock::now() + within;
  std::size_t head_end = std::string::npos;
  while ((head_end = received_.find("\r\n\r\n")) == std::string::npos) {
    if (!read_more(until)) return std::nullopt;
  }
  HttpReply reply = parse_head(received_.substr(0, head_end + 2));
  received_.erase(0, head_end + 4);
  const std::string length = reply.field("content-length");
  const std::size_t bytes = has_body && !length.empty() ? std::stoul(length) : 0;
  while (received_.size() < bytes) {
    if (!read_more(until)) return std::nullopt;
  }
  reply.body = received_.substr(0, bytes);
  received_.erase(0, bytes);
  return reply;
}

std::optional<std::string> HttpClient::receive_bytes(std::size_t count,
                                                     std::chrono::milliseconds within) {
  const auto until = steady_clock::now() + within;
  while (received_.size() < count) {
    if (!read_more(until)) return std::nullopt;
  }
  std::string bytes = received_.substr(0, count);
  received_.erase(0, count);
  return bytes;
}

bool HttpClient::is_closed_within(std::chrono::milliseconds time) {
  const auto until = steady_clock::now() + time;
  while (read_more(until)) {
  }
  return steady_clock::now() < until;
}

void HttpClient::close_for_writing() { ::shutdown(descriptor_, SHUT_WR); }

void HttpClient::reset() {
  const linger at_once{1, 0};
  ::setsockopt(descriptor_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  ::close(std::exchange(descriptor_, -1));
}

std::optional<HttpReply> HttpClient::get(const std::string& target,
                                         const std::string& field_lines) {
  if (!send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n" + field_lines + "\r\n")) {
    return std::nullopt;
  }
  return receive();
}

}  // namespace slackwater::tests
