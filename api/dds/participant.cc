#include "api/dds/participant.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <map>
#include <mutex>

#include "api/dds/endpoint_quality.h"
#include "api/dds/held_back.h"
#include "api/dds/library_faults.h"
#include "api/dds/message/graph.h"
#include "api/dds/message/names.h"
#include "api/dds/replies.h"
#include "api/dds/shared_memory.h"
#include "api/dds/wire_type.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::dds {
namespace {

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

Gid gid_of(const rtps::GUID_t& guid) {
  Gid gid{};
  std::copy_n(guid.guidPrefix.value, guid.guidPrefix.size, gid.begin());
  std::copy_n(guid.entityId.value, guid.entityId.size, gid.begin() + guid.guidPrefix.size);
  return gid;
}

std::string client_of(const rtps::GuidPrefix_t& prefix) {
  static constexpr const char* digits = "0123456789abcdef";
  std::string name = "dds ";
  for (unsigned i = 0; i < rtps::GuidPrefix_t::size; ++i) {
    if (i > 0) name += '.';
    name += digits[prefix.value[i] >> 4];
    name += digits[prefix.value[i] & 15];
  }
  return name;
}

/// What is thrown where the library calls us goes no further.
class Guard {
 public:
  explicit Guard(const DomainSettings& settings) : settings_(settings) {}
  template <typename Work>
  void operator()(const std::string& where, const Work& work) const noexcept {
    try {
      work();
    } catch (const std::exception& e) {
      tell(where + ": " + e.what());
    } catch (...) {
      tell(where + ": failed");
    }
  }
  void tell(const std::string& text) const noexcept {
    try {
      if (settings_.on_trouble) settings_.on_trouble(text);
    } catch (...) {  // Nobody is left to tell.
    }
  }

 private:
  const DomainSettings& settings_;
};

class Writer final : public fdds::DataWriterListener {
 public:
  Writer(std::string topic, const Guard& guard) : topic_(std::move(topic)), guard_(guard) {}
  fdds::DataWriter* writer = nullptr;
  bool is_transient_local = false;
  std::atomic<int> readers{0};
  Replies replies;  ///< of a service

  void on_publication_matched(fdds::DataWriter* source,
                              const fdds::PublicationMatchedStatus& status) override {
    readers = status.current_count;
    rtps::GUID_t reader;
    rtps::iHandle2GUID(reader, status.last_subscription_handle);
    if (status.current_count_change > 0)
      replies.reader_found(*source, reader);
    else
      replies.reader_lost(reader);
  }
  void on_offered_incompatible_qos(fdds::DataWriter*,
                                   const fdds::OfferedIncompatibleQosStatus& status) override {
    guard_.tell("a reader of " + topic_ + " asks for more than is offered (" +
                name_of_policy(status.last_policy_id) +
                "): it gets nothing; let it ask for best effort and volatile");
  }

 private:
  std::string topic_;
  const Guard& guard_;
};

/// What comes with a message.
struct Sender {
  rtps::SampleIdentity request;  ///< whom an answer is for
  std::string client;
  double held_back_s = 0;
};

/// Of all writers of a topic.
class HeldBackByWriter {
 public:
  double look(const fdds::SampleInfo& info) {
    // Where its writer does not say when it was sent there is nothing to go by.
    if (info.source_timestamp.seconds() <= 0 || info.source_timestamp == rtps::c_RTPSTimeInfinite)
      return 0;
    const std::chrono::duration<double> came = std::chrono::steady_clock::now().time_since_epoch();
    const std::lock_guard lock(mutex_);
    return of_[info.sample_identity.writer_guid()].look(
        1e-9 * static_cast<double>(info.source_timestamp.to_ns()), came.count());
  }
  void forget(const rtps::GUID_t& writer) {
    const std::lock_guard lock(mutex_);
    of_.erase(writer);
  }

 private:
  std::mutex mutex_;
  std::map<rtps::GUID_t, HeldBack> of_;
};

class Reader final : public fdds::DataReaderListener {
 public:
  using OnBytes = std::function<void(Payload, const Sender&)>;
  Reader(std::string topic, const Guard& guard, OnBytes on_bytes)
      : topic_(std::move(topic)), guard_(guard), on_bytes_(std::move(on_bytes)) {}
  fdds::DataReader* reader = nullptr;

