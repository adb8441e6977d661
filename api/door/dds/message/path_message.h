#pragma once
#include <fastcdr/Cdr.h>

#include <vector>

#include "api/door/dds/message/parts.h"

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// nav_msgs/msg/Path as clients send it. Read place by place: fastddsgen's type makes room for all
/// places of a count before it reads the first, a hundred times what the message has.
struct PathAsked {
  std::vector<twin::Triple<double>> places_m;  ///< NED

  /// @throws Error(invalid_input) for a path in another frame than `map`
  void deserialize(eprosima::fastcdr::Cdr& cdr);
};

}  // namespace slackwater::dds
