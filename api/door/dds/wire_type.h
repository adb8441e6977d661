#pragma once
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <string>

#include "api/door/dds/message/bytes.h"

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// A type of which the library knows the name alone: its samples are bytes that are encoded
/// already. Writers are given a `Payload`, readers a `Bytes`.
class WireType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  using SerializedPayload = eprosima::fastrtps::rtps::SerializedPayload_t;
  using InstanceHandle = eprosima::fastrtps::rtps::InstanceHandle_t;

  explicit WireType(const std::string& name);
  bool serialize(void* data, SerializedPayload* payload) override;
  bool deserialize(SerializedPayload* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, InstanceHandle* handle, bool force_md5) override;
};

}  // namespace slackwater::dds