  void on_data_available(fdds::DataReader* source) override {
    Bytes bytes;
    fdds::SampleInfo info;
    while (source->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      Sender sender = sender_of(info);
      sender.held_back_s = held_back_.look(info);
      guard_(topic_, [&] { on_bytes_(bytes, sender); });
    }
  }
  void on_subscription_matched(fdds::DataReader*,
                               const fdds::SubscriptionMatchedStatus& status) override {
    if (status.current_count_change >= 0) return;
    rtps::GUID_t writer;
    rtps::iHandle2GUID(writer, status.last_publication_handle);
    held_back_.forget(writer);
  }
  void on_requested_incompatible_qos(fdds::DataReader*,
                                     const fdds::RequestedIncompatibleQosStatus& status) override {
    guard_.tell("a writer of " + topic_ + " offers less than is asked for (" +
                name_of_policy(status.last_policy_id) +
                "): it is not heard; let it write reliably");
  }

 private:
  /// Clients by rmw_fastrtps name the reader that waits for the answer in the request's related
  /// identity; a plain one is answered by the identity of its sample.
  static Sender sender_of(const fdds::SampleInfo& info) {
    Sender sender;
    sender.request = info.sample_identity;
    const rtps::GUID_t& reply_reader = info.related_sample_identity.writer_guid();
    if (reply_reader != rtps::GUID_t::unknown()) sender.request.writer_guid(reply_reader);
    sender.client = client_of(info.sample_identity.writer_guid().guidPrefix);
    return sender;
  }

  std::string topic_;
  const Guard& guard_;
  OnBytes on_bytes_;
  HeldBackByWriter held_back_;
};

/// Tells of participants that left.
class Watcher final : public fdds::DomainParticipantListener {
 public:
  explicit Watcher(const Guard& guard) : guard_(guard) {}
  void on_participant_discovery(fdds::DomainParticipant*,
                                rtps::ParticipantDiscoveryInfo&& info) override {
    using Info = rtps::ParticipantDiscoveryInfo;
    if (info.status != Info::REMOVED_PARTICIPANT && info.status != Info::DROPPED_PARTICIPANT)
      return;
    std::vector<Participant::OnLost> told;
    {
      const std::lock_guard lock(mutex_);
      told = on_lost_;
    }
    const std::string client = client_of(info.info.m_guid.guidPrefix);
    for (const auto& on_lost : told) guard_("a client left", [&] { on_lost(client); });
  }
  void add(Participant::OnLost on_lost) {
    const std::lock_guard lock(mutex_);
    on_lost_.push_back(std::move(on_lost));
  }

 private:
  const Guard& guard_;
  std::mutex mutex_;
  std::vector<Participant::OnLost> on_lost_;
};

}  // namespace

