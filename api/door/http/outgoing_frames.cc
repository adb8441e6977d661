#include "api/door/http/outgoing_frames.h"

#include <algorithm>
#include <utility>

namespace slackwater::api::http {
namespace {

/// What a frame takes of the memory beside its bytes, so that many small ones are bounded too.
constexpr std::size_t frame_overhead_bytes = 96;
constexpr std::size_t essential_factor = 8;

std::size_t cost_of(const Frame& frame) { return frame.size() + frame_overhead_bytes; }

}  // namespace

Frame OutgoingFrames::taken_from(Line& line) {
  Frame frame = std::move(line.frames.front().frame);
  line.frames.pop_front();
  line.bytes -= cost_of(frame);
  return frame;
}

OutgoingFrames::Pushed OutgoingFrames::push(Frame frame) {
  Line& best_effort = line_of(Worth::best_effort);
  Line& reliable = line_of(Worth::reliable);
  Line& line = line_of(frame.worth);
  const std::size_t cost = cost_of(frame);
  Pushed pushed;
  if (frame.worth == Worth::essential) {
    pushed.is_overrun = !line.frames.empty() && line.bytes + cost > essential_factor * bound_bytes_;
    if (pushed.is_overrun) return pushed;
  } else {
    const bool has_no_room = !reliable.frames.empty() && reliable.bytes + cost > bound_bytes_;
    if (frame.worth == Worth::best_effort && has_no_room) return {1, false};
    const auto is_full = [&] { return best_effort.bytes + reliable.bytes + cost > bound_bytes_; };
    while (is_full() && !best_effort.frames.empty()) {
      taken_from(best_effort);
      ++pushed.dropped;
    }
    while (is_full() && !reliable.frames.empty()) {
      taken_from(reliable);
      ++pushed.dropped;
    }
  }
  line.frames.push_back({serial_++, std::move(frame)});
  line.bytes += cost;
  return pushed;
}

std::optional<Frame> OutgoingFrames::pop() {
  Line* oldest = nullptr;
  for (Line& line : lines_) {
    if (line.frames.empty()) continue;
    if (oldest == nullptr || line.frames.front().serial < oldest->frames.front().serial) {
      oldest = &line;
    }
  }
  if (oldest == nullptr) return std::nullopt;
  return taken_from(*oldest);
}

void OutgoingFrames::clear() { lines_ = {}; }

bool OutgoingFrames::empty() const noexcept {
  return std::all_of(lines_.begin(), lines_.end(),
                     [](const Line& line) { return line.frames.empty(); });
}

std::size_t OutgoingFrames::bytes() const noexcept {
  std::size_t bytes = 0;
  for (const Line& line : lines_) bytes += line.bytes;
  return bytes;
}

}  // namespace slackwater::api::http
