#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "api/door/http/exchange.h"
#include "api/door/http/request_reader.h"
#include "api/door/http/router.h"
#include "api/door/http/websocket.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::api::http;
using Progress = RequestReader::Progress;

/// Agrees on a sub-protocol; here nothing is said over it.
class Deaf final : public WebSocketHandler {
 public:
  [[nodiscard]] std::vector<std::string> protocols() const override { return {"a", "b"}; }
  void opened(const std::shared_ptr<WebSocket>&, const Request&, const std::string&) override {}
  void received_text(WebSocket&, std::string_view) override {}
  void received_bytes(WebSocket&, std::span<const std::uint8_t>) override {}
  void closed(WebSocket&) override {}
};

/// A router with each kind of segment.
const Handler& handler() {
  static const Handler router = [] {
    Router routes;
    routes.add("GET", "/echo/{word}", [](const Request&, const PathParameters& path) {
      Response response;
      response.media_type = "text/plain";
      response.body = std::string(2000, 'x') + path.at("word");
      return response;
    });
    routes.add("POST", "/write", [](const Request& request) {
      Response response;
      response.body = request.body;
      return response;
    });
    routes.add("GET", "/ws", websocket_route(std::make_shared<Deaf>()));
    return routes;
  }();
  return router;
}

void check_reply(const Reply& reply) {
  fuzz::claim(reply.head.starts_with("HTTP/1.1 "), "an answer without a status line");
  fuzz::claim(reply.head.find("\r\n\r\n") == reply.head.size() - 4, "a header split in two");
  fuzz::claim(reply.status != 500, "a request that makes the server fail");
}

/// What the bytes of a connection come to, fed in pieces: the status of each answer.
std::vector<int> statuses_of(std::string_view bytes, std::size_t piece) {
  static const ServerOptions options;
  static const Exchange exchange(options, handler());
  RequestReader reader(options.limits);
  std::vector<int> statuses;
  while (!bytes.empty()) {
    const auto room = reader.room();
    const std::size_t n = std::min({room.size(), piece, bytes.size()});
    std::copy_n(bytes.begin(), n, room.begin());
    reader.received(n);
    bytes.remove_prefix(n);
    Progress progress = reader.advance();
    for (; progress == Progress::complete; progress = reader.advance()) {
      Arrival arrival = reader.take();
      arrival.peer_is_loopback = true;
      const auto answer = exchange.answer(std::move(arrival));
      const auto* reply = std::get_if<Reply>(&answer);
      fuzz::claim(reply != nullptr, "a handler that is quick has no answer");
      check_reply(*reply);
      statuses.push_back(reply->status);
      if (reply->successor) return statuses;  // what follows is no HTTP
    }
    if (progress != Progress::refused) continue;
    const Reply reply = exchange.refusal(reader.refusal().status, reader.refusal().detail);
    check_reply(reply);
    fuzz::claim(!reply.keep_alive, "a connection goes on after bytes that are no request");
    return statuses;
  }
  return statuses;
}

}  // namespace

/// The bytes of a connection: answers are well formed, and the same however the bytes are cut. Only
/// an error may show later in small pieces, where a header is not looked at before it has ended.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz::text_of(data, size);
  fuzz::accepts([&] {
    const std::vector<int> whole = statuses_of(bytes, 1 << 14);
    const std::vector<int> pieces = statuses_of(bytes, 7);
    fuzz::claim(whole.size() <= pieces.size() + 1, "an answer is lost in small pieces");
    fuzz::claim(
        pieces.size() <= whole.size() && std::equal(pieces.begin(), pieces.end(), whole.begin()),
        "the answers depend on how the bytes are cut");
  });
  return 0;
}
