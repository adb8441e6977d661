#include "api/door/dds/wire_type.h"

#include <cstring>

namespace slackwater::dds {

WireType::WireType(const std::string& name) {
  constexpr std::uint32_t first_room = 512;  // it grows
  setName(name.c_str());
  m_typeSize = first_room;
  m_isGetKeyDefined = false;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool WireType::serialize(void* data, SerializedPayload* payload) {
  const Payload& bytes = *static_cast<const Payload*>(data);
  if (payload->max_size < bytes.size()) return false;
  payload->encapsulation = CDR_LE;
  payload->length = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(payload->data, bytes.data(), bytes.size());
  return true;
}

bool WireType::deserialize(SerializedPayload* payload, void* data) {
  static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<std::uint32_t()> WireType::getSerializedSizeProvider(void* data) {
  const auto size = static_cast<std::uint32_t>(static_cast<const Payload*>(data)->size());
  return [size] { return size; };
}

void* WireType::createData() { return new Bytes; }
void WireType::deleteData(void* data) { delete static_cast<Bytes*>(data); }
bool WireType::getKey(void*, InstanceHandle*, bool) { return false; }

}  // namespace slackwater::dds
