#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "api/door/http/websocket.h"

namespace slackwater::api::http {

/// What waits to be sent to one client, in order and bounded, whatever the client takes in. One
/// thread at a time.
///
/// Full, the queue loses the oldest best-effort frames, then the oldest reliable ones; a
/// best-effort frame never displaces a reliable one. Essential frames have eight times the bound
/// to themselves: who does not even take those in is lost.
class OutgoingFrames {
 public:
  /// @param bound_bytes  of what is not essential, with what a frame costs by itself; one frame
  ///                     larger than that is taken where no other waits
  explicit OutgoingFrames(std::size_t bound_bytes) : bound_bytes_(bound_bytes) {}

  struct Pushed {
    std::size_t dropped = 0;  ///< frames, the new one perhaps among them
    bool is_overrun = false;  ///< an essential frame found no room
  };
  Pushed push(Frame frame);
  /// The oldest; nothing where none waits.
  [[nodiscard]] std::optional<Frame> pop();
  void clear();

  [[nodiscard]] bool empty() const noexcept;
  /// Of all that wait, with what each costs by itself.
  [[nodiscard]] std::size_t bytes() const noexcept;

 private:
  struct Waiting {
    std::uint64_t serial = 0;
    Frame frame;
  };
  struct Line {
    std::deque<Waiting> frames;
    std::size_t bytes = 0;
  };
  [[nodiscard]] Line& line_of(Worth worth) { return lines_.at(static_cast<std::size_t>(worth)); }
  Frame taken_from(Line& line);

  std::size_t bound_bytes_;
  std::array<Line, 3> lines_;  ///< by worth
  std::uint64_t serial_ = 0;
};

}  // namespace slackwater::api::http
