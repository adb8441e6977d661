#include <algorithm>

#include "api/door/dds/intake/intake.h"
#include "tests/fuzz/fuzz_case.h"

namespace {

using namespace slackwater;
using namespace slackwater::dds;

/// @return how many; all of them agree with the limits
std::size_t check_pieces(Intake::Payload bytes) {
  std::size_t count = 0;
  for_each_piece(bytes, [&](const Piece& piece) {
    ++count;
    fuzz::claim(piece.number >= 1 && piece.number <= most_samples, "a number out of range");
    fuzz::claim(piece.piece_bytes >= least_piece_bytes, "crumbs");
    fuzz::claim(piece.sample_bytes >= 1 && piece.sample_bytes <= most_sample_bytes,
                "a sample out of range");
  });
  return count;
}

void check_sound(Intake::Payload bytes, const Datagram& read) {
  fuzz::claim(check_pieces(bytes) > 0 == read.has_pieces, "pieces that are told of otherwise");
  for (std::size_t k = 0; k < read.leases; ++k)
    fuzz::claim(read.lease[k].at + 4 <= bytes.size(), "a lease beyond its datagram");
}

/// What the library sees is what came, but for the seconds of a lease.
void check_let_in(Intake::Payload bytes, const Datagram& read, Intake::Payload let_in) {
  if (let_in.empty()) return;
  fuzz::claim(read.fault.empty(), "what is faulty is let in");
  fuzz::claim(let_in.size() == bytes.size(), "another length is let in");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bool is_lease = false;
    for (std::size_t k = 0; k < read.leases; ++k)
      is_lease = is_lease || (i >= read.lease[k].at && i < read.lease[k].at + 4);
    fuzz::claim(is_lease || bytes[i] == let_in[i], "other octets are let in");
  }
  if (read.leases > 0) {
    const auto again = read_datagram(let_in);
    fuzz::claim(
        again.fault.empty() && again.leases == read.leases && again.lease[0].at == read.lease[0].at,
        "a shorter lease makes another datagram");
  }
}

}  // namespace

/// A datagram, from a stranger and then from a participant that is there, twice.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Intake::Payload bytes(data, size);
  fuzz::accepts([&] {
    const Datagram read = read_datagram(bytes);
    if (read.fault.empty()) check_sound(bytes, read);
    Intake intake([](const std::string& text) { fuzz::claim(text.size() > 20, "few words"); });
    const Intake::Time now{std::chrono::hours(1)};
    Intake::Bytes changed;
    const auto admit = [&] {
      const auto let_in = intake.admit(
          bytes, [] { return std::string("here"); }, changed, now);
      check_let_in(bytes, read, let_in);
      return !let_in.empty();
    };
    const bool is_let_in = admit();
    fuzz::claim(!is_let_in || read.is_announcement, "a stranger is heard");
    intake.found(read.from);
    const bool is_first_heard = admit();
    fuzz::claim(!read.is_announcement || is_first_heard == is_let_in, "an announcement is lost");
    fuzz::claim(is_first_heard || !admit(), "what was refused is let in");
    intake.tell_rest();
  });
  return 0;
}
