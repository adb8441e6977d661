#pragma once
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <string>

#include "slackwater_msgsPubSubTypes.h"
#include "tests/api/door/dds/inbox.h"

namespace slackwater::tests {

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

/// A Fast DDS participant as others would write it: with fastddsgen's own types, nothing of
/// api/door/dds. Over UDP on this machine, or as the library has it where nobody says anything: so
/// are nodes of ROS 2 by rmw_fastrtps.
class GeneratedParticipant {
 public:
  GeneratedParticipant(int domain, bool is_loopback) {
    fdds::DomainParticipantQos qos;
    if (is_loopback) {
      qos.transport().use_builtin_transports = false;
      const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
      udp->interfaceWhiteList.emplace_back("127.0.0.1");
      qos.transport().user_transports.push_back(udp);
    }
    participant_ = fdds::DomainParticipantFactory::get_instance()->create_participant(
        static_cast<std::uint32_t>(domain), qos);
    publisher_ = participant_->create_publisher(fdds::PUBLISHER_QOS_DEFAULT);
    subscriber_ = participant_->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~GeneratedParticipant() {
    participant_->delete_contained_entities();
    fdds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  GeneratedParticipant(const GeneratedParticipant&) = delete;
  GeneratedParticipant& operator=(const GeneratedParticipant&) = delete;

  /// As rmw_fastrtps has its services: reliable, volatile, the last ten.
  fdds::DataWriter* writer(const std::string& topic, fdds::TypeSupport type) {
    fdds::DataWriterQos qos;
    qos.history().depth = 10;
    qos.data_sharing().off();
    return publisher_->create_datawriter(made(topic, std::move(type)), qos);
  }
  fdds::DataReader* reader(const std::string& topic, fdds::TypeSupport type,
                           fdds::DataReaderListener* listener, bool is_latched = false) {
    fdds::DataReaderQos qos;
    qos.reliability().kind = fdds::RELIABLE_RELIABILITY_QOS;
    if (is_latched) qos.durability().kind = fdds::TRANSIENT_LOCAL_DURABILITY_QOS;
    qos.history().depth = 10;
    qos.data_sharing().off();
    return subscriber_->create_datareader(made(topic, std::move(type)), qos, listener);
  }
  void leave(fdds::DataReader* reader) { subscriber_->delete_datareader(reader); }

 private:
  fdds::Topic* made(const std::string& topic, fdds::TypeSupport type) {
    if (auto* known = dynamic_cast<fdds::Topic*>(participant_->lookup_topicdescription(topic)))
      return known;
    type.register_type(participant_);
    return participant_->create_topic(topic, type.get_type_name(), fdds::TOPIC_QOS_DEFAULT);
  }

  fdds::DomainParticipant* participant_;
  fdds::Publisher* publisher_;
  fdds::Subscriber* subscriber_;
};

/// Whose identity a request carries.
enum class Convention {
  plain,        ///< none beside its own
  rmw_fastrtps  ///< the reader that waits for the answer, as related identity
};

/// A client of a service of type slackwater_msgs/srv/Spawn, which asks with a name.
class SpawnClient {
 public:
  struct Reply {
    std::string message;
    rtps::GUID_t to;
    std::uint64_t sequence = 0;
  };

  struct Settings {
    bool listens = true;  ///< else it does not before it is told to
    bool is_loopback = true;
  };

  SpawnClient(int domain, Convention convention, const std::string& service)
      : SpawnClient(domain, convention, service, Settings()) {}
  SpawnClient(int domain, Convention convention, const std::string& service,
              const Settings& settings)
      : convention_(convention),
        service_(service),
        listener_(replies_),
        participant_(domain, settings.is_loopback) {
    writer_ =
        participant_.writer("rq" + service + "Request",
                            fdds::TypeSupport(new slackwater_msgs::srv::Spawn_RequestPubSubType));
    if (settings.listens) listen();
  }
  void listen() {
    reader_ = participant_.reader(
        "rr" + service_ + "Reply",
        fdds::TypeSupport(new slackwater_msgs::srv::Spawn_ResponsePubSubType), &listener_);
  }

  /// What clients wait for before they ask: the service is there, both ways.
  [[nodiscard]] bool finds_service() {
    return comes_true([&] {
      fdds::PublicationMatchedStatus out;
      fdds::SubscriptionMatchedStatus in;
      writer_->get_publication_matched_status(out);
      if (reader_ != nullptr) reader_->get_subscription_matched_status(in);
      return out.current_count > 0 && (reader_ == nullptr || in.current_count > 0);
    });
  }
  /// @return the number by which the answer names the request
  std::uint64_t ask(const std::string& name) {
    slackwater_msgs::srv::Spawn_Request request;
    request.model("model");
    request.name(name);
    request.pose().pose().orientation().w(1);
    rtps::WriteParams params;
    if (convention_ == Convention::rmw_fastrtps)
      params.related_sample_identity().writer_guid() = reader_->guid();
    writer_->write(&request, params);
    return params.sample_identity().sequence_number().to64long();
  }
  /// Whom answers are for.
  [[nodiscard]] rtps::GUID_t identity() const {
    return convention_ == Convention::plain ? writer_->guid() : reader_->guid();
  }
  Inbox<Reply>& replies() { return replies_; }

 private:
  class Listener final : public fdds::DataReaderListener {
   public:
    explicit Listener(Inbox<Reply>& replies) : replies_(replies) {}
    void on_data_available(fdds::DataReader* reader) override {
      slackwater_msgs::srv::Spawn_Response response;
      fdds::SampleInfo info;
      while (reader->take_next_sample(&response, &info) ==
             eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
        if (!info.valid_data) continue;
        replies_.put({response.message(), info.related_sample_identity.writer_guid(),
                      info.related_sample_identity.sequence_number().to64long()});
      }
    }

   private:
    Inbox<Reply>& replies_;
  };

  Convention convention_;
  std::string service_;
  Inbox<Reply> replies_;
  Listener listener_;
  GeneratedParticipant participant_;
  fdds::DataWriter* writer_ = nullptr;
  fdds::DataReader* reader_ = nullptr;
};

}  // namespace slackwater::tests
