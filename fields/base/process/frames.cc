#include "fields/base/process/frames.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace slackwater {
namespace {

constexpr std::size_t head_bytes = 1 + sizeof(std::uint64_t);

bool write_all(int descriptor, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(descriptor, data, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    data += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool send(int descriptor, char kind, std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  std::string head(1, kind);
  head.append(reinterpret_cast<const char*>(&size), sizeof size);
  return write_all(descriptor, head.data(), head.size()) &&
         write_all(descriptor, bytes.data(), bytes.size());
}

}  // namespace

bool send_share(int descriptor, int permille) {
  return send(descriptor, 's', std::to_string(permille));
}
bool send_answer(int descriptor, std::string_view answer) { return send(descriptor, 'a', answer); }

void Told::take(std::string_view more, const std::function<void(double)>& on_share) {
  if (is_answered) return;
  bytes += more;
  std::size_t at = 0;
  while (bytes.size() - at >= head_bytes) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + at + 1, sizeof size);
    if (bytes.size() - at - head_bytes < size) break;
    if (bytes[at] == 'a') {
      bytes.erase(0, at + head_bytes);
      bytes.resize(size);
      answer = std::move(bytes);
      is_answered = true;
      bytes.clear();
      return;
    }
    const double share = std::strtod(bytes.substr(at + head_bytes, size).c_str(), nullptr) / 1000;
    if (on_share && bytes[at] == 's' && share >= 0 && share <= 1) on_share(share);
    at += head_bytes + size;
  }
  bytes.erase(0, at);
}

}  // namespace slackwater
