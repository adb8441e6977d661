#pragma once
// A client of ROS 2 services as rmw_fastrtps is one, over fastddsgen's own type support: nothing of
// Slackwater's code is in it.
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <chrono>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <optional>
#include <string>
#include <thread>

namespace peer {

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using Clock = std::chrono::steady_clock;

enum class Transports { as_given, udp_only };

struct Node {
  explicit Node(int domain, Transports transports = Transports::as_given) {
    fdds::DomainParticipantQos qos;
    if (transports == Transports::udp_only) {
      qos.transport().use_builtin_transports = false;
      qos.transport().user_transports.push_back(
          std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>());
    }
    participant = fdds::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<std::uint32_t>(domain), qos);
    publisher = participant->create_publisher(fdds::PUBLISHER_QOS_DEFAULT);
    subscriber = participant->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~Node() {
    participant->delete_contained_entities();
    fdds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  template <typename Support>
  fdds::Topic* topic(const std::string& name) {
    const fdds::TypeSupport type(new Support);
    type.register_type(participant);
    if (auto* known = dynamic_cast<fdds::Topic*>(participant->lookup_topicdescription(name)))
      return known;
    return participant->create_topic(name, type.get_type_name(), fdds::TOPIC_QOS_DEFAULT);
  }
  template <typename Support>
  fdds::DataWriter* writer(const std::string& name) {
    return publisher->create_datawriter(topic<Support>(name), fdds::DATAWRITER_QOS_DEFAULT);
  }
  template <typename Support>
  fdds::DataReader* reader(const std::string& name, bool is_latched = false) {
    fdds::DataReaderQos qos = fdds::DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;
    qos.history().depth = 100;
    if (is_latched) qos.durability().kind = fdds::TRANSIENT_LOCAL_DURABILITY_QOS;
    return subscriber->create_datareader(topic<Support>(name), qos);
  }
  fdds::DomainParticipant* participant = nullptr;
  fdds::Publisher* publisher = nullptr;
  fdds::Subscriber* subscriber = nullptr;
};

/// @param Request, Reply  fastddsgen's type supports
template <typename Request, typename Reply>
class ServiceClient {
 public:
  ServiceClient(Node& node, const std::string& name)
      : writer_(node.template writer<Request>("rq" + name + "Request")),
        reader_(node.template reader<Reply>("rr" + name + "Reply")) {}

  /// Waits for the server, sends, waits for the answer to this very request.
  std::optional<typename Reply::type> call(typename Request::type request, double at_most_s = 10) {
    const auto until = Clock::now() + std::chrono::duration<double>(at_most_s);
    fdds::PublicationMatchedStatus readers;
    fdds::SubscriptionMatchedStatus writers;
    do {
      writer_->get_publication_matched_status(readers);
      reader_->get_subscription_matched_status(writers);
      if (Clock::now() > until) return std::nullopt;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    } while (readers.current_count == 0 || writers.current_count == 0);
    rtps::WriteParams params;
    params.related_sample_identity().writer_guid(reader_->guid());
    writer_->write(&request, params);
    const rtps::SequenceNumber_t sequence = params.sample_identity().sequence_number();
    while (Clock::now() < until) {
      typename Reply::type reply;
      fdds::SampleInfo info;
      while (reader_->take_next_sample(&reply, &info) == ReturnCode_t::RETCODE_OK)
        if (info.valid_data && info.related_sample_identity.writer_guid() == reader_->guid() &&
            info.related_sample_identity.sequence_number() == sequence)
          return reply;
      reader_->wait_for_unread_message({0, 20'000'000});
    }
    return std::nullopt;
  }

 private:
  fdds::DataWriter* writer_;
  fdds::DataReader* reader_;
};

}  // namespace peer