struct Participant::State {
  explicit State(DomainSettings given) : settings(std::move(given)) {
    excuse_library_faults();
    expect_domain(settings.domain);
    if (!settings.is_udp_only) sweep_shared_memory();
    auto* factory = fdds::DomainParticipantFactory::get_instance();
    // Without a mask the participant would take what its readers are there for.
    participant =
        factory->create_participant(static_cast<std::uint32_t>(settings.domain),
                                    participant_qos(settings), &watcher, fdds::StatusMask::none());
    if (participant == nullptr) {
      throw Error(ErrorKind::unavailable, "DDS domain " + std::to_string(settings.domain) +
                                              " cannot be joined; are its UDP ports (from " +
                                              std::to_string(7400 + 250 * settings.domain) +
                                              ") free and allowed?");
    }
    publisher = participant->create_publisher(fdds::PUBLISHER_QOS_DEFAULT);
    subscriber = participant->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~State() {
    {
      const std::lock_guard lock(life->mutex);
      life->is_over = true;
    }
    participant->set_listener(nullptr);
    participant->delete_contained_entities();
    fdds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  fdds::Topic* topic(const std::string& name, const std::string& type) {
    if (participant->find_type(type).empty()) {
      fdds::TypeSupport support(new WireType(type));
      support.register_type(participant);
    }
    if (auto* known = dynamic_cast<fdds::Topic*>(participant->lookup_topicdescription(name))) {
      expects(known->get_type_name() == type, "a topic has one type");
      return known;
    }
    fdds::Topic* made = participant->create_topic(name, type, fdds::TOPIC_QOS_DEFAULT);
    expects(made != nullptr, "a topic of DDS");
    return made;
  }

  template <typename List, typename... Parts>
  auto& added(List& list, Parts&&... parts) {
    const std::lock_guard lock(mutex);
    return list.emplace_back(std::forward<Parts>(parts)...);
  }

  Writer& write(const std::string& name, const std::string& type, const bag::Quality& quality) {
    fdds::Topic* const of = topic(name, type);
    Writer& writer = added(writers, name, guard);
    writer.is_transient_local = quality.is_transient_local;
    writer.writer = publisher->create_datawriter(of, writer_qos(quality), &writer);
    expects(writer.writer != nullptr, "a writer of a topic");
    return writer;
  }
  void read(const std::string& name, const std::string& type, const bag::Quality& quality,
            Reader::OnBytes on_bytes) {
    fdds::Topic* const of = topic(name, type);
    Reader& reader = added(readers, name, guard, std::move(on_bytes));
    reader.reader = subscriber->create_datareader(of, reader_qos(quality), &reader);
    expects(reader.reader != nullptr, "a reader of a topic");
  }

  /// Outlives the participant in answers that nobody waits for any more.
  struct Life {
    std::mutex mutex;
    bool is_over = false;
  };

  DomainSettings settings;
  Guard guard{settings};
  Watcher watcher{guard};
  std::shared_ptr<Life> life = std::make_shared<Life>();
  fdds::DomainParticipant* participant = nullptr;
  fdds::Publisher* publisher = nullptr;
  fdds::Subscriber* subscriber = nullptr;
  /// While endpoints are made. The library waits there for the threads that call us, and these may
  /// be about to `send`: nothing that it calls takes this one, and nobody makes an endpoint with
  /// the other.
  std::mutex making;
  mutable std::mutex mutex;  ///< of the lists; what is in them stays where it is
  std::deque<Writer> writers;
  std::deque<Reader> readers;
  std::vector<Writer*> by_id;
  Writer* graph = nullptr;
};

Participant::Participant(DomainSettings settings)
    : state_(std::make_unique<State>(std::move(settings))) {
  const bag::Quality latched{true, true, 1};
  state_->graph = &state_->write("ros_discovery_info",
                                 dds_type("rmw_dds_common/msg/ParticipantEntitiesInfo"), latched);
}

Participant::~Participant() = default;

Participant::WriterId Participant::publish_on(const bag::Channel& channel) {
  const std::lock_guard one_at_a_time(state_->making);
  Writer& writer = state_->write(dds_topic(channel.topic), dds_type(channel.type), channel.quality);
  const std::lock_guard lock(state_->mutex);
  state_->by_id.push_back(&writer);
  return state_->by_id.size() - 1;
}

bool Participant::is_heard(WriterId writer) const {
  const std::lock_guard lock(state_->mutex);
  const Writer& asked = *state_->by_id.at(writer);
  return asked.is_transient_local || asked.readers > 0;
}

void Participant::send(WriterId writer, Payload message) {
  fdds::DataWriter* target = nullptr;
  {
    const std::lock_guard lock(state_->mutex);
    target = state_->by_id.at(writer)->writer;
  }
  target->write(&message);
}

void Participant::subscribe(const bag::Channel& channel, OnMessage on_message) {
  subscribe_timed(channel,
                  [on_message = std::move(on_message)](Payload message, const std::string& client,
                                                       double) { on_message(message, client); });
}

void Participant::subscribe_timed(const bag::Channel& channel, OnTimedMessage on_message) {
  const std::lock_guard one_at_a_time(state_->making);
  state_->read(dds_topic(channel.topic), dds_type(channel.type), channel.quality,
               [on_message = std::move(on_message)](Payload message, const Sender& sender) {
                 on_message(message, sender.client, sender.held_back_s);
               });
}

void Participant::serve(const Service& service, OnRequest on_request) {
  const std::lock_guard one_at_a_time(state_->making);
  const bag::Quality quality;
  Writer& writer = state_->write(reply_topic(service.name), reply_type(service.type), quality);
  state_->read(request_topic(service.name), request_type(service.type), quality,
               [&writer, life = state_->life, on_request = std::move(on_request)](
                   Payload request, const Sender& sender) {
                 const Answer answer = [&writer, life, to = sender.request](Bytes reply) {
                   const std::lock_guard alive(life->mutex);
                   if (!life->is_over) writer.replies.send(*writer.writer, to, std::move(reply));
                 };
                 on_request(request, sender.client, answer);
               });
}

void Participant::on_lost(OnLost on_lost) { state_->watcher.add(std::move(on_lost)); }

void Participant::announce() {
  const std::lock_guard one_at_a_time(state_->making);
  NodeEntities node;
  node.participant = gid_of(state_->participant->guid());
  node.name = ros_token(state_->settings.node);
  for (const Writer& writer : state_->writers)
    if (&writer != state_->graph) node.writers.push_back(gid_of(writer.writer->guid()));
  for (const Reader& reader : state_->readers)
    node.readers.push_back(gid_of(reader.reader->guid()));
  const Bytes message = participant_entities(node);
  Payload payload = message;
  state_->graph->writer->write(&payload);
}

}  // namespace slackwater::dds
