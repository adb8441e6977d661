#include "api/door/dds/participant.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <mutex>
#include <optional>

#include "api/door/dds/endpoint_quality.h"
#include "api/door/dds/endpoints.h"
#include "api/door/dds/library_faults.h"
#include "api/door/dds/message/definition.h"
#include "api/door/dds/message/graph.h"
#include "api/door/dds/message/log_message.h"
#include "api/door/dds/message/names.h"
#include "api/door/dds/network_card.h"
#include "api/door/dds/shared_memory.h"
#include "api/door/dds/teller.h"
#include "api/door/dds/wire_type.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::dds {
namespace {

namespace fdds = eprosima::fastdds::dds;

Stamp now() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  const auto s = std::chrono::duration_cast<std::chrono::seconds>(since_1970);
  const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970 - s);
  return {static_cast<std::int32_t>(s.count()), static_cast<std::uint32_t>(ns.count())};
}

}  // namespace

struct Participant::State {
  explicit State(DomainSettings given) : settings(std::move(given)) {
    excuse_library_faults();
    expect_domain(settings.domain);
    if (!settings.interface.empty()) expect_network_card(settings.interface);
    std::optional<StartInSharedMemory> start;
    if (!settings.is_udp_only) start.emplace();
    auto* factory = fdds::DomainParticipantFactory::get_instance();
    // Without a mask the participant would take what its readers are there for.
    participant = factory->create_participant(static_cast<std::uint32_t>(settings.domain),
                                              participant_qos(settings, intake), &watcher,
                                              fdds::StatusMask::none());
    if (participant == nullptr) {
      throw Error(ErrorKind::unavailable, "DDS domain " + std::to_string(settings.domain) +
                                              " cannot be joined; are its UDP ports (from " +
                                              std::to_string(7400 + 250 * settings.domain) +
                                              ") free and allowed?");
    }
    intake->be(prefix_of(participant->guid()));
    publisher = participant->create_publisher(fdds::PUBLISHER_QOS_DEFAULT);
    subscriber = participant->create_subscriber(fdds::SUBSCRIBER_QOS_DEFAULT);
  }
  ~State() {
    intake->tell_rest();
    teller.end();
    {
      const std::lock_guard lock(life->mutex);
      life->is_over = true;
    }
    let_last_words_arrive();
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

  /// @param ros_type  of the message, or of the service that it is a part of
  Writer& write(const std::string& name, const std::string& type, const std::string& ros_type,
                const bag::Quality& quality) {
    fdds::Topic* const of = topic(name, type);
    watcher.add_ours({name, type, true, quality.is_reliable, quality.is_transient_local ? 1 : 0});
    Writer& writer = added(writers, name, guard);
    writer.is_transient_local = quality.is_transient_local;
    writer.writer =
        publisher->create_datawriter(of, writer_qos(quality, type_hash_of(ros_type)), &writer);
    expects(writer.writer != nullptr, "a writer of a topic");
    return writer;
  }
  void read(const std::string& name, const std::string& type, const std::string& ros_type,
            const bag::Quality& quality, Reader::OnBytes on_bytes, Reader::OnLeft on_left = {}) {
    fdds::Topic* const of = topic(name, type);
    watcher.add_ours({name, type, false, quality.is_reliable, quality.is_transient_local ? 1 : 0});
    Reader& reader = added(readers, name, guard, std::move(on_bytes), std::move(on_left));
    reader.reader =
        subscriber->create_datareader(of, reader_qos(quality, type_hash_of(ros_type)), &reader);
    expects(reader.reader != nullptr, "a reader of a topic");
  }

  /// What was written last is still on its way; who is gone without a word is not waited for long.
  void let_last_words_arrive() {
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    for (const Writer& writer : writers) {
      const std::chrono::duration<double> left = until - std::chrono::steady_clock::now();
      if (left.count() <= 0) return;
      (void)writer.writer->wait_for_acknowledgments(
          eprosima::fastrtps::Duration_t(static_cast<long double>(left.count())));
    }
  }

  /// To those here and those at the other side.
  void say(const std::string& text) {
    if (Writer* const to = log) {
      const Bytes message = warning_message(now(), ros_token(settings.node), text);
      Payload payload = message;
      to->writer->write(&payload);
    }
    if (settings.on_trouble) settings.on_trouble(text);
  }

  /// Outlives the participant in answers that nobody waits for any more.
  struct Life {
    std::mutex mutex;
    bool is_over = false;
  };

  DomainSettings settings;
  Guard guard{[this](const std::string& text) { teller.tell(text); }};
  std::shared_ptr<Intake> intake =
      std::make_shared<Intake>([this](const std::string& text) { teller.tell(text); });
  Watcher watcher{guard, *intake};
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
  std::atomic<Writer*> log{nullptr};
  Teller teller{[this](const std::string& text) { say(text); }};  ///< last: it has a thread
};

Participant::Participant(DomainSettings settings)
    : state_(std::make_unique<State>(std::move(settings))) {
  const std::string graph_type = "rmw_dds_common/msg/ParticipantEntitiesInfo";
  const bag::Quality latched{true, true, 1};
  state_->graph = &state_->write("ros_discovery_info", dds_type(graph_type), graph_type, latched);
  // As nodes of ROS 2 have it, for who comes late too.
  const std::string log_type = "rcl_interfaces/msg/Log";
  const bag::Quality kept{true, true, 100};
  state_->log = &state_->write(dds_topic("/rosout"), dds_type(log_type), log_type, kept);
}

Participant::~Participant() = default;

Participant::WriterId Participant::publish_on(const bag::Channel& channel) {
  const std::lock_guard one_at_a_time(state_->making);
  Writer& writer = state_->write(dds_topic(channel.topic), dds_type(channel.type), channel.type,
                                 channel.quality);
  const std::lock_guard lock(state_->mutex);
  state_->by_id.push_back(&writer);
  return state_->by_id.size() - 1;
}

bool Participant::is_heard(WriterId writer) const {
  const std::lock_guard lock(state_->mutex);
  const Writer& asked = *state_->by_id.at(writer);
  return asked.is_transient_local || asked.readers > 0;
}

bool Participant::is_heard_by(WriterId writer, const std::string& client) const {
  const std::lock_guard lock(state_->mutex);
  return state_->by_id.at(writer)->is_heard_by(client);
}

void Participant::send(WriterId writer, Payload message) {
  fdds::DataWriter* target = nullptr;
  {
    const std::lock_guard lock(state_->mutex);
    target = state_->by_id.at(writer)->writer;
  }
  target->write(&message);
}

void Participant::subscribe(const bag::Channel& channel, OnMessage on_message, OnLost on_left) {
  const std::lock_guard one_at_a_time(state_->making);
  state_->read(
      dds_topic(channel.topic), dds_type(channel.type), channel.type, channel.quality,
      [on_message = std::move(on_message)](Payload message, const Sender& sender) {
        on_message(message, sender.client);
      },
      std::move(on_left));
}

void Participant::subscribe_timed(const bag::Channel& channel, OnTimedMessage on_message) {
  const std::lock_guard one_at_a_time(state_->making);
  state_->read(dds_topic(channel.topic), dds_type(channel.type), channel.type, channel.quality,
               [on_message = std::move(on_message)](Payload message, const Sender& sender) {
                 on_message(message, sender.client, sender.held_back_s);
               });
}

void Participant::serve(const Service& service, OnRequest on_request) {
  const std::lock_guard one_at_a_time(state_->making);
  const bag::Quality quality;
  Writer& writer =
      state_->write(reply_topic(service.name), reply_type(service.type), service.type, quality);
  state_->read(request_topic(service.name), request_type(service.type), service.type, quality,
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

void Participant::tell(const std::string& text) noexcept { state_->teller.tell(text); }

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
