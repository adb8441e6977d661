#include "api/door/dds/intake/parameters.h"

#include <algorithm>

#include "api/door/dds/intake/cursor.h"

namespace slackwater::dds {
namespace {

// 9.6.2.2.2.
constexpr std::uint16_t the_end = 0x0001;
constexpr std::uint16_t participant_lease = 0x0002;
constexpr std::uint16_t participant_guid = 0x0050;
constexpr std::uint16_t endpoint_guid = 0x005A;

struct Parameter {
  std::uint16_t id = the_end;
  std::size_t at = 0;  ///< of its value
  std::span<const std::uint8_t> value;
};

/// The next one; nothing where it does not fit in.
std::optional<Parameter> next_parameter(std::span<const std::uint8_t> bytes, bool is_little_endian,
                                        std::size_t& at) noexcept {
  Cursor head(bytes.subspan(at), is_little_endian);
  Parameter next;
  next.id = head.u16();
  const std::size_t length = head.u16();
  if (!head.is_good()) return std::nullopt;
  next.at = at + 4;
  at = next.at;
  if (next.id == the_end) return next;  // whatever its length
  if (length % 4 != 0 || length > bytes.size() - next.at) return std::nullopt;
  next.value = bytes.subspan(next.at, length);
  at += length;
  return next;
}

}  // namespace

std::size_t end_of_parameters(std::span<const std::uint8_t> bytes, bool is_little_endian) noexcept {
  for (std::size_t at = 0;;) {
    const auto next = next_parameter(bytes, is_little_endian, at);
    if (!next) return 0;
    if (next->id == the_end) return at;
  }
}

bool is_parameter_list(std::span<const std::uint8_t> sample) noexcept {
  return sample.size() >= 4 && sample[0] == 0 && (sample[1] == 2 || sample[1] == 3);
}

Announced read_announced(std::span<const std::uint8_t> sample, const Prefix& sender) noexcept {
  Announced told;
  if (!is_parameter_list(sample)) return told;
  told.is_little_endian = sample[1] == 3;
  for (std::size_t at = 4;;) {
    const auto next = next_parameter(sample, told.is_little_endian, at);
    if (!next) return Announced{};
    if (next->id == the_end) break;
    if (next->id == participant_lease && next->value.size() >= 8) told.lease_at = next->at;
    const bool says_whose = next->id == participant_guid || next->id == endpoint_guid;
    if (!says_whose) continue;
    told.is_of_sender = told.is_of_sender && next->value.size() >= 16 &&
                        std::equal(sender.begin(), sender.end(), next->value.begin());
  }
  told.is_list = true;
  return told;
}

}  // namespace slackwater::dds
