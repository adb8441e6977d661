#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/http/server.h"
#include "api/door/people/session_routes.h"
#include "session/session_generated.h"
#include "tests/support/websocket_client.h"

namespace slackwater::tests {

/// A run under way with a session and its server: the real ones. As fast as the clock of the wall
/// unless told otherwise; it ends with its owner.
class SessionUnderWay {
 public:
  struct Choice {
    double real_time_factor = 1;
    people::TokenBook book = people::TokenBook::drawn(UtcTime::max());
    std::function<void(const api::RunInHand&)> also{};
    std::function<void()> over{};                           ///< after the last step
    std::function<void(api::ScenarioWater&)> with_water{};  ///< changes it before the run
    std::string address = "127.0.0.1";
    /// Does the work where the server shall listen; absent: here.
    std::function<void(const std::function<void()>&)> where{};
  };
  explicit SessionUnderWay(const std::string& yaml) : SessionUnderWay(yaml, Choice{}) {}
  SessionUnderWay(const std::string& yaml, Choice choice);
  ~SessionUnderWay() { (void)ended(); }
  SessionUnderWay(const SessionUnderWay&) = delete;
  SessionUnderWay& operator=(const SessionUnderWay&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept { return server_->port(); }
  [[nodiscard]] const std::string& token(people::Role role) const;
  [[nodiscard]] people::Session& session() noexcept { return *session_; }
  /// Stops the run; what it left. Once.
  const api::ScenarioResult& ended();

 private:
  std::shared_ptr<people::Session> session_;
  people::TokenBook book_;
  std::unique_ptr<api::http::Server> server_;
  twin::RunControl control_;
  std::optional<api::ScenarioResult> result_;
  std::thread run_;
};

/// Of an answer of a session.
void expect_taken(const nlohmann::json& answer);
void expect_refused(const nlohmann::json& answer, const std::string& reason,
                    const std::string& words);

/// A scripted station at a raw socket.
class StationClient {
 public:
  StationClient(const SessionUnderWay& session, const std::string& token,
                const std::string& field_lines = {})
      : StationClient(session.port(), token, field_lines) {}
  StationClient(const ServerPlace& place, const std::string& token,
                const std::string& field_lines = {}, const std::string& session = "run");
  /// At a recording, which asks for no token.
  struct AtLog {
    std::uint16_t port = 0;
  };
  explicit StationClient(const AtLog& log, const std::string& field_lines = {});

  [[nodiscard]] int status() const { return socket_.handshake().status; }
  [[nodiscard]] const HttpReply& handshake() const { return socket_.handshake(); }
  /// Sends it with an id of its own. @return that
  int says(nlohmann::json message);
  bool says_text(const std::string& text) { return socket_.send_text(text); }
  /// Says it, and the answer to it.
  [[nodiscard]] nlohmann::json asks(nlohmann::json message);
  /// Hello; the welcome. @param is_brief  asks for frames with `moved`
  nlohmann::json hello(const std::string& name, bool is_brief = false);
  /// The first message of the kind from now on for which it is so; null: none came in time.
  [[nodiscard]] nlohmann::json told(const std::string& is,
                                    const std::function<bool(const nlohmann::json&)>& is_so = {},
                                    std::chrono::milliseconds within = std::chrono::seconds(20));
  /// Reads for a while. Frames are answered unless `says_saw` is false.
  void listen(std::chrono::milliseconds for_ms);
  /// The code of the close that comes.
  [[nodiscard]] int closed(std::chrono::milliseconds within = std::chrono::seconds(20));
  void hang_up() { socket_.connection().reset(); }

  /// On the clock of the session, as far as it was told.
  [[nodiscard]] std::int64_t clock() const;
  [[nodiscard]] std::int64_t number() { return ++number_; }
  /// A command with number and time.
  [[nodiscard]] nlohmann::json command(const std::string& what, int vehicle,
                                       nlohmann::json with = nlohmann::json::object());

  std::vector<std::string> frames;
  std::vector<nlohmann::json> messages;
  std::size_t received_bytes = 0;  ///< payloads of frames and messages, all of them
  std::size_t wire_bytes = 0;      ///< the same with the heads of RFC 6455
  bool says_saw = true;

 private:
  /// @return false: nothing came
  bool receive(std::chrono::milliseconds within);

  WebSocketClient socket_;
  int next_id_ = 1;
  std::int64_t number_ = 0, clock_ = 0;
  std::chrono::steady_clock::time_point clock_at_;
  int close_code_ = 0;
};

}  // namespace slackwater::tests
