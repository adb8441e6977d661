#include "api/door/live/action_teller.h"

#include <limits>

#include "api/door/dds/message/vehicle_messages.h"
#include "api/door/live/action_bag.h"

namespace slackwater::live {

ActionTeller::ActionTeller(Stream& stream, const RunPlace& place, std::shared_ptr<ActionPost> post,
                           std::span<const store::SessionAction> on_record)
    : stream_(stream), place_(place), post_(std::move(post)), left_(on_record) {
  if (post_ || !left_.empty())
    channel_ = stream_.open(action_topic, "std_msgs/msg/String", state_quality, Direction::heard);
}

void ActionTeller::tell(const store::SessionAction& action) {
  if (stream_.is_wanted(*channel_))
    stream_.publish(*channel_, dds::stamp_of(place_.epoch, action.time_s), message_of(action));
}

void ActionTeller::speak(double t_s) {
  if (!channel_) return;
  for (; !left_.empty() && left_.front().time_s < t_s; left_ = left_.subspan(1))
    tell(left_.front());
  if (!post_) return;
  for (const store::SessionAction& action : post_->take()) tell(action);
}

void ActionTeller::finish() { speak(std::numeric_limits<double>::infinity()); }

}  // namespace slackwater::live
