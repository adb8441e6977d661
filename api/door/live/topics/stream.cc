#include "api/door/live/topics/stream.h"

#include <algorithm>

#include "api/door/dds/message/definition.h"

namespace slackwater::live {

void Stream::add(std::shared_ptr<Outlet> outlet) {
  for (std::size_t i = 0; i < channels_.size(); ++i) outlet->open(channels_[i], directions_[i]);
  outlet->opened();
  outlets_.push_back(std::move(outlet));
}

Stream::ChannelId Stream::open(const std::string& topic, const std::string& type,
                               const bag::Quality& quality, Direction direction) {
  channels_.push_back({topic, type, dds::definition_of(type), quality});
  directions_.push_back(direction);
  for (const auto& outlet : outlets_) outlet->open(channels_.back(), direction);
  return channels_.size() - 1;
}

void Stream::opened() {
  for (const auto& outlet : outlets_) outlet->opened();
}

bool Stream::is_wanted(ChannelId channel) const {
  return std::any_of(outlets_.begin(), outlets_.end(),
                     [&](const auto& outlet) { return outlet->wants(channel); });
}

void Stream::publish(ChannelId channel, const dds::Stamp& stamp, const dds::Bytes& message) {
  for (const auto& outlet : outlets_)
    if (outlet->wants(channel)) outlet->publish(channel, stamp, message);
}

}  // namespace slackwater::live
