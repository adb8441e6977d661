#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "data/bag/channel.h"

namespace slackwater::live {

/// What the run tells, or what it was told by clients: that is recorded, and nobody is told again.
enum class Direction { told, heard };

/// Where the messages of a run go: a DDS domain, a recording, viewers. Its members are called from
/// the thread of the run alone, and never make it wait.
class Outlet {
 public:
  virtual ~Outlet() = default;
  /// Channels are numbered as they come, from 0.
  virtual void open(const bag::Channel& channel, Direction direction) = 0;
  /// Whether a message now would reach anybody.
  [[nodiscard]] virtual bool wants(std::size_t channel) const = 0;
  virtual void publish(std::size_t channel, const dds::Stamp& stamp, const dds::Bytes& message) = 0;
  /// Once all channels that there are now are open.
  virtual void opened() {}
};

/// All that a run tells, once encoded, for all outlets alike.
class Stream {
 public:
  using ChannelId = std::size_t;

  /// It is told of the channels that are open already, not of what was said on them.
  void add(std::shared_ptr<Outlet> outlet);
  /// @param type  of ROS: "nav_msgs/msg/Odometry"
  ChannelId open(const std::string& topic, const std::string& type, const bag::Quality& quality,
                 Direction direction = Direction::told);
  void opened();

  [[nodiscard]] bool is_wanted(ChannelId channel) const;
  void publish(ChannelId channel, const dds::Stamp& stamp, const dds::Bytes& message);

  [[nodiscard]] const std::vector<bag::Channel>& channels() const noexcept { return channels_; }

 private:
  std::vector<bag::Channel> channels_;
  std::vector<Direction> directions_;
  std::vector<std::shared_ptr<Outlet>> outlets_;
};

/// Of the table of names in api/docs/dds.md.
inline constexpr bag::Quality state_quality{true, false, 10};
inline constexpr bag::Quality latched_quality{true, true, 1};
inline constexpr bag::Quality sensor_quality{true, false, 5};
inline constexpr bag::Quality clock_quality{false, false, 1};
inline constexpr bag::Quality command_quality{true, false, 1};

}  // namespace slackwater::live
