#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "data/bag/channel_table.h"
#include "data/bag/mcap_record.h"

namespace slackwater::bag {

/// Collects the schemas and channels of an MCAP file as they come, each as often as it stands
/// there. Damage is Error(invalid_input).
class McapDefinitions {
 public:
  void take_schema(ByteView content);
  /// The schema must have come before; without one a channel has no type.
  void take_channel(ByteView content);

  [[nodiscard]] const ChannelTable& channels() const noexcept { return table_; }
  /// Throws Error(invalid_input) where a channel is not CDR.
  void expect_all_cdr() const;

 private:
  struct Schema {
    std::string name;
    std::string definition;  ///< empty unless it is "ros2msg"
  };

  ChannelTable table_;
  std::map<std::uint16_t, Schema> schemas_;
  std::optional<std::pair<std::string, std::string>> not_cdr_;  ///< topic and encoding
};

}  // namespace slackwater::bag
