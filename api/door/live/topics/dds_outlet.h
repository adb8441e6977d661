#pragma once
#include <optional>

#include "api/door/dds/participant.h"
#include "api/door/live/topics/stream.h"

namespace slackwater::live {

/// The messages of a run on a DDS domain.
class DdsOutlet final : public Outlet {
 public:
  explicit DdsOutlet(dds::Participant& participant) : participant_(participant) {}
  void open(const bag::Channel& channel, Direction direction) override {
    std::optional<dds::Participant::WriterId> writer;
    if (direction == Direction::told) writer = participant_.publish_on(channel);
    writers_.push_back(writer);
  }
  [[nodiscard]] bool wants(std::size_t channel) const override {
    return writers_[channel] && participant_.is_heard(*writers_[channel]);
  }
  void publish(std::size_t channel, const dds::Stamp&, const dds::Bytes& message) override {
    participant_.send(*writers_[channel], message);
  }
  void opened() override { participant_.announce(); }

 private:
  dds::Participant& participant_;
  std::vector<std::optional<dds::Participant::WriterId>>
      writers_;  ///< of each channel; heard: none
};

}  // namespace slackwater::live
