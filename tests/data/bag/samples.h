#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "data/bag/bag.h"
#include "data/bag/recording.h"

namespace slackwater::bag::tests {

/// A message with all that a reader should give back.
struct Message {
  Channel channel;
  std::int64_t log_time_ns = 0;
  std::vector<std::uint8_t> payload;

  bool operator==(const Message&) const = default;
};

inline Channel level_channel() {
  return {"/site/tide_level", "std_msgs/msg/Float64", "float64 data\n", {true, true, 1}};
}

inline Channel wind_channel() {
  const std::string bar = std::string(80, '=') + "\n";
  return {"/site/wind",
          "geometry_msgs/msg/Vector3Stamped",
          "std_msgs/Header header\nVector3 vector\n" + bar +
              "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + bar +
              "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + bar +
              "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n",
          {false, false, 5}};
}

/// A Float64 in XCDR1, little endian.
inline std::vector<std::uint8_t> level_payload(double value) {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  bytes.resize(12);
  std::memcpy(bytes.data() + 4, &value, sizeof value);
  return bytes;
}

/// Bytes that no compressor makes small, the same for the same number.
inline std::vector<std::uint8_t> noise_payload(std::uint64_t number, std::size_t size) {
  std::vector<std::uint8_t> bytes{0, 1, 0, 0};
  bytes.resize(size);
  std::uint64_t state = number * 0x9E3779B97F4A7C15U + 1;
  for (std::size_t i = 4; i < size; ++i) {
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    bytes[i] = static_cast<std::uint8_t>(state >> 56U);
  }
  return bytes;
}

inline void write(Writer& writer, const Message& message) {
  writer.write(writer.add_channel(message.channel), message.log_time_ns, message.payload);
}

inline std::vector<Message> all_of(Bag& bag) {
  std::vector<Message> messages;
  while (const auto recorded = bag.next()) {
    messages.push_back({bag.channels().at(recorded->channel),
                        recorded->log_time_ns,
                        {recorded->payload.begin(), recorded->payload.end()}});
  }
  return messages;
}

inline std::vector<Message> all_in(const std::filesystem::path& path) {
  return all_of(*open_bag(path));
}

/// Twenty minutes of tide at 1 Hz with the wind every ten seconds.
inline std::vector<Message> some_messages(std::size_t count = 1200) {
  std::vector<Message> messages;
  for (std::size_t i = 0; i < count; ++i) {
    const auto time = static_cast<std::int64_t>(i) * 1'000'000'000 + 1'700'000'000'000'000'000;
    messages.push_back({level_channel(), time, level_payload(0.5 * static_cast<double>(i))});
    if (i % 10 == 0) messages.push_back({wind_channel(), time, noise_payload(i, 60)});
  }
  return messages;
}

}  // namespace slackwater::bag::tests
