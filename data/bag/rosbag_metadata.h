#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// What metadata.yaml says of a recording in one file.
struct RosbagMetadata {
  struct Topic {
    Channel channel;
    std::uint64_t messages = 0;
  };
  std::string file;  ///< within the folder
  std::vector<Topic> topics;
  std::uint64_t messages = 0;
  std::int64_t first_ns = 0;  ///< log time of the earliest message; 0 where there is none
  std::int64_t last_ns = 0;
};

/// The version of metadata.yaml that is written: read by Galactic and all that came after it.
inline constexpr int rosbag_metadata_version = 5;

/// As it stands in the database's table `metadata`: the value of "rosbag2_bagfile_information".
[[nodiscard]] std::string metadata_yaml(const RosbagMetadata& metadata);
/// As it stands in metadata.yaml.
[[nodiscard]] std::string metadata_file(const RosbagMetadata& metadata);

}  // namespace slackwater::bag
