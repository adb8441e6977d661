#pragma once
#include <atomic>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "api/door/dds/held_back.h"
#include "api/door/dds/intake/intake.h"
#include "api/door/dds/message/bytes.h"
#include "api/door/dds/mismatch.h"
#include "api/door/dds/replies.h"

// What Fast DDS calls, on threads of its own: writers, readers, and peers that come and go.
// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

[[nodiscard]] Gid gid_of(const eprosima::fastrtps::rtps::GUID_t& guid);
[[nodiscard]] Prefix prefix_of(const eprosima::fastrtps::rtps::GUID_t& guid);

/// What is thrown where the library calls us goes no further.
class Guard {
 public:
  using Tell = std::function<void(const std::string&)>;
  /// @param tell  may be none
  explicit Guard(Tell tell) : tell_(std::move(tell)) {}
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
  void tell(const std::string& text) const noexcept;

 private:
  Tell tell_;
};

class Writer final : public eprosima::fastdds::dds::DataWriterListener {
 public:
  Writer(std::string topic, const Guard& guard) : topic_(std::move(topic)), guard_(guard) {}
  eprosima::fastdds::dds::DataWriter* writer = nullptr;
  bool is_transient_local = false;
  std::atomic<int> readers{0};
  Replies replies;  ///< of a service
  [[nodiscard]] bool is_heard_by(const std::string& client) const;

  void on_publication_matched(
      eprosima::fastdds::dds::DataWriter* source,
      const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;
  void on_offered_incompatible_qos(
      eprosima::fastdds::dds::DataWriter* source,
      const eprosima::fastdds::dds::OfferedIncompatibleQosStatus& status) override;

 private:
  std::string topic_;
  const Guard& guard_;
  mutable std::mutex mutex_;
  std::multiset<std::string> clients_;  ///< of each reader whose it is
  std::atomic<bool> is_said_full_{false};
};

/// What comes with a message.
struct Sender {
  eprosima::fastrtps::rtps::SampleIdentity request;  ///< whom an answer is for
  std::string client;
  double held_back_s = 0;
};

/// Of all writers of a topic.
class HeldBackByWriter {
 public:
  double look(const eprosima::fastdds::dds::SampleInfo& info);
  void forget(const eprosima::fastrtps::rtps::GUID_t& writer);

 private:
  std::mutex mutex_;
  std::map<eprosima::fastrtps::rtps::GUID_t, HeldBack> of_;
};

class Reader final : public eprosima::fastdds::dds::DataReaderListener {
 public:
  using OnBytes = std::function<void(Payload, const Sender&)>;
  using OnLeft = std::function<void(const std::string& client)>;
  /// @param on_left  a client has no writer of it any more; may be none
  Reader(std::string topic, const Guard& guard, OnBytes on_bytes, OnLeft on_left)
      : topic_(std::move(topic)),
        guard_(guard),
        on_bytes_(std::move(on_bytes)),
        on_left_(std::move(on_left)) {}
  eprosima::fastdds::dds::DataReader* reader = nullptr;

  void on_data_available(eprosima::fastdds::dds::DataReader* source) override;
  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader* source,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override;
  void on_requested_incompatible_qos(
      eprosima::fastdds::dds::DataReader* source,
      const eprosima::fastdds::dds::RequestedIncompatibleQosStatus& status) override;

 private:
  std::string topic_;
  const Guard& guard_;
  OnBytes on_bytes_;
  OnLeft on_left_;
  HeldBackByWriter held_back_;
  std::atomic<bool> is_said_full_{false};
};

/// Tells of participants that left, and of readers and writers that do not match ours; and the
/// intake of participants that come and go.
class Watcher final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  using OnLost = std::function<void(const std::string& client)>;
  Watcher(const Guard& guard, Intake& intake) : guard_(guard), intake_(intake) {}
  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  void add(OnLost on_lost);
  /// Of this participant, before it is there.
  void add_ours(const Endpoint& endpoint);

 private:
  void found(const eprosima::fastrtps::rtps::GUID_t& guid, Endpoint endpoint);
  const Guard& guard_;
  Intake& intake_;
  std::mutex mutex_;
  std::vector<OnLost> on_lost_;
  MismatchWatch mismatches_;
};

}  // namespace slackwater::dds
