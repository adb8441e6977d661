#pragma once
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::api::desk {

enum class JobState { waiting, flying, done, cancelled, failed };
[[nodiscard]] std::string_view name_of(JobState state) noexcept;

/// A rehearsal that somebody asked for over HTTP.
struct MissionAsked {
  std::string mission;              ///< YAML
  std::vector<std::string> starts;  ///< UTC times; empty: the mission's
  std::size_t members = 0;          ///< 0: as issued
};

/// Rehearsals one after the other, one a core: who submits one is given a number to ask by. The
/// same question about the same store is flown once. Results stay until there are too many, or the
/// program ends; nothing of them is in the store. Thread-safe.
class MissionJobs {
 public:
  MissionJobs(std::filesystem::path store_folder, std::filesystem::path data_folder,
              std::size_t at_once);
  ~MissionJobs();  ///< ends what is flying
  MissionJobs(const MissionJobs&) = delete;
  MissionJobs& operator=(const MissionJobs&) = delete;

  /// @return its id. @throws Error(unavailable) where too many are waiting
  [[nodiscard]] std::string submit(MissionAsked asked);
  /// @throws Error(not_found)
  [[nodiscard]] nlohmann::json job(const std::string& id) const;
  [[nodiscard]] nlohmann::json jobs() const;
  /// Of one that is waiting or flying; of any other nothing changes. @throws Error(not_found)
  nlohmann::json cancel(const std::string& id);

 private:
  struct Job {
    std::string id;
    MissionAsked asked;
    JobState state = JobState::waiting;
    double share = 0;
    std::string why;  ///< it failed
    std::shared_ptr<const nlohmann::json> result;
    bool is_unwanted = false;
  };
  void work();
  void fly(const std::shared_ptr<Job>& job);
  void forget_old();
  [[nodiscard]] std::shared_ptr<Job> find(const std::string& id) const;
  [[nodiscard]] nlohmann::json told(const Job& job, bool with_result) const;

  std::filesystem::path store_folder_, data_folder_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<Job>> all_;  ///< by age
  bool is_over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace slackwater::api::desk
