#pragma once
#include <fastdds/dds/core/policy/QosPolicies.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <memory>
#include <string>

#include "api/door/dds/intake/intake.h"
#include "api/door/dds/participant.h"

// What we ask of Fast DDS, in its own words. Only sources of this folder include this.

namespace slackwater::dds {

/// Readers that a writer tells, and writers that a reader hears. To each reader a sample is sent
/// before the run's step goes on. Of the clock every node of a robot has one; what is beyond this
/// is made up.
constexpr int most_of_a_topic = 512;

/// @throws Error(invalid_input)
void expect_domain(int domain);

/// @param intake  of what comes by UDP
[[nodiscard]] eprosima::fastdds::dds::DomainParticipantQos participant_qos(
    const DomainSettings& settings, std::shared_ptr<Intake> intake);
/// @param type_hash  told to the others, as nodes of ROS 2 do since Iron; empty: nothing is told
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writer_qos(const bag::Quality& quality,
                                                               const std::string& type_hash);
[[nodiscard]] eprosima::fastdds::dds::DataReaderQos reader_qos(const bag::Quality& quality,
                                                               const std::string& type_hash);

/// "reliability", "durability", ...
[[nodiscard]] std::string name_of_policy(eprosima::fastdds::dds::QosPolicyId_t policy);

}  // namespace slackwater::dds
