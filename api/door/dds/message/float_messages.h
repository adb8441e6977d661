#pragma once
#include <bit>
#include <cstring>
#include <initializer_list>
#include <span>

#include "api/door/dds/message/parts.h"
#include "api/door/dds/message/sensor_messages.h"
#include "sensor_msgs.h"

// Numbers of single precision in messages of bytes. Only sources of this folder include this: it
// shows the types that fastddsgen made.

namespace slackwater::dds {

static_assert(std::endian::native == std::endian::little, "messages say so of their numbers");

inline std::vector<std::uint8_t> float_bytes_of(std::span<const float> numbers) {
  std::vector<std::uint8_t> bytes(numbers.size_bytes());
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// @param fields   of a point
/// @param rows     of as many points each
/// @param numbers  row by row, point by point, field by field
inline sensor_msgs::msg::PointCloud2 cloud_message(std::initializer_list<const char*> fields,
                                                   std::size_t rows, std::span<const float> numbers,
                                                   const SensorStamp& of) {
  constexpr std::uint8_t float32 = 7;
  constexpr std::uint32_t size = sizeof(float);
  sensor_msgs::msg::PointCloud2 message;
  message.header(header_message(of.stamp, of.frame_id));
  for (const char* name : fields) {
    sensor_msgs::msg::PointField field;
    field.name(name);
    field.offset(static_cast<std::uint32_t>(message.fields().size()) * size);
    field.datatype(float32);
    field.count(1);
    message.fields().push_back(field);
  }
  message.height(static_cast<std::uint32_t>(rows));
  message.width(static_cast<std::uint32_t>(rows == 0 ? 0 : numbers.size() / fields.size() / rows));
  message.point_step(static_cast<std::uint32_t>(fields.size()) * size);
  message.row_step(message.width() * message.point_step());
  message.data(float_bytes_of(numbers));
  return message;
}

}  // namespace slackwater::dds
