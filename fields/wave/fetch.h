#pragma once
#include <string>
#include <vector>

namespace slackwater {

/// Winds from one range of directions, and how far they have blown over water.
struct FetchSector {
  /// Directions the wind comes from, clockwise from true north: from `from_deg` clockwise to
  /// `to_deg`, which is not included. 0 to 360 is the whole circle.
  double from_deg = 0;
  double to_deg = 360;
  double fetch_m = 0;  ///< > 0

  bool operator==(const FetchSector&) const = default;
};

/// How far the wind has blown over open water when it reaches a place, by where it comes from.
class Fetch {
 public:
  /// The same from all sides, > 0.
  explicit Fetch(double fetch_m);
  /// Throws Error(invalid_input) unless every direction lies in one sector and no more.
  explicit Fetch(std::vector<FetchSector> sectors);

  [[nodiscard]] double at_m(double wind_from_direction_deg) const noexcept;
  [[nodiscard]] double shortest_m() const noexcept;
  [[nodiscard]] double longest_m() const noexcept;
  [[nodiscard]] Fetch times(double factor) const;
  /// "200 km", or "5 to 400 km by the direction of the wind".
  [[nodiscard]] std::string text() const;

  bool operator==(const Fetch&) const = default;

 private:
  std::vector<FetchSector> sectors_;  ///< clockwise, each ends where the next begins
};

}  // namespace slackwater
