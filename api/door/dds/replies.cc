#include "api/door/dds/replies.h"

#include <algorithm>

namespace slackwater::dds {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

/// Readers are named as such in their ids (RTPS 2.3, 9.3.1.2).
bool is_reader(const rtps::GUID_t& guid) {
  constexpr rtps::octet reader_bit = 0x04;
  return (guid.entityId.value[3] & reader_bit) != 0;
}

bool is_for(const rtps::GUID_t& reader, const rtps::SampleIdentity& to) {
  const rtps::GUID_t& client = to.writer_guid();
  return is_reader(client) ? reader == client : reader.guidPrefix == client.guidPrefix;
}

void write(Replies::Writer& writer, const rtps::SampleIdentity& to, const Bytes& reply) {
  rtps::WriteParams params;
  params.related_sample_identity(to);
  Payload payload = reply;
  writer.write(&payload, params);
}

}  // namespace

void Replies::send(Writer& writer, const Identity& to, Bytes reply) {
  constexpr std::size_t most_waiting = 64;
  {
    const std::lock_guard lock(mutex_);
    const bool is_there = std::any_of(readers_.begin(), readers_.end(),
                                      [&](const Guid& reader) { return is_for(reader, to); });
    if (!is_there) {
      if (waiting_.size() == most_waiting) waiting_.pop_front();
      waiting_.push_back({to, std::move(reply)});
      return;
    }
  }
  write(writer, to, reply);
}

void Replies::reader_found(Writer& writer, const Guid& reader) {
  std::deque<Waiting> due;
  {
    const std::lock_guard lock(mutex_);
    readers_.push_back(reader);
    const auto first_due =
        std::stable_partition(waiting_.begin(), waiting_.end(),
                              [&](const Waiting& reply) { return !is_for(reader, reply.to); });
    due.assign(std::make_move_iterator(first_due), std::make_move_iterator(waiting_.end()));
    waiting_.erase(first_due, waiting_.end());
  }
  for (const Waiting& reply : due) write(writer, reply.to, reply.reply);
}

void Replies::reader_lost(const Guid& reader) {
  const std::lock_guard lock(mutex_);
  std::erase(readers_, reader);
}

}  // namespace slackwater::dds
