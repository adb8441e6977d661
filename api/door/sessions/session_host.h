#pragma once
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "api/door/sessions/hosted_run.h"
#include "api/door/sessions/operator_file.h"

namespace slackwater::sessions {

/// Why something is not done: the status of HTTP, and words.
struct Refused {
  int status = 400;
  std::string text;
};

/// The sessions of a server: those that may be begun, those under way, and the last ones that are
/// over. Thread-safe.
class SessionHost {
 public:
  /// How many that are over or failed are still listed.
  static constexpr std::size_t most_ended = 20;

  SessionHost(OperatorFile file, std::filesystem::path store_folder, std::function<UtcTime()> now);
  ~SessionHost() { stop(); }
  SessionHost(const SessionHost&) = delete;
  SessionHost& operator=(const SessionHost&) = delete;

  /// Begins those that begin with the server. @throws Error where the store cannot be written
  void begin_at_start();
  [[nodiscard]] std::size_t most_at_once() const noexcept { return file_.most_at_once; }
  /// Who may begin and end sessions with a token, or why it does not let him.
  [[nodiscard]] std::variant<people::Grant, Refused> supervisor_of(std::string_view token) const;
  /// Begins a run of an offer. @return the id of its session
  /// @param by  whoever begins it, for the server's log
  /// @throws Error where the store cannot be written
  [[nodiscard]] std::variant<std::string, Refused> begin(const std::string& offer,
                                                         const std::string& by);
  /// Asks a run to end. @return its state @throws Error(not_found)
  std::string end(const std::string& id, const std::string& by);
  /// Begins no more, ends all, and waits for their logs.
  void stop();

  /// The answer to `GET /sessions`.
  [[nodiscard]] nlohmann::json list() const;
  /// One of its sessions. @throws Error(not_found)
  [[nodiscard]] nlohmann::json summary(const std::string& id) const;
  /// @throws Error(not_found) that names what there is
  [[nodiscard]] std::shared_ptr<people::Session> find(const std::string& id) const;

 private:
  using Run = std::shared_ptr<HostedRun>;
  [[nodiscard]] Run run_of(const std::string& id) const;
  [[nodiscard]] std::size_t under_way() const;
  [[nodiscard]] std::string next_id(const std::string& offer);
  [[nodiscard]] std::filesystem::path log_of(const std::string& id) const;
  void forget_the_oldest();

  const OperatorFile file_;
  const std::filesystem::path store_folder_;
  const std::function<UtcTime()> now_;

  std::mutex begin_mutex_;  ///< one begins at a time, and lists and sockets need not wait for it
  std::map<std::string, int> begun_;  ///< how often, by offer

  mutable std::mutex mutex_;
  std::deque<Run> runs_;  ///< in the order in which they began
  bool is_stopping_ = false;
};

}  // namespace slackwater::sessions
