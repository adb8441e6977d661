#include "data/bag/rosbag_metadata.h"

#include <sstream>

#include "data/bag/quality_yaml.h"
#include "fields/base/config.h"

namespace slackwater::bag {
namespace {

std::string times(const RosbagMetadata& metadata, const std::string& indent) {
  return indent + "duration:\n" + indent +
         "  nanoseconds: " + std::to_string(metadata.last_ns - metadata.first_ns) + "\n" + indent +
         "starting_time:\n" + indent +
         "  nanoseconds_since_epoch: " + std::to_string(metadata.first_ns) + "\n" + indent +
         "message_count: " + std::to_string(metadata.messages) + "\n";
}

}  // namespace

std::string metadata_yaml(const RosbagMetadata& metadata) {
  const std::string file = quoted_yaml(metadata.file);
  std::string yaml = "version: " + std::to_string(rosbag_metadata_version) +
                     "\nstorage_identifier: sqlite3\n" + times(metadata, "") +
                     "topics_with_message_count:" + (metadata.topics.empty() ? " []\n" : "\n");
  for (const RosbagMetadata::Topic& topic : metadata.topics) {
    yaml += "  - topic_metadata:\n      name: " + quoted_yaml(topic.channel.topic) +
            "\n      type: " + quoted_yaml(topic.channel.type) +
            "\n      serialization_format: cdr\n      offered_qos_profiles: " +
            quoted_yaml(yaml_of(topic.channel.quality)) +
            "\n    message_count: " + std::to_string(topic.messages) + "\n";
  }
  return yaml + "compression_format: \"\"\ncompression_mode: \"\"\nrelative_file_paths:\n  - " +
         file + "\nfiles:\n  - path: " + file + "\n" + times(metadata, "    ");
}

std::string metadata_file(const RosbagMetadata& metadata) {
  std::istringstream lines(metadata_yaml(metadata));
  std::string text = "rosbag2_bagfile_information:\n";
  for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  return text;
}

}  // namespace slackwater::bag
