#include "api/door/dds/intake/begun_samples.h"

#include <algorithm>

namespace slackwater::dds {

BegunSamples::Found BegunSamples::look(const Piece& piece) const {
  const auto of = of_.find(piece.from);
  if (of == of_.end()) return Found::fresh;
  const auto writer = of->second.writers.find(piece.writer);
  if (writer == of->second.writers.end())
    return of->second.writers.size() < most_of_a_participant ? Found::fresh : Found::refused;
  const OfWriter& own = writer->second;
  if (piece.number <= own.made_room) return Found::refused;
  if (const auto known = own.samples.find(piece.number); known != own.samples.end()) {
    const bool is_the_same = known->second.piece_bytes == piece.piece_bytes &&
                             known->second.sample_bytes == piece.sample_bytes;
    return is_the_same ? Found::known : Found::refused;
  }
  // It would be the one that makes room.
  if (own.samples.size() == most_of_a_writer && piece.number < own.samples.begin()->first)
    return Found::refused;
  return Found::fresh;
}

void BegunSamples::OfWriter::make_room() {
  made_room = samples.begin()->first;
  samples.erase(samples.begin());
}

void BegunSamples::remember(const Piece& piece) {
  OfParticipant& of = of_[piece.from];
  OfWriter& own = of.writers[piece.writer];
  OfWriter* full = own.samples.size() == most_of_a_writer ? &own : nullptr;
  if (full == nullptr && of.samples == most_of_a_participant)
    full =
        &std::max_element(of.writers.begin(), of.writers.end(), [](const auto& a, const auto& b) {
           return a.second.samples.size() < b.second.samples.size();
         })->second;
  if (full != nullptr)
    full->make_room();
  else
    ++of.samples;
  own.samples.emplace(piece.number, piece);
}

}  // namespace slackwater::dds
