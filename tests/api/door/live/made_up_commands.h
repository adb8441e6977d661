#pragma once
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "api/door/dds/message/bytes.h"
#include "data/bag/recording.h"

namespace slackwater::tests {

// Bags of commands, as somebody may have recorded them.

/// geometry_msgs/msg/Twist: six numbers behind the encapsulation header.
[[nodiscard]] inline dds::Bytes twist(double surge_m_s, double yaw_rate_rad_s) {
  dds::Bytes bytes(52);
  bytes[1] = 1;
  std::memcpy(bytes.data() + 4, &surge_m_s, 8);
  std::memcpy(bytes.data() + 44, &yaw_rate_rad_s, 8);
  return bytes;
}

[[nodiscard]] inline std::int64_t ns_of(double t_s) {
  return 1'700'000'000'000'000'000 + std::llround(1e9 * t_s);
}

/// A bag that begins with a clock, and has `topic` from 2 to 4 s, ten times a second.
/// @return bytes of the file when half of the commands were written: all to 3 s
inline std::uintmax_t write_commands(const std::filesystem::path& path, const std::string& topic,
                                     const dds::Bytes& message) {
  bag::Writer writer = bag::open_recording(path);
  const auto clock = writer.add_channel({"/clock", "rosgraph_msgs/msg/Clock", "", {}});
  const auto commands = writer.add_channel({topic, "geometry_msgs/msg/Twist", "", {}});
  writer.write(clock, ns_of(0), dds::Bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  for (int i = 0; i <= 10; ++i) writer.write(commands, ns_of(2 + 0.1 * i), message);
  writer.flush();
  const std::uintmax_t half =
      std::filesystem::is_directory(path) ? 0 : std::filesystem::file_size(path);
  for (int i = 11; i <= 20; ++i) writer.write(commands, ns_of(2 + 0.1 * i), message);
  writer.close();
  return half;
}

inline std::filesystem::path bag_of_commands(const std::filesystem::path& path,
                                             const std::string& topic, const dds::Bytes& message) {
  write_commands(path, topic, message);
  return path;
}

/// The same as an MCAP file, its second half not as it was written: the end tells of it as if
/// nothing were amiss.
inline std::filesystem::path bag_damaged_in_its_middle(const std::filesystem::path& path,
                                                       const std::string& topic,
                                                       const dds::Bytes& message) {
  const std::uintmax_t half = write_commands(path, topic, message);
  constexpr std::uintmax_t head_of_chunk = 60;
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(half + head_of_chunk));
  file.write("damage", 6);
  return path;
}

}  // namespace slackwater::tests
