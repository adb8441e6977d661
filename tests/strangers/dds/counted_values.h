#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "action_msgs.h"
#include "marine_acoustic_msgs.h"
#include "nav_msgs.h"
#include "rcl_interfaces.h"
#include "rmw_dds_common.h"
#include "rosgraph_msgs.h"
#include "sensor_msgs.h"
#include "slackwater_msgs.h"
#include "std_srvs.h"
#include "vision_msgs.h"

namespace slackwater::tests {

/// Fills messages with values that follow from a count, each field in turn taking the next number n
/// of it; cyclone_types.c does the same for Cyclone's structures.
///
///   float: n + 0.25, negative where n is odd     int: n * 0x01020304     short: n * 257
///   bool: n odd     byte: n     string: the first n mod 9 letters     sequence: n mod 3 elements
class CountedValues {
 public:
  explicit CountedValues(unsigned first) : n_(first) {}

  void put(double& v) {
    const unsigned n = n_++;
    v = (n % 2 == 1 ? -1 : 1) * (n + 0.25);
  }
  void put(float& v) {
    double wide = 0;
    put(wide);
    v = static_cast<float>(wide);
  }
  void put(std::uint32_t& v) { v = n_++ * 0x01020304U; }
  void put(std::uint64_t& v) { v = n_++ * 0x0102030405060708ULL; }
  void put(std::int32_t& v) { v = static_cast<std::int32_t>(n_++ * 0x01020304U); }
  void put(std::uint16_t& v) { v = static_cast<std::uint16_t>(n_++ * 257); }
  void put(std::int8_t& v) { v = static_cast<std::int8_t>(n_++); }
  void put(std::uint8_t& v) { v = static_cast<std::uint8_t>(n_++); }
  void put(char& v) { v = static_cast<char>(n_++); }
  void put(bool& v) { v = n_++ % 2 == 1; }
  void put(std::string& v) { v = std::string("abcdefgh").substr(0, n_++ % 9); }
  void put(eprosima::fastrtps::fixed_string<256>& v) {
    std::string text;
    put(text);
    v = text;
  }
  template <typename T, std::size_t size>
  void put(std::array<T, size>& v) {
    for (T& element : v) put(element);
  }
  template <typename T>
  void put(std::vector<T>& v) {
    v.resize(n_++ % 3);
    for (T& element : v) put(element);
  }

  // void put(std_msgs::msg::Header& m) { all(m.stamp(), m.frame_id()); } and so on: all there are.
#include "counted_fields.inc"

 private:
  template <typename... Field>
  void all(Field&... fields) {
    (put(fields), ...);
  }

  unsigned n_;
};

}  // namespace slackwater::tests
