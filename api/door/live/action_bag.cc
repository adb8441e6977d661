#include "api/door/live/action_bag.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "api/door/dds/message/definition.h"
#include "api/door/dds/message/vehicle_messages.h"
#include "api/door/live/action_teller.h"
#include "api/log/action_json.h"
#include "data/bag/recording.h"

namespace slackwater::live {

dds::Bytes message_of(const store::SessionAction& action) {
  return dds::text(
      api::action_json(action).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void write_action_bag(const std::filesystem::path& path,
                      std::span<const store::SessionAction> actions) {
  const std::string type = "std_msgs/msg/String";
  bag::Writer writer = bag::open_recording(path);
  const bag::ChannelId channel =
      writer.add_channel({action_topic, type, dds::definition_of(type), state_quality});
  for (const store::SessionAction& action : actions)
    writer.write(channel, std::chrono::nanoseconds(action.at.time_since_epoch()).count(),
                 message_of(action));
  writer.close();
}

}  // namespace slackwater::live
