#include "api/door/dds/message/log_message.h"

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/parts.h"
#include "rcl_interfaces.h"

namespace slackwater::dds {

Bytes warning_message(const Stamp& stamp, const std::string& node, const std::string& text) {
  constexpr std::uint8_t warning = 30;
  rcl_interfaces::msg::Log message;
  message.stamp(time_message(stamp));
  message.level(warning);
  message.name(node);
  message.msg(text);
  return encoded(message);
}

}  // namespace slackwater::dds
