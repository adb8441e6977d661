#include "api/door/dds/intake/datagram.h"

#include <algorithm>

#include "api/door/dds/intake/cursor.h"
#include "api/door/dds/intake/parameters.h"

namespace slackwater::dds {
namespace {

constexpr std::size_t header_bytes = 20;
constexpr std::uint32_t announcing_writer = 0x000100C2;

// Kinds of submessages (9.4.5.1.1).
enum : std::uint8_t {
  pad = 0x01,
  acknack = 0x06,
  heartbeat = 0x07,
  gap = 0x08,
  info_ts = 0x09,
  info_src = 0x0C,
  info_reply_ip4 = 0x0D,
  info_dst = 0x0E,
  info_reply = 0x0F,
  nack_frag = 0x12,
  heartbeat_frag = 0x13,
  data = 0x15,
  data_frag = 0x16,
  secured_first = 0x30,  // DDS Security 1.1, 7.3.6.2
  secured_last = 0x3F,
  statistics = 0x80,  // of Fast DDS; other vendors' is another thing
};

/// Of a writer or reader that tells of others (9.3.1.2): 0xC0 in its kind.
bool is_of_discovery(std::uint32_t entity) noexcept { return (entity & 0xC0U) == 0xC0U; }

struct Submessage {
  std::uint8_t kind = 0;
  std::uint8_t flags = 0;
  std::size_t at = 0;  ///< of its body in the datagram
  Cursor body;
  bool is_last = false;
  [[nodiscard]] bool is_little_endian() const noexcept { return (flags & 1U) != 0; }
};

/// The next one, or nothing where it does not fit in.
std::optional<Submessage> next_submessage(std::span<const std::uint8_t> bytes, std::size_t& at) {
  constexpr std::size_t head = 4;
  if (bytes.size() - at < head) return std::nullopt;
  Submessage next;
  next.kind = bytes[at];
  next.flags = bytes[at + 1];
  Cursor length_of(bytes.subspan(at + 2, 2), next.is_little_endian());
  std::size_t length = length_of.u16();
  next.at = at + head;
  const std::size_t rest = bytes.size() - next.at;
  // The last may leave it to its datagram where it ends.
  if (length == 0 && next.kind != info_ts && next.kind != pad) length = rest;
  if (length > rest) return std::nullopt;
  next.body = Cursor(bytes.subspan(next.at, length), next.is_little_endian());
  next.is_last = length == rest;
  at = std::min(next.at + (length + 3) / 4 * 4, bytes.size());
  return next;
}

std::int64_t most_of(std::uint32_t writer) noexcept {
  return is_of_discovery(writer) ? most_discovery_samples : most_samples;
}

/// What is told of a reader or writer takes so much to remember, however short it is.
constexpr std::size_t least_told_bytes = 512;

constexpr std::string_view too_short = "a part that is too short for what it is";
constexpr std::string_view no_list = "a list of parameters without an end";
constexpr std::string_view no_set = "a set of more than 256 numbers, or without them";
constexpr std::string_view no_number = "the number of a sample that no peer comes to";

/// A set of numbers, of which at most 256 are told (9.4.2.6). @return whether it is one
bool pass_set(Cursor& body) noexcept {
  constexpr std::uint32_t most_bits = 256;
  const std::uint32_t bits = body.u32();
  if (bits > most_bits) return false;
  body.skip(std::size_t{(bits + 31) / 32} * 4);
  return body.is_good();
}

class Reading {
 public:
  Reading(Datagram& made, bool is_of_fast_dds) : made_(made), is_of_fast_dds_(is_of_fast_dds) {}

  /// @return the fault
  std::string_view read(Submessage& part) {
    switch (part.kind) {
      case data:
        return read_data(part);
      case data_frag:
      case heartbeat:
      case gap:
      case acknack:
      case nack_frag:
      case heartbeat_frag:
        says_more_ = true;
        return read_of_samples(part);
      case info_dst:
        return expect_bytes(part.body, 12);
      case info_ts:
        return (part.flags & 2U) != 0 ? std::string_view{} : expect_bytes(part.body, 8);
      case info_src:
        return "a part that speaks for another participant";
      case statistics:
        return part.is_last || !is_of_fast_dds_ ? std::string_view{}
                                                : "statistics that are not the last";
      default:
        return part.kind >= secured_first && part.kind <= secured_last
                   ? "a part of DDS Security, which is not in use"
                   : std::string_view{};
    }
  }
  void end() noexcept { made_.is_announcement = is_announced_ && !says_more_; }

