#pragma once
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "api/door/people/connection.h"
#include "api/door/people/playback/logged_run.h"
#include "api/door/people/playback/logged_surround.h"
#include "api/door/people/playback/play_head.h"
#include "api/door/people/ticker.h"
#include "fields/base/constants.h"

namespace slackwater::people {

/// The log of a run, watched again over the wire of a session (api/docs/session_wire.md). Nobody
/// has a seat: each station looks on, with a play head of its own. The log is read before; what is
/// kept beside it is where each station is in it.
class Playback final : public api::http::WebSocketHandler {
 public:
  static constexpr const char* id = "log";

  explicit Playback(LoggedRun run, FoundSurround found);
  ~Playback() override;
  /// Tells the stations that it is over, and closes them.
  void end();
  /// Until they have all gone, or the time is over: a server that stops cuts off what is unsaid.
  void wait_for_farewells(std::chrono::milliseconds most);

  /// Of `GET /sessions`.
  [[nodiscard]] nlohmann::json summary() const;
  [[nodiscard]] const LoggedRun& run() const noexcept { return run_; }

  // --- stations ---
  [[nodiscard]] std::vector<std::string> protocols() const override;
  /// No token is asked for, so whoever asks must be of this machine, by its host too: DNS may name
  /// it as a stranger's own.
  [[nodiscard]] std::optional<api::http::Response> refusal(
      const api::http::Request& request) const override;
  void opened(const std::shared_ptr<api::http::WebSocket>& socket,
              const api::http::Request& request, const std::string& protocol) override;
  void received_text(api::http::WebSocket& socket, std::string_view text) override;
  void received_bytes(api::http::WebSocket& socket, std::span<const std::uint8_t> bytes) override;
  void closed(api::http::WebSocket& socket) override;

 private:
  using Socket = const api::http::WebSocket*;
  struct Viewer : Connection {
    Viewer(double from_s, double to_s) : head(from_s, to_s) {}
    PlayHead head;
    bool has_said_hello = false;
    bool is_frame_due = false;      ///< though it does not play
    std::size_t actions_told = 0;   ///< that were before its head
    std::vector<StatusPlace> told;  ///< of each vehicle
    nlohmann::json run_told;
    std::vector<std::uint16_t> there;  ///< vehicles of its last frame
    nlohmann::json weather_told, traffic_told;
    double around_at_s = constants::nan;  ///< of the run, when it was told these; nan: tell anew
    Milliseconds around_at = 0;           ///< likewise, of the clock
  };
  /// What is about the vehicles; null: nobody knows.
  struct Around {
    nlohmann::json weather, traffic;
  };
  [[nodiscard]] Milliseconds clock() const;
  void tick();
  void heard(Viewer& viewer, const StationSays& says);
  void welcome(Viewer& viewer, const std::string& name);
  void play(Viewer& viewer, double rate);
  void seek(Viewer& viewer, double time_s);
  void show(Viewer& viewer);
  void tell_vehicles(Viewer& viewer, double at_s);
  void tell_run(Viewer& viewer);
  void send_frame(Viewer& viewer, double at_s);
  [[nodiscard]] nlohmann::json place_facts() const;
  [[nodiscard]] std::string weather_by(double at_s) const;
  [[nodiscard]] Around around_at(double at_s);
  void tell_around(Viewer& viewer, double at_s);
  [[nodiscard]] nlohmann::json run_json(const Viewer& viewer) const;
  [[nodiscard]] nlohmann::json vehicle_facts(std::size_t vehicle) const;
  [[nodiscard]] nlohmann::json status_then(std::size_t vehicle, const StatusPlace& place) const;
  [[nodiscard]] nlohmann::json helm_then(std::size_t vehicle, const StatusPlace& place) const;
  [[nodiscard]] std::uint64_t number_of_last(std::size_t actions) const;

  const LoggedRun run_;
  FoundSurround found_;   ///< `at` leads the weather in it
  nlohmann::json facts_;  ///< that never change: of the welcome
  std::chrono::steady_clock::time_point began_;

  std::mutex mutex_;
  std::condition_variable gone_;
  std::map<Socket, Viewer> viewers_;
  bool is_over_ = false;

  Ticker ticker_;  ///< goes first
};

}  // namespace slackwater::people
