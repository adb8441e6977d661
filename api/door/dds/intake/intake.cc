#include "api/door/dds/intake/intake.h"

#include "fields/base/text.h"

namespace slackwater::dds {
namespace {

/// Who heard of a participant for the last time this long ago forgets it, whatever lease it asked
/// for: what is made up does not stay.
constexpr std::uint32_t most_lease_s = 100;

/// A copy with shorter leases, where it asks for longer ones.
Intake::Payload with_short_leases(Intake::Payload bytes, const Datagram& datagram,
                                  Intake::Bytes& changed) {
  bool is_changed = false;
  for (std::size_t k = 0; k < datagram.leases; ++k) {
    const Datagram::Lease& lease = datagram.lease[k];
    const auto place = [&](unsigned i) { return lease.at + (lease.is_little_endian ? i : 3 - i); };
    std::uint32_t asked_s = 0;
    for (unsigned i = 0; i < 4; ++i) asked_s |= std::uint32_t{bytes[place(i)]} << (8 * i);
    if (asked_s <= most_lease_s) continue;
    if (!is_changed) changed.assign(bytes.begin(), bytes.end());
    is_changed = true;
    for (unsigned i = 0; i < 4; ++i)
      changed[place(i)] = static_cast<std::uint8_t>(most_lease_s >> (8 * i));
  }
  return is_changed ? Intake::Payload(changed) : bytes;
}

}  // namespace

Intake::Payload Intake::admit(Payload bytes, const Source& source, Bytes& changed, Time now) {
  const Datagram datagram = read_datagram(bytes);
  const std::lock_guard lock(mutex_);
  if (!datagram.fault.empty()) {
    shed(no_rtps, datagram.fault, source, now);
    return {};
  }
  if (datagram.from == own_) return {};
  if (const auto kind = refused(bytes, datagram, now)) {
    shed(*kind, {}, source, now);
    return {};
  }
  return with_short_leases(bytes, datagram, changed);
}

std::optional<Intake::Kind> Intake::refused(Payload bytes, const Datagram& datagram, Time now) {
  if (!known_.contains(datagram.from)) {
    // Of who did not announce itself the library hears nothing else either.
    if (!datagram.is_announcement) return strangers;
    if (known_.size() >= most_participants) return crowd;
    return newcomers_.take(1, now) ? std::nullopt : std::optional(rush);
  }
  if (!discovery_bytes_.take(static_cast<double>(datagram.discovery_bytes), now)) return discovery;
  if (!skipped_.take(static_cast<double>(datagram.skipped), now)) return gaps;
  if (datagram.has_pieces && !takes_pieces(bytes, now)) return pieces;
  return std::nullopt;
}

bool Intake::takes_pieces(Payload bytes, Time now) {
  bool takes = true;
  for_each_piece(bytes, [&](const Piece& piece) {
    if (!takes) return;
    const auto found = begun_.look(piece);
    const bool is_fresh = found == BegunSamples::Found::fresh;
    takes =
        is_fresh ? begun_bytes_.take(piece.sample_bytes, now) : found == BegunSamples::Found::known;
    if (takes && is_fresh) begun_.remember(piece);
  });
  return takes;
}

void Intake::be(const Prefix& own) {
  const std::lock_guard lock(mutex_);
  own_ = own;
}

void Intake::found(const Prefix& participant) {
  const std::lock_guard lock(mutex_);
  known_.insert(participant);
}

void Intake::lost(const Prefix& participant) {
  const std::lock_guard lock(mutex_);
  known_.erase(participant);
  begun_.forget(participant);
}

void Intake::shed(Kind kind, std::string_view fault, const Source& source, Time now) {
  Shed& shed = shed_[kind];
  ++shed.count;
  // Of peers that are about to be found, or were just lost, there are always some.
  constexpr std::uint64_t most_unsaid = 10'000;
  if (kind == strangers && shed.count < most_unsaid) return;
  // At once, and then ever more rarely: it may go on for days.
  constexpr std::chrono::seconds quiet(10);
  if (shed.told > 0 && (shed.count < 2 * shed.told || now - shed.told_at < quiet)) return;
  shed.last = source() + (fault.empty() ? "" : ": " + std::string(fault));
  shed.told = shed.count;
  shed.told_at = now;
  tell_(text(kind, shed));
}

void Intake::tell_rest() {
  const std::lock_guard lock(mutex_);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    Shed& shed = shed_[kind];
    if (shed.told == shed.count || shed.last.empty()) continue;
    shed.told = shed.count;
    tell_(text(static_cast<Kind>(kind), shed));
  }
}

std::string Intake::text(Kind kind, const Shed& shed) {
  static_assert(most_participants == 256);
  constexpr std::array<std::string_view, kinds> why{
      "That is no RTPS that a peer sends",
      "256 participants are heard, and no more: others wait until some have left",
      "More new participants announce themselves than are looked at at a time: they are heard "
      "later",
      "They are from participants that are not heard, as far as that is true",
      "Participants tell of more readers and writers than are looked at at a time",
      "They say that more samples are lost than are counted at a time",
      "They are pieces of samples that contradict each other, or of more than there is room for"};
  return formatted(
      "DDS: {} datagram{} shed so far, as one from {}. {}; keep strangers out (--loopback, "
      "--interface, a firewall)",
      shed.count, shed.count == 1 ? "" : "s", shed.last, why[kind]);
}

}  // namespace slackwater::dds
