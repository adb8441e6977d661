#include "api/door/dds/endpoints.h"

#include <algorithm>
#include <chrono>
#include <fastdds/dds/subscriber/SampleInfo.hpp>

#include "api/door/dds/endpoint_quality.h"

namespace slackwater::dds {
namespace {

namespace fdds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

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

/// Clients by rmw_fastrtps name the reader that waits for the answer in the request's related
/// identity; a plain one is answered by the identity of its sample.
Sender sender_of(const fdds::SampleInfo& info) {
  Sender sender;
  sender.request = info.sample_identity;
  const rtps::GUID_t& reply_reader = info.related_sample_identity.writer_guid();
  if (reply_reader != rtps::GUID_t::unknown()) sender.request.writer_guid(reply_reader);
  sender.client = client_of(info.sample_identity.writer_guid().guidPrefix);
  return sender;
}

/// @param data  what discovery says of a reader or a writer
template <typename Data>
Endpoint endpoint_of(const Data& data, bool is_writer) {
  return {data.topicName().to_string(), data.typeName().to_string(), is_writer,
          data.m_qos.m_reliability.kind == fdds::RELIABLE_RELIABILITY_QOS,
          static_cast<int>(data.m_qos.m_durability.kind)};
}

/// Which says who, too (`MismatchWatch`).
bool is_watched(fdds::QosPolicyId_t policy) {
  return policy == fdds::RELIABILITY_QOS_POLICY_ID || policy == fdds::DURABILITY_QOS_POLICY_ID;
}

}  // namespace

Gid gid_of(const rtps::GUID_t& guid) {
  Gid gid{};
  std::copy_n(guid.guidPrefix.value, guid.guidPrefix.size, gid.begin());
  std::copy_n(guid.entityId.value, guid.entityId.size, gid.begin() + guid.guidPrefix.size);
  return gid;
}

Prefix prefix_of(const rtps::GUID_t& guid) {
  Prefix prefix{};
  std::copy_n(guid.guidPrefix.value, prefix.size(), prefix.begin());
  return prefix;
}

void Guard::tell(const std::string& text) const noexcept {
  try {
    if (tell_) tell_(text);
  } catch (...) {  // Nobody is left to tell.
  }
}

void Writer::on_publication_matched(fdds::DataWriter* source,
                                    const fdds::PublicationMatchedStatus& status) {
  readers = status.current_count;
  rtps::GUID_t reader;
  rtps::iHandle2GUID(reader, status.last_subscription_handle);
  const bool is_new = status.current_count_change > 0;
  {
    const std::string client = client_of(reader.guidPrefix);
    const std::lock_guard lock(mutex_);
    if (is_new) {
      clients_.insert(client);
    } else if (const auto gone = clients_.find(client); gone != clients_.end()) {
      clients_.erase(gone);
    }
  }
  if (is_new)
    replies.reader_found(*source, reader);
  else
    replies.reader_lost(reader);
  if (readers == most_of_a_topic && !is_said_full_.exchange(true))
    guard_.tell(
        topic_ + " has " + std::to_string(most_of_a_topic) +
        " readers, and tells no more: keep strangers out (--loopback, --interface, a firewall)");
}

bool Writer::is_heard_by(const std::string& client) const {
  const std::lock_guard lock(mutex_);
  return clients_.contains(client);
}

void Writer::on_offered_incompatible_qos(fdds::DataWriter*,
                                         const fdds::OfferedIncompatibleQosStatus& status) {
  if (is_watched(status.last_policy_id)) return;
  guard_.tell("a reader of " + topic_ + " asks for more than is offered (" +
              name_of_policy(status.last_policy_id) +
              "): it gets nothing; let it ask for best effort and volatile");
}

double HeldBackByWriter::look(const fdds::SampleInfo& info) {
  // Where its writer does not say when it was sent there is nothing to go by.
  if (info.source_timestamp.seconds() <= 0 || info.source_timestamp == rtps::c_RTPSTimeInfinite)
    return 0;
  const std::chrono::duration<double> came = std::chrono::steady_clock::now().time_since_epoch();
  const std::lock_guard lock(mutex_);
  return of_[info.sample_identity.writer_guid()].look(
      1e-9 * static_cast<double>(info.source_timestamp.to_ns()), came.count());
}

void HeldBackByWriter::forget(const rtps::GUID_t& writer) {
  const std::lock_guard lock(mutex_);
  of_.erase(writer);
}

void Reader::on_data_available(fdds::DataReader* source) {
  Bytes bytes;
  fdds::SampleInfo info;
  while (source->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
    if (!info.valid_data) continue;
    Sender sender = sender_of(info);
    sender.held_back_s = held_back_.look(info);
    guard_(topic_, [&] { on_bytes_(bytes, sender); });
  }
}

void Reader::on_subscription_matched(fdds::DataReader*,
                                     const fdds::SubscriptionMatchedStatus& status) {
  if (status.current_count == most_of_a_topic && !is_said_full_.exchange(true))
    guard_.tell(topic_ + " has " + std::to_string(most_of_a_topic) +
                " writers, and no more are heard: keep strangers out (--loopback, --interface, a "
                "firewall)");
  if (status.current_count_change >= 0) return;
  rtps::GUID_t writer;
  rtps::iHandle2GUID(writer, status.last_publication_handle);
  held_back_.forget(writer);
  if (on_left_) guard_(topic_, [&] { on_left_(client_of(writer.guidPrefix)); });
}

void Reader::on_requested_incompatible_qos(fdds::DataReader*,
                                           const fdds::RequestedIncompatibleQosStatus& status) {
  if (is_watched(status.last_policy_id)) return;
  guard_.tell("a writer of " + topic_ + " offers less than is asked for (" +
              name_of_policy(status.last_policy_id) + "): it is not heard; let it write reliably");
}

void Watcher::on_participant_discovery(fdds::DomainParticipant*,
                                       rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const Prefix prefix = prefix_of(info.info.m_guid);
  if (info.status != Info::REMOVED_PARTICIPANT && info.status != Info::DROPPED_PARTICIPANT)
    return guard_("a client came", [&] { intake_.found(prefix); });
  guard_("a client left", [&] { intake_.lost(prefix); });
  std::vector<OnLost> told;
  {
    const std::lock_guard lock(mutex_);
    told = on_lost_;
  }
  const std::string client = client_of(info.info.m_guid.guidPrefix);
  guard_("a client left", [&] { mismatches_.forget_client(client); });
  for (const auto& on_lost : told) guard_("a client left", [&] { on_lost(client); });
}

void Watcher::on_publisher_discovery(fdds::DomainParticipant*, rtps::WriterDiscoveryInfo&& info) {
  const rtps::GUID_t guid = info.info.guid();
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER)
    return mismatches_.forget(gid_of(guid));
  guard_("a writer was found", [&] { found(guid, endpoint_of(info.info, true)); });
}

void Watcher::on_subscriber_discovery(fdds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& info) {
  const rtps::GUID_t guid = info.info.guid();
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER)
    return mismatches_.forget(gid_of(guid));
  guard_("a reader was found", [&] { found(guid, endpoint_of(info.info, false)); });
}

void Watcher::found(const rtps::GUID_t& guid, Endpoint endpoint) {
  for (const std::string& words :
       mismatches_.add_theirs(gid_of(guid), client_of(guid.guidPrefix), std::move(endpoint)))
    guard_.tell(words);
}

void Watcher::add_ours(const Endpoint& endpoint) {
  for (const std::string& words : mismatches_.add_ours(endpoint)) guard_.tell(words);
}

void Watcher::add(OnLost on_lost) {
  const std::lock_guard lock(mutex_);
  on_lost_.push_back(std::move(on_lost));
}

}  // namespace slackwater::dds
