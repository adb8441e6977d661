#pragma once
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace slackwater::live {

/// What became of the moments of a sensor.
struct LooksMade {
  std::uint64_t moments = 0;  ///< that it was to look at
  std::uint64_t looks = 0;    ///< that it has seen
  std::uint64_t dropped = 0;  ///< a newer one came while the look before was not done
  std::uint64_t unseen = 0;   ///< it could not see: outside of its medium
  double sum_s = 0;           ///< of all looks: by the clock, from the moment until it was seen
  double worst_s = 0;
  [[nodiscard]] double mean_s() const noexcept {
    return looks == 0 ? 0 : sum_s / static_cast<double>(looks);
  }
};

/// Looks of several sensors, made one after the other on a thread of their own: whoever hands in
/// moments never waits for one. Of each sensor one moment waits; a newer one takes its place, and
/// the older one is dropped and counted. Of the sensors that wait the one that has waited longest
/// is next, whatever has taken whose place: none starves behind a slow one.
class LookThread {
 public:
  using WallClock = std::chrono::steady_clock;
  /// @throws std::exception where nothing is to be seen
  using Look = std::function<void()>;

  /// @param on_unseen  told of each sensor once, what kept it from seeing; on this thread
  LookThread(std::size_t sensors,
             std::function<void(std::size_t sensor, const std::string& why)> on_unseen);
  ~LookThread() { finish(); }
  LookThread(const LookThread&) = delete;
  LookThread& operator=(const LookThread&) = delete;

  /// The moment is now. For any thread.
  void hand_in(std::size_t sensor, Look look);
  /// Makes the looks that wait, and no more. From one thread.
  void finish();
  /// For any thread.
  [[nodiscard]] LooksMade made(std::size_t sensor) const;

 private:
  struct Waiting {
    Look look;
    WallClock::time_point since;
  };
  struct Sensor {
    std::optional<Waiting> waiting;
    std::uint64_t turn = 0;  ///< since which it waits; a newer moment keeps it
    LooksMade made;
  };
  void make_all();
  /// The one that waits longest; null: none does.
  [[nodiscard]] Sensor* next();

  std::function<void(std::size_t, const std::string&)> on_unseen_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::vector<Sensor> sensors_;
  std::uint64_t turns_ = 0;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace slackwater::live
