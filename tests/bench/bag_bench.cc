// A recording of twenty vehicles for a while: a million messages of 700 bytes on forty channels,
// written as a rosbag2 folder and as an MCAP file, and read back, each message compared. Half of a
// message's bytes are noise and half repeat, so that the compressor has work.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "data/bag/bag.h"
#include "data/bag/recording.h"
#include "tests/bench/bench_report.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr std::size_t message_bytes = 700;
constexpr std::size_t channels = 40;

/// Message by message, the same each time.
class MadeUpMessages {
 public:
  bag::Payload next() {
    for (std::size_t at = 4; at < message_bytes / 2; at += sizeof state_) {
      state_ ^= state_ << 13U;
      state_ ^= state_ >> 7U;
      state_ ^= state_ << 17U;
      std::memcpy(bytes_.data() + at, &state_, sizeof state_);
    }
    return bytes_;
  }

 private:
  std::uint64_t state_ = 88172645463325252U;
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(message_bytes, 7);
};

/// 2000 messages a second.
std::int64_t time_of(std::size_t message) { return static_cast<std::int64_t>(message) * 500'000; }

double elapsed_s(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

double record(const std::filesystem::path& path, std::size_t count) {
  MadeUpMessages made_up;
  const auto from = std::chrono::steady_clock::now();
  bag::Writer writer = bag::open_recording(path);
  std::vector<bag::ChannelId> ids;
  for (std::size_t i = 0; i < channels; ++i) {
    ids.push_back(writer.add_channel({"/vehicle_" + std::to_string(i) + "/odometry",
                                      "nav_msgs/msg/Odometry",
                                      "float64 made_up\n",
                                      {}}));
  }
  for (std::size_t i = 0; i < count; ++i)
    writer.write(ids[i % channels], time_of(i), made_up.next());
  writer.close();
  return elapsed_s(from);
}

/// How many messages came back as they were written, one after the other.
std::size_t read_back(const std::filesystem::path& path, double& seconds) {
  MadeUpMessages made_up;
  const auto from = std::chrono::steady_clock::now();
  const auto recording = bag::open_bag(path);
  std::size_t right = 0;
  while (const auto message = recording->next()) {
    const bag::Payload expected = made_up.next();
    if (message->channel != right % channels || message->log_time_ns != time_of(right) ||
        message->payload.size() != expected.size() ||
        std::memcmp(message->payload.data(), expected.data(), expected.size()) != 0)
      break;
    ++right;
  }
  seconds = elapsed_s(from);
  return right;
}

std::uintmax_t bytes_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return std::filesystem::file_size(path);
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path)) bytes += entry.file_size();
  return bytes;
}

void bench_both(BenchReport& report) {
  const std::size_t count = report.options().check_only ? 20'000 : 1'000'000;
  for (const char* name : {"rosbag2", "run.mcap"}) {
    const tests::TemporaryFolder folder;
    const double write_s = record(folder / name, count);
    double read_s = 0;
    const std::size_t right = read_back(folder / name, read_s);
    report.answer(std::string(name) + ", read back", right == count,
                  std::to_string(right) + " of " + std::to_string(count) + " messages, " +
                      std::to_string(bytes_in(folder / name) >> 20U) + " MiB on the disk");
    if (right != count || report.options().check_only) continue;
    const double messages = static_cast<double>(count);
    report.figure({std::string(name) + ", written",
                   "messages/s",
                   {messages / write_s},
                   std::nullopt,
                   "",
                   100'000});
    report.figure({std::string(name) + ", read and compared",
                   "messages/s",
                   {messages / read_s},
                   std::nullopt,
                   "",
                   100'000});
  }
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "bag", bench_both); }
