#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace slackwater::twin {

/// The class of a value: how many of the edges it has reached. Edges 4 and 8 make three classes,
/// below 4, from 4 and below 8, and 8 and above.
/// @param edges  ascending  @param value  not NaN
[[nodiscard]] std::size_t class_of(double value, std::span<const double> edges) noexcept;

/// The sector of a direction. Sectors are of one width, the first has its middle at north, and each
/// holds its left edge: of twelve the first is [345, 15) degrees.
/// @param direction_deg  clockwise from north, of any turn  @param sectors  1 at least
[[nodiscard]] std::size_t sector_of(double direction_deg, std::size_t sectors) noexcept;

/// How a rose is divided.
struct RoseClasses {
  std::size_t sectors = 12;
  /// What is less, or nothing at all, is a calm: its direction says nothing.
  double calm = 0;
  std::vector<double> edges;  ///< of the classes, ascending, above `calm`
};

/// How many steps of a series had a direction and a size (speed or height) in each sector and
/// class. Every step is one of these: in a sector, a calm, without a direction, or missing.
struct Rose {
  std::vector<std::vector<std::size_t>> sectors;  ///< by sector from north clockwise, by class
  std::size_t calm = 0;
  std::size_t no_direction = 0;  ///< no calm, and nobody says from where or to where
  std::size_t missing = 0;       ///< nobody knows the size: no calm, and in no share

  [[nodiscard]] std::size_t in_sector(std::size_t sector) const;
  [[nodiscard]] std::size_t in_class(std::size_t size_class) const;
  /// Steps that shares are of: all but those that are missing.
  [[nodiscard]] std::size_t known() const;
};

/// @param sizes, directions_deg  of the same length; NaN where nobody knows
[[nodiscard]] Rose rose_of(std::span<const double> sizes, std::span<const double> directions_deg,
                           const RoseClasses& classes);

}  // namespace slackwater::twin