 private:
  std::string_view read_of_samples(Submessage& part) {
    switch (part.kind) {
      case data_frag:
        return read_piece(part);
      case heartbeat:
        return read_heartbeat(part.body);
      case gap:
        return read_gap(part.body);
      case acknack:
        return read_acknack(part.body);
      case nack_frag:
        return read_nack_frag(part.body);
      default:  // HEARTBEAT_FRAG
        return expect_bytes(part.body, 24);
    }
  }
  static std::string_view expect_bytes(Cursor& body, std::size_t count) noexcept {
    body.skip(count);
    return body.is_good() ? std::string_view{} : too_short;
  }

  /// What DATA and DATA_FRAG begin with.
  struct Head {
    std::uint32_t writer = 0;
    std::int64_t number = 0;
    std::size_t to_inline_qos = 0;  ///< from behind its own field
  };
  static std::string_view read_head(Cursor& body, Head& head) noexcept {
    body.skip(2);  // further flags
    head.to_inline_qos = body.u16();
    body.skip(4);  // the reader
    head.writer = body.entity();
    head.number = body.number();
    if (!body.is_good()) return too_short;
    return head.number < 1 || head.number > most_of(head.writer) ? no_number : std::string_view{};
  }
  /// @param told  octets of the head from behind the field that says where the rest begins
  static std::string_view pass_to_payload(Submessage& part, const Head& head, std::size_t told) {
    if (head.to_inline_qos < told) return "a part that overlaps its own head";
    part.body.skip(head.to_inline_qos - told);
    if (!part.body.is_good()) return too_short;
    if ((part.flags & 2U) == 0) return {};
    const std::size_t length = end_of_parameters(part.body.rest(), part.is_little_endian());
    if (length == 0) return no_list;
    part.body.skip(length);
    return {};
  }

  std::string_view read_data(Submessage& part) {
    Head head;
    if (const auto fault = read_head(part.body, head); !fault.empty()) return fault;
    if (const auto fault = pass_to_payload(part, head, 16); !fault.empty()) return fault;
    const bool has_sample = (part.flags & 4U) != 0, has_key = (part.flags & 8U) != 0;
    if (has_sample && has_key) return "a sample that is a key as well";
    const auto payload = part.body.rest();
    if ((has_sample || has_key) && payload.size() < 4) return "a sample of nothing";
    if (head.writer == announcing_writer) {
      is_announced_ = true;
      return has_sample ? read_announcement(part, payload) : std::string_view{};
    }
    says_more_ = true;
    if (!is_of_discovery(head.writer)) return {};
    made_.discovery_bytes += std::max(payload.size(), least_told_bytes);
    return has_sample ? read_discovery(payload) : std::string_view{};
  }

  std::string_view read_announcement(const Submessage& part,
                                     std::span<const std::uint8_t> payload) {
    const Announced told = read_announced(payload, made_.from);
    if (!told.is_list) return no_list;
    if (!told.is_of_sender) return "an announcement of another participant";
    if (told.lease_at) {
      if (made_.leases == Datagram::most_leases) return "announcements without end";
      const std::size_t before = part.at + part.body.at();
      made_.lease[made_.leases++] = {before + *told.lease_at, told.is_little_endian};
    }
    return {};
  }
  std::string_view read_discovery(std::span<const std::uint8_t> payload) const {
    if (!is_parameter_list(payload)) return {};
    const Announced told = read_announced(payload, made_.from);
    if (!told.is_list) return no_list;
    return told.is_of_sender ? std::string_view{} : "what another participant has";
  }

