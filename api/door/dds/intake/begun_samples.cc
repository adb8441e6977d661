#include "api/door/dds/intake/begun_samples.h"

namespace slackwater::dds {

BegunSamples::Found BegunSamples::look(const Piece& piece) {
  const std::pair writer{piece.from, piece.writer};
  if (const auto of = writers_.find(writer); of != writers_.end()) {
    if (const auto known = of->second.find(piece.number); known != of->second.end()) {
      const bool is_the_same = known->second.piece_bytes == piece.piece_bytes &&
                               known->second.sample_bytes == piece.sample_bytes;
      return is_the_same ? Found::known : Found::refused;
    }
  }
  if (count_ == most) return Found::refused;
  ByNumber& samples = writers_[writer];
  if (samples.size() == most_of_a_writer) {
    // The oldest makes room. From then on there are as many, so that it stays refused.
    if (piece.number < samples.begin()->first) return Found::refused;
    samples.erase(samples.begin());
    --count_;
  }
  samples.emplace(piece.number, piece);
  ++count_;
  return Found::begun;
}

void BegunSamples::forget(const Prefix& participant) {
  const auto first = writers_.lower_bound({participant, 0});
  auto last = first;
  for (; last != writers_.end() && last->first.first == participant; ++last)
    count_ -= last->second.size();
  writers_.erase(first, last);
}

}  // namespace slackwater::dds
