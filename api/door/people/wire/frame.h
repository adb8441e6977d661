#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "api/door/people/wire/moved.h"
#include "api/door/people/wire/pose.h"

namespace slackwater::people {

/// When a frame was, and what it left out.
struct FrameHead {
  std::uint32_t number = 0;
  std::uint64_t step = 0;
  double time_s = 0;
  std::uint64_t clock_ms = 0;
  bool is_whole = false;
  std::uint32_t left_out = 0;
};

/// The bytes of `session.Frame`. @param moved  empty: it has none
[[nodiscard]] std::string encode_frame(const FrameHead& head, std::span<const Pose> poses,
                                       std::span<const std::uint8_t> moved = {});

/// The frames of one station: whole at first, then what has changed. A station that has not said
/// what it saw for a while gets none (`most_ahead`), and the next one has all that changed since.
/// One that is brief is told by the bits of `Moved` what has, else by poses.
class FrameFlow {
 public:
  static constexpr std::uint32_t most_ahead = 20;

  /// The next frame; empty: the station does not keep up, or nothing is new for it.
  [[nodiscard]] std::string next(std::span<const Pose> now, FrameHead head);
  /// From the next frame on, which is whole.
  void be_brief(bool is_brief) noexcept {
    is_brief_ = is_brief;
    begin_again();
  }
  [[nodiscard]] bool is_brief() const noexcept { return is_brief_; }
  /// What the station has is of another moment: the next frame is whole, and due at once.
  void begin_again() noexcept {
    sent_.clear();
    moved_.forget();
    is_due_ = true;
  }
  /// The station has lost track of what moved, but it is there.
  void lost() noexcept {
    seen_ = number_;
    begin_again();
  }
  /// @return whether there is such a frame
  bool saw(std::uint32_t frame) noexcept;
  /// Frames that were left out since it was asked last.
  [[nodiscard]] std::uint32_t take_left_out() noexcept;

 private:
  [[nodiscard]] bool is_idle(std::uint64_t clock_ms) const noexcept;
  [[nodiscard]] std::string next_changed(std::span<const Pose> now, FrameHead head);
  [[nodiscard]] std::string next_moved(std::span<const Pose> now, FrameHead head);
  [[nodiscard]] FrameHead numbered(FrameHead head) noexcept;

  bool is_brief_ = false;
  std::vector<Pose> sent_, changed_;
  Moved moved_;
  std::uint32_t number_ = 0, seen_ = 0;
  std::uint32_t left_out_ = 0;  ///< since the last frame
  std::uint32_t untold_ = 0;
  std::uint64_t sent_ms_ = 0;
  bool is_due_ = false;
};

}  // namespace slackwater::people
