#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "data/bag/bag.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests {

// The records of `slackwater live`, run as a program.

[[nodiscard]] inline std::string live_scenario() {
  return (source_folder() / "data/scenarios/live_square.yaml").string();
}

/// A message as it is in a record.
struct LiveMessage {
  std::string topic;
  std::int64_t log_time_ns = 0;
  std::vector<std::uint8_t> payload;
  bool operator==(const LiveMessage&) const = default;
};

[[nodiscard]] inline std::vector<LiveMessage> messages_of(const std::filesystem::path& record) {
  std::vector<LiveMessage> messages;
  const auto bag = bag::open_bag(record);
  while (const auto next = bag->next()) {
    messages.push_back({bag->channels()[next->channel].topic,
                        next->log_time_ns,
                        {next->payload.begin(), next->payload.end()}});
  }
  return messages;
}

/// How many a rosbag2 folder says are in its file, as a reader that is no program of ours would
/// learn it; 0 before it says anything.
[[nodiscard]] inline std::size_t messages_told(const std::filesystem::path& folder) {
  const std::string key = "message_count: ";
  std::ifstream file(folder / "metadata.yaml");
  for (std::string line; std::getline(file, line);)
    if (const auto at = line.find(key); at != std::string::npos)
      return std::stoul(line.substr(at + key.size()));
  return 0;
}

/// Each step has told the time, and none is missing. @return how many there are
inline std::size_t expect_even_clock(const std::vector<LiveMessage>& messages) {
  constexpr std::int64_t step_ns = 50'000'000;
  std::vector<std::int64_t> times_ns;
  for (const LiveMessage& message : messages)
    if (message.topic == "/clock") times_ns.push_back(message.log_time_ns);
  for (std::size_t i = 1; i < times_ns.size(); ++i)
    EXPECT_NEAR(static_cast<double>(times_ns[i] - times_ns[i - 1]), step_ns, 1000) << i;
  return times_ns.size();
}

}  // namespace slackwater::tests
