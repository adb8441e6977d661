#pragma once
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// The channels of a recording, each topic and type once, and by which ids the recording knows
/// them.
class ChannelTable {
 public:
  /// Where the channel stands. One that was there already keeps its quality, and takes the
  /// definition if it had none.
  std::size_t add(const Channel& channel);
  void name(std::int64_t id, std::size_t channel) { channel_of_id_[id] = channel; }
  [[nodiscard]] const std::size_t* find(std::int64_t id) const {
    const auto found = channel_of_id_.find(id);
    return found == channel_of_id_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const std::vector<Channel>& channels() const noexcept { return channels_; }

 private:
  std::vector<Channel> channels_;
  std::unordered_map<std::string, std::size_t> by_name_;
  std::unordered_map<std::int64_t, std::size_t> channel_of_id_;
};

/// Throws Error(invalid_input) unless messages of the topic are CDR.
void expect_cdr(const std::string& topic, const std::string& encoding);

}  // namespace slackwater::bag
