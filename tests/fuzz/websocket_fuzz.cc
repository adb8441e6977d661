#include <algorithm>
#include <string>
#include <vector>

#include "api/door/foxglove/client_request.h"
#include "api/door/http/frame_reader.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::api;
using Kind = http::Incoming::Kind;

constexpr std::size_t message_bytes = 300;  // small, so that it is met

/// What a viewer is told about a text that it sent.
void check_text(const std::string& text) {
  fuzz::claim(http::is_utf8(text), "a text that is not UTF-8");
  const foxglove::ClientRequest request = foxglove::client_request(text);
  fuzz::claim(request.statuses.size() <= 5, "a flood of statuses");
  for (const foxglove::Status& status : request.statuses) {
    fuzz::claim(!status.message.empty() && status.message.size() < 400,
                "a status that says little");
    fuzz::claim(http::is_utf8(foxglove::status_text(status.level, status.message)),
                "a status that cannot be sent");
  }
  fuzz::claim(!request.subscribe.empty() || !request.unsubscribe.empty() ||
                  !request.statuses.empty() || text.find("[]") != std::string::npos ||
                  text.find_first_of(" \t\r\n") != std::string::npos,
              "a request that is neither followed nor answered");
}

/// All that the bytes come to, fed in pieces.
std::vector<http::Incoming> read(std::string_view bytes, std::size_t piece) {
  http::FrameReader reader(message_bytes);
  std::vector<http::Incoming> all;
  while (!bytes.empty()) {
    const auto room = reader.room();
    const std::size_t n = std::min({room.size(), piece, bytes.size()});
    std::copy_n(bytes.begin(), n, room.begin());
    reader.received(n);
    bytes.remove_prefix(n);
    while (auto incoming = reader.next()) all.push_back(std::move(*incoming));
  }
  return all;
}

void check_whole(const http::Incoming& incoming) {
  fuzz::claim(incoming.bytes.size() <= message_bytes, "a message beyond the limit");
  if (incoming.kind == Kind::text) check_text(incoming.bytes);
  if (incoming.kind == Kind::close || incoming.kind == Kind::failed) {
    fuzz::claim(incoming.code >= 1000 && incoming.code < 5000, "a code that may not be sent");
    fuzz::claim(http::close_frame(incoming.code, incoming.bytes).size() <= 127, "a long farewell");
  }
}

}  // namespace

/// The bytes of a client after its handshake, and the same as one text of a viewer.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text_of(data, size);
  fuzz::accepts([&] {
    const auto whole = read(bytes, 1 << 14);
    const auto pieces = read(bytes, 3);
    const bool are_same = std::equal(
        whole.begin(), whole.end(), pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
          return a.kind == b.kind && a.bytes == b.bytes && a.code == b.code;
        });
    fuzz::claim(are_same, "the messages depend on how the bytes are cut");
    for (std::size_t i = 0; i < whole.size(); ++i) {
      check_whole(whole[i]);
      fuzz::claim(whole[i].kind != Kind::failed || i + 1 == whole.size(), "more after a failure");
    }
    if (http::is_utf8(bytes)) check_text(std::string(bytes));
  });
  return 0;
}
