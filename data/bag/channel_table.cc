#include "data/bag/channel_table.h"

#include "fields/base/error.h"

namespace slackwater::bag {

std::size_t ChannelTable::add(const Channel& channel) {
  // No name holds a line break: the two are told apart.
  const auto [known, is_new] =
      by_name_.try_emplace(channel.topic + "\n" + channel.type, channels_.size());
  if (is_new) {
    channels_.push_back(channel);
  } else if (Channel& before = channels_[known->second]; before.definition.empty()) {
    before.definition = channel.definition;
  }
  return known->second;
}

void expect_cdr(const std::string& topic, const std::string& encoding) {
  if (encoding == "cdr") return;
  throw Error(ErrorKind::invalid_input, "messages of topic " + topic.substr(0, 256) +
                                            " are encoded as '" + encoding.substr(0, 40) +
                                            "', and only 'cdr' is read; leave that topic out when "
                                            "recording, or convert the file");
}

}  // namespace slackwater::bag
