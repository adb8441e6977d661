#pragma once
#include <memory>
#include <vector>

#include "api/door/foxglove/broadcast.h"
#include "api/door/live/topics/stream.h"

namespace slackwater::live {

/// The messages of a run for people's viewers.
class ViewerOutlet final : public Outlet {
 public:
  explicit ViewerOutlet(std::shared_ptr<api::foxglove::Broadcast> broadcast)
      : broadcast_(std::move(broadcast)) {}
  void open(const bag::Channel& channel, Direction) override {
    is_clock_.push_back(channel.topic == "/clock");
    is_latched_.push_back(channel.quality.is_transient_local);
    ids_.push_back(broadcast_->advertise(channel));
  }
  [[nodiscard]] bool wants(std::size_t channel) const override {
    return is_latched_[channel] || is_clock_[channel] || broadcast_->is_watched(ids_[channel]);
  }
  void publish(std::size_t channel, const dds::Stamp& stamp, const dds::Bytes& message) override {
    const auto now_ns = static_cast<std::uint64_t>(dds::nanoseconds_of(stamp));
    if (is_clock_[channel]) broadcast_->set_time(now_ns);
    broadcast_->publish(ids_[channel], now_ns, message);
  }

 private:
  std::shared_ptr<api::foxglove::Broadcast> broadcast_;
  std::vector<api::foxglove::ChannelId> ids_;
  std::vector<bool> is_clock_, is_latched_;
};

}  // namespace slackwater::live