  std::string_view read_piece(Submessage& part) {
    Head head;
    if (const auto fault = read_head(part.body, head); !fault.empty()) return fault;
    const std::uint32_t first = part.body.u32();
    const std::uint32_t count = part.body.u16(), piece_bytes = part.body.u16();
    const std::uint32_t sample_bytes = part.body.u32();
    if (!part.body.is_good()) return too_short;
    if (const auto fault = pass_to_payload(part, head, 28); !fault.empty()) return fault;
    const std::uint32_t most =
        is_of_discovery(head.writer) ? most_discovery_sample_bytes : most_sample_bytes;
    if (sample_bytes < 1 || sample_bytes > most) return "a sample of more than there is room for";
    if (piece_bytes < least_piece_bytes) return "a sample in crumbs";
    const std::uint64_t pieces = (sample_bytes + piece_bytes - 1ULL) / piece_bytes;
    if (first < 1 || count < 1 || first - 1ULL + count > pieces) return "a piece of no sample";
    const unsigned long long begin = (first - 1ULL) * piece_bytes;
    const std::uint64_t sent = std::min(1ULL * count * piece_bytes, sample_bytes - begin);
    if (part.body.rest().size() < sent) return "less of a sample than it says";
    made_.has_pieces = true;
    if (is_of_discovery(head.writer)) made_.discovery_bytes += sent;
    return {};
  }

  static std::string_view read_heartbeat(Cursor& body) noexcept {
    body.skip(4);
    const std::uint32_t writer = body.entity();
    const std::int64_t first = body.number(), last = body.number();
    (void)body.u32();
    if (!body.is_good()) return too_short;
    return first < 1 || last < first - 1 || last > most_of(writer) ? no_number : std::string_view{};
  }
  std::string_view read_gap(Cursor& body) noexcept {
    body.skip(4);
    const std::uint32_t writer = body.entity();
    const std::int64_t start = body.number(), base = body.number();
    if (!body.is_good()) return too_short;
    if (start < 1 || base < start || base > most_of(writer)) return no_number;
    if (!pass_set(body)) return no_set;
    made_.skipped += static_cast<std::uint64_t>(base - start);
    return {};
  }
  static std::string_view read_acknack(Cursor& body) noexcept {
    body.skip(8);
    if (body.number() < 0) return body.is_good() ? no_number : too_short;
    if (!pass_set(body)) return no_set;
    return expect_bytes(body, 4);
  }
  static std::string_view read_nack_frag(Cursor& body) noexcept {
    body.skip(8);
    if (body.number() < 1) return body.is_good() ? no_number : too_short;
    body.skip(4);
    if (!pass_set(body)) return no_set;
    return expect_bytes(body, 4);
  }

  Datagram& made_;
  const bool is_of_fast_dds_;
  bool is_announced_ = false;
  bool says_more_ = false;  ///< than that the participant is there
};

}  // namespace

Datagram read_datagram(std::span<const std::uint8_t> bytes) noexcept {
  Datagram made;
  constexpr std::array<std::uint8_t, 5> begin = {'R', 'T', 'P', 'S', 2};
  if (bytes.size() < header_bytes || !std::equal(begin.begin(), begin.end(), bytes.begin())) {
    made.fault = "it does not begin as RTPS 2 does";
    return made;
  }
  std::copy_n(bytes.begin() + 8, made.from.size(), made.from.begin());
  if (bytes.size() == header_bytes) made.fault = "it says nothing";
  Reading reading(made, bytes[6] == 1 && bytes[7] == 15);
  for (std::size_t at = header_bytes; at < bytes.size() && made.fault.empty();) {
    if (auto part = next_submessage(bytes, at))
      made.fault = reading.read(*part);
    else
      made.fault = "a part that is longer than the rest";
  }
  reading.end();
  return made;
}

void for_each_piece(std::span<const std::uint8_t> bytes,
                    const std::function<void(const Piece&)>& visit) {
  Piece piece;
  std::copy_n(bytes.begin() + 8, piece.from.size(), piece.from.begin());
  for (std::size_t at = header_bytes; at < bytes.size();) {
    auto part = next_submessage(bytes, at);
    if (!part) return;
    if (part->kind != data_frag) continue;
    part->body.skip(8);
    piece.writer = part->body.entity();
    piece.number = part->body.number();
    part->body.skip(6);
    piece.piece_bytes = part->body.u16();
    piece.sample_bytes = part->body.u32();
    visit(piece);
  }
}

}  // namespace slackwater::dds
