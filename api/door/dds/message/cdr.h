#pragma once
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include "api/door/dds/message/bytes.h"
#include "fields/base/error.h"

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// @param M  a type that fastddsgen made
template <typename M>
[[nodiscard]] Bytes encoded(const M& message) {
  using eprosima::fastcdr::Cdr;
  constexpr std::size_t encapsulation = 4;
  Bytes bytes(encapsulation + M::getCdrSerializedSize(message));
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  message.serialize(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

/// Reads a message of any client; what is left at the end may be padding, and no more. Types with
/// sequences read them one by one (`for_each_element`): fastddsgen's make room for as many elements
/// as there are bytes.
/// @param M  a type that fastddsgen made, or what reads itself as it does
/// @throws Error(invalid_input) for bytes that are no such message
template <typename M>
[[nodiscard]] M decoded(Payload payload) {
  using eprosima::fastcdr::Cdr;
  constexpr std::size_t encapsulation = 4, most_padding = 3;
  if (payload.size() < encapsulation || payload[0] != 0 || payload[1] > 1) {
    throw Error(ErrorKind::invalid_input,
                "the message is not plain CDR (found " + std::to_string(payload.size()) +
                    " bytes without its encapsulation header 00 00 or 00 01)");
  }
  // The library reads through a pointer that is not const; it writes nothing.
  auto* bytes = const_cast<std::uint8_t*>(payload.data());
  eprosima::fastcdr::FastBuffer buffer(reinterpret_cast<char*>(bytes), payload.size());
  Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  M message;
  try {
    cdr.read_encapsulation();
    message.deserialize(cdr);
  } catch (const eprosima::fastcdr::exception::Exception& e) {
    throw Error(ErrorKind::invalid_input,
                std::string("the message is cut short or of another type (") + e.what() + ")");
  }
  const std::size_t read = cdr.getSerializedDataLength();
  if (payload.size() > read + most_padding) {
    throw Error(ErrorKind::invalid_input,
                "the message is of another type: " + std::to_string(payload.size() - read) +
                    " bytes more than its fields take");
  }
  return message;
}

/// Reads a sequence one by one, so that its count makes no room: that is for what is there.
template <typename Element, typename Take>
void for_each_element(eprosima::fastcdr::Cdr& cdr, const Take& take) {
  std::uint32_t count = 0;
  cdr >> count;
  for (; count > 0; --count) {
    Element element{};
    cdr >> element;
    take(element);
  }
}

}  // namespace slackwater::dds
