#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "api/door/live/topics/stream.h"
#include "data/bag/recording.h"

namespace slackwater::live {

/// Records a run in a bag, on a thread of its own: the run never waits for a disk. Where the disk
/// fails, or cannot keep up with 256 MiB of messages, that is told, the recording ends with what it
/// has and the run goes on without it. What is older than some two seconds outlives the death of
/// the process, in a pause too.
///
/// It leaves out hidden topics, as `ros2 bag record -a` does: those with a part of their name that
/// begins with '_'. The action's feedback is one, whose type is none that readers of bags know.
class RecordingOutlet final : public Outlet {
 public:
  /// @throws Error(invalid_input) where something lies at the path, Error(unavailable)
  RecordingOutlet(const std::filesystem::path& path,
                  std::function<void(const std::string&)> on_trouble);
  /// Completes it.
  ~RecordingOutlet() override;
  RecordingOutlet(const RecordingOutlet&) = delete;
  RecordingOutlet& operator=(const RecordingOutlet&) = delete;

  void open(const bag::Channel& channel, Direction direction) override;
  [[nodiscard]] bool wants(std::size_t channel) const override {
    return !has_failed_ && !is_hidden_[channel];
  }
  void publish(std::size_t channel, const dds::Stamp& stamp, const dds::Bytes& message) override;

  /// Writes all there is and completes the recording. @return messages recorded
  std::uint64_t close();
  [[nodiscard]] bool has_failed() const noexcept { return has_failed_; }

 private:
  struct Item {
    std::size_t channel = 0;
    std::int64_t time_ns = 0;
    dds::Bytes message;
  };
  void write_all();
  void fail(const std::string& why);

  std::filesystem::path path_;
  std::function<void(const std::string&)> on_trouble_;
  bag::Writer writer_;
  std::vector<bool> is_hidden_;  ///< of the channels; the run's thread's alone
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<bag::Channel> channels_;
  std::deque<Item> waiting_;
  std::size_t waiting_bytes_ = 0;
  bool is_over_ = false;
  std::atomic<bool> has_failed_{false};
  /// Of the channels, in the writer: nothing of those that are hidden. Its thread's alone.
  std::vector<std::optional<bag::ChannelId>> ids_;
  std::thread thread_;
};

}  // namespace slackwater::live
