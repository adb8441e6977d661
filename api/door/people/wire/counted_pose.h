#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "api/door/people/wire/pose.h"

namespace slackwater::people {

/// A pose in whole numbers of small steps, so that a station can reckon with it to the bit. In the
/// order of api/docs/session_wire.md:
///
///   0-2   velocity east, north, up       1/100 m/s
///   3-5   roll, pitch, heading           1/16384 of a turn, from -8192 to 8191
///   6-8   place east, north, up          1/200 m
///   9-10  current east, north            1/100 m/s
///   11    the bed below, from mean sea level up   1/20 m; 0 where nobody knows it
///   12    charge                         1/2000; 0 without a battery
///
/// Each is floor(value * steps + 0.5) in double precision: what was a float is within half a step.
struct CountedPose {
  static constexpr std::size_t numbers = 13;
  static constexpr std::size_t angles = 3, places = 6, currents = 9, bed = 11, charge = 12;
  static constexpr std::int32_t turn = 16384, most = 1 << 26;

  std::array<std::int32_t, numbers> n{};
  bool is_countable = false;  ///< else a number is infinite, none, or beyond `most`
  bool has_bed = false, has_charge = false, is_halted = false;
  std::uint16_t vehicle = 0;

  /// Of the same vehicle, and the same but for its numbers.
  [[nodiscard]] bool is_like(const CountedPose& other) const noexcept {
    return vehicle == other.vehicle && is_countable && other.is_countable &&
           has_bed == other.has_bed && has_charge == other.has_charge &&
           is_halted == other.is_halted;
  }
  [[nodiscard]] bool is_known(std::size_t number) const noexcept {
    return number == bed ? has_bed : number != charge || has_charge;
  }
};

[[nodiscard]] CountedPose counted(const Pose& pose) noexcept;

/// Within half a turn to either side.
[[nodiscard]] std::int32_t wrapped(std::int64_t angle) noexcept;

}  // namespace slackwater::people
