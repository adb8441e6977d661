#include "api/door/live/topics/recording_outlet.h"

#include <chrono>
#include <exception>

namespace slackwater::live {
namespace {

constexpr std::size_t most_waiting_bytes = 256U << 20U;
constexpr std::chrono::seconds quiet_time{1};

bool is_hidden(const std::string& topic) { return topic.find("/_") != std::string::npos; }

}  // namespace

RecordingOutlet::RecordingOutlet(const std::filesystem::path& path,
                                 std::function<void(const std::string&)> on_trouble)
    : path_(path),
      on_trouble_(std::move(on_trouble)),
      writer_(bag::open_recording(path)),
      thread_([this] { write_all(); }) {}

RecordingOutlet::~RecordingOutlet() { (void)close(); }

void RecordingOutlet::open(const bag::Channel& channel, Direction) {
  is_hidden_.push_back(is_hidden(channel.topic));
  const std::lock_guard lock(mutex_);
  channels_.push_back(channel);
}

void RecordingOutlet::publish(std::size_t channel, const dds::Stamp& stamp,
                              const dds::Bytes& message) {
  if (is_hidden_[channel]) return;
  {
    const std::lock_guard lock(mutex_);
    if (waiting_bytes_ <= most_waiting_bytes) {
      waiting_bytes_ += message.size();
      waiting_.push_back({channel, dds::nanoseconds_of(stamp), message});
      return;
    }
  }
  fail("the disk does not keep up: 256 MiB are waiting");
}

void RecordingOutlet::fail(const std::string& why) {
  if (has_failed_.exchange(true)) return;
  if (on_trouble_) {
    on_trouble_("the recording " + path_.string() +
                " ends here, the run goes on without it: " + why);
  }
}

/// A batch of what came in every few milliseconds, so that the run wakes nobody for each message.
void RecordingOutlet::write_all() {
  std::deque<Item> batch;
  std::vector<bag::Channel> channels;
  auto said_last = std::chrono::steady_clock::now();
  for (bool is_over = false; !is_over;) {
    {
      std::unique_lock lock(mutex_);
      came_.wait_for(lock, std::chrono::milliseconds(20), [&] { return is_over_; });
      is_over = is_over_;
      batch.swap(waiting_);
      waiting_bytes_ = 0;
      channels.assign(channels_.begin() + static_cast<std::ptrdiff_t>(ids_.size()),
                      channels_.end());
    }
    try {
      if (!has_failed_) {
        for (const bag::Channel& channel : channels) {
          ids_.emplace_back();
          if (!is_hidden(channel.topic)) ids_.back() = writer_.add_channel(channel);
        }
        for (const Item& item : batch)
          writer_.write(*ids_[item.channel], item.time_ns, item.message);
        const auto now = std::chrono::steady_clock::now();
        if (!batch.empty()) said_last = now;
        // The writer lets go of a batch with a message that comes later: in a pause none does.
        if (now - said_last >= quiet_time) {
          writer_.flush();
          said_last = now;
        }
      }
      if (is_over) writer_.close();
    } catch (const std::exception& e) {
      fail(e.what());
    }
    batch.clear();
  }
}

std::uint64_t RecordingOutlet::close() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  came_.notify_one();
  if (thread_.joinable()) thread_.join();
  return writer_.messages();
}

}  // namespace slackwater::live
