#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "api/door/people/wire/bits.h"
#include "api/door/people/wire/counted_pose.h"

namespace slackwater::people {

/// What one station knows of the vehicles, and what it is told when they move: how far each number
/// is from what the station expects by what it was told before. Both reckon in whole numbers, so
/// that nothing adds up, however long. The bits are in api/docs/session_wire.md, "Moved".
///
/// A vehicle that is new, that halts, whose bed or battery comes to be known or unknown, whose
/// numbers are none or too large, or that jumps far, goes as a pose.
class Moved {
 public:
  /// The station knows nothing of the vehicles any more.
  void forget() noexcept { told_.clear(); }
  /// Looks at where the vehicles are; what was told stays as it is until `tell`.
  /// @param now  those that were told before at their places, then new ones
  /// @return whether a station would see anything new
  [[nodiscard]] bool look(std::span<const Pose> now, double time_s);
  /// Takes what was looked at for told. @return whether all vehicles go as poses
  bool tell(std::span<const Pose> now);
  /// Of the last `tell`: the vehicles that go as poses, and the bits of all the others.
  [[nodiscard]] std::span<const Pose> poses() const noexcept { return poses_; }
  [[nodiscard]] std::span<const std::uint8_t> bits() const noexcept { return bits_.bytes(); }

 private:
  struct Told {
    CountedPose pose;
    /// How far velocity and angles went with the last frame.
    std::array<std::int32_t, CountedPose::places> step{};
  };
  [[nodiscard]] bool put(Told& told, const CountedPose& now);
  [[nodiscard]] std::int64_t expected(const Told& told, const CountedPose& now,
                                      std::size_t number) const noexcept;

  std::vector<Told> told_;
  std::vector<CountedPose> now_;
  double told_ms_ = 0, now_ms_ = 0;          ///< of the run
  std::int32_t since_ms_ = 0, step_ms_ = 0;  ///< from one to the other; of the frame before
  bool is_whole_ = true;
  std::vector<Pose> poses_;
  BitWriter bits_;
};

}  // namespace slackwater::people
