#include "api/door/dds/endpoint_quality.h"

#include <fastdds/rtps/transport/shared_mem/SharedMemTransportDescriptor.h>
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "api/door/dds/udp_transport.h"
#include "fields/base/error.h"

namespace slackwater::dds {
namespace {

namespace fdds = eprosima::fastdds::dds;

/// Keeps the last of `depth`, and has room for so many, not for the hundred of the default.
template <typename Qos>
void keep_last(std::int32_t depth, Qos& qos) {
  qos.history().kind = fdds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().max_samples = depth;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().allocated_samples = depth;
}

template <typename Qos>
void be_of(const bag::Quality& quality, const std::string& type_hash, Qos& qos) {
  if (!type_hash.empty()) {
    const std::string told = "typehash=" + type_hash + ";";  // rmw_dds_common, qos.cpp
    qos.user_data().assign(told.begin(), told.end());
  }
  qos.reliability().kind =
      quality.is_reliable ? fdds::RELIABLE_RELIABILITY_QOS : fdds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = quality.is_transient_local ? fdds::TRANSIENT_LOCAL_DURABILITY_QOS
                                                     : fdds::VOLATILE_DURABILITY_QOS;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy =
      eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

}  // namespace

// Of readers, whatever the depth: what comes is taken at once, but what comes behind a sample that
// was lost waits for the word that it is. With room for one it would be refused; and a reliable
// writer that keeps the last one alone has a newer one whenever it is asked again, so that the
// reader would hear next to nothing.
constexpr std::int32_t most_out_of_order = 64;

void expect_domain(int domain) {
  // RTPS's ports: 7400 + 250 x 232 and some are the last below 65536.
  constexpr int last = 232;
  if (domain >= 0 && domain <= last) return;
  throw Error(ErrorKind::invalid_input, "DDS domain " + std::to_string(domain) +
                                            ": domains are from 0 to " + std::to_string(last));
}

fdds::DomainParticipantQos participant_qos(const DomainSettings& settings,
                                           std::shared_ptr<Intake> intake) {
  using eprosima::fastdds::rtps::SharedMemTransportDescriptor;
  fdds::DomainParticipantQos qos;
  qos.name(settings.node.c_str());
  const std::string enclave = "enclave=/;";  // as nodes of ROS 2 have it
  qos.user_data().assign(enclave.begin(), enclave.end());
  // As it is of itself, but for the intake.
  qos.transport().use_builtin_transports = false;
  const auto udp = std::make_shared<UdpTransportDescriptor>(settings, std::move(intake));
  if (!settings.is_udp_only) {
    auto shared_memory = std::make_shared<SharedMemTransportDescriptor>();
    shared_memory->max_message_size(udp->max_message_size());
    qos.transport().user_transports.push_back(std::move(shared_memory));
  }
  qos.transport().user_transports.push_back(udp);
  // Those that come through shared memory too; and ourselves.
  qos.allocation().participants.maximum = Intake::most_participants + 1;
  return qos;
}

fdds::DataWriterQos writer_qos(const bag::Quality& quality, const std::string& type_hash) {
  fdds::DataWriterQos qos;
  be_of(quality, type_hash, qos);
  keep_last(quality.depth, qos);
  qos.publish_mode().kind = fdds::SYNCHRONOUS_PUBLISH_MODE;
  // What got lost is asked for again after a twentieth of a second, not after three. Of itself the
  // library would ask each reader with each sample, once the history is full, whether it came: of
  // five subscribers to 20 vehicles at 100 Hz a third of what they compute (live_bench).
  qos.reliable_writer_qos().times.heartbeatPeriod = {0, 50'000'000};
  qos.reliable_writer_qos().disable_heartbeat_piggyback = true;
  qos.writer_resource_limits().matched_subscriber_allocation.maximum = most_of_a_topic;
  return qos;
}

fdds::DataReaderQos reader_qos(const bag::Quality& quality, const std::string& type_hash) {
  fdds::DataReaderQos qos;
  be_of(quality, type_hash, qos);
  keep_last(std::max(quality.depth, most_out_of_order), qos);
  qos.resource_limits().allocated_samples = quality.depth;  // the others when they are needed
  qos.reader_resource_limits().matched_publisher_allocation.maximum = most_of_a_topic;
  return qos;
}

std::string name_of_policy(fdds::QosPolicyId_t policy) {
  switch (policy) {
    case fdds::DURABILITY_QOS_POLICY_ID:
      return "durability";
    case fdds::RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case fdds::DEADLINE_QOS_POLICY_ID:
      return "deadline";
    case fdds::LIVELINESS_QOS_POLICY_ID:
      return "liveliness";
    case fdds::OWNERSHIP_QOS_POLICY_ID:
      return "ownership";
    default:
      return "policy " + std::to_string(static_cast<int>(policy));
  }
}

}  // namespace slackwater::dds
