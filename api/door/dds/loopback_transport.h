#pragma once
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// UDP that neither sends nor listens beyond this machine, and yet reaches the participants of this
/// machine that do: nodes of ROS 2 unless told otherwise. Those say that they are at an address of
/// a network card; the library takes that for out of bounds where loopback alone is allowed, and
/// drops it. Here it is 127.0.0.1, where they listen too.
class LoopbackTransportDescriptor final
    : public eprosima::fastdds::rtps::ChainingTransportDescriptor {
 public:
  LoopbackTransportDescriptor();
  [[nodiscard]] eprosima::fastdds::rtps::TransportInterface* create_transport() const override;
};

}  // namespace slackwater::dds
