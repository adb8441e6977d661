#pragma once
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <thread>

#include "api/door/people/kept_session.h"
#include "api/door/sessions/operator_file.h"
#include "twin/run/run_control.h"

namespace slackwater::sessions {

/// What a run is begun with.
struct HostedRunChoice {
  std::string id;  ///< of the session
  Offer offer;
  people::TokenBook book;
  std::filesystem::path store_folder;
  std::filesystem::path log;     ///< FILE.nc; empty: none
  std::string by;                ///< who begins it, for the server's log
  std::function<UtcTime()> now;  ///< the clock of the wall
};

/// A run with a session of people, on a thread of its own, from the reading of its scenario to its
/// log. What goes wrong ends it as failed and nothing else. It is in the hands of people alone: no
/// DDS, no bags, no viewers, so that it needs no `live::LiveRun`.
///
///     starting -> running, paused, stalled -> ending -> over
///         \______________\_____________________\______-> failed
class HostedRun {
 public:
  /// Begins it. @throws Error where the store cannot be written
  explicit HostedRun(HostedRunChoice choice);
  ~HostedRun();  ///< stops it and waits for its log
  HostedRun(const HostedRun&) = delete;
  HostedRun& operator=(const HostedRun&) = delete;

  // --- from any thread ---
  /// Asks it to end, paused or not, and returns at once.
  void stop() { control_.stop(); }
  /// Over or failed: its log, if any, is written, and its record filed.
  [[nodiscard]] bool has_ended() const;
  /// Returns once it has ended.
  void wait() const;
  [[nodiscard]] std::string state() const;
  /// Of `GET /sessions`.
  [[nodiscard]] nlohmann::json summary() const;
  [[nodiscard]] const std::string& id() const noexcept { return choice_.id; }
  [[nodiscard]] const std::shared_ptr<people::Session>& session() const noexcept {
    return kept_.session();
  }

 private:
  enum class End { not_yet, over, failed };
  void run() noexcept;
  void run_to_its_log();
  void ended(End how, const std::string& why);
  void tell(const std::string& trouble) const;

  HostedRunChoice choice_;
  UtcTime begun_;
  twin::RunControl control_;
  people::KeptSession kept_;
  mutable std::mutex mutex_;  ///< of the three below
  mutable std::condition_variable has_ended_;
  End end_ = End::not_yet;
  std::string why_;      ///< it failed
  std::jthread thread_;  ///< goes first
};

}  // namespace slackwater::sessions
