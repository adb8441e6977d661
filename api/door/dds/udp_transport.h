#pragma once
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>

#include <memory>

#include "api/door/dds/intake/intake.h"
#include "api/door/dds/participant.h"

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// UDP of which the library hears what an intake lets in.
///
/// On loopback it neither sends nor listens beyond this machine, and yet reaches the participants
/// of this machine that do: nodes of ROS 2 unless told otherwise. Those say that they are at an
/// address of a network card; the library takes that for out of bounds where loopback alone is
/// allowed, and drops it. Here it is 127.0.0.1, where they listen too.
class UdpTransportDescriptor final : public eprosima::fastdds::rtps::ChainingTransportDescriptor {
 public:
  UdpTransportDescriptor(const DomainSettings& settings, std::shared_ptr<Intake> intake);
  [[nodiscard]] eprosima::fastdds::rtps::TransportInterface* create_transport() const override;

  const bool is_loopback_only;
  const std::shared_ptr<Intake> intake;
};

}  // namespace slackwater::dds
