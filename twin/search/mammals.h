#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/numbers/random.h"
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// How a kind of animal shows itself. The times between are exponential with these means.
struct MammalKind {
  std::string name;
  double surfaces_every_s = 0;
  double calls_every_s = 0;
  double speed_m_s = 0;
  double turns_every_s = 0;
  bool operator==(const MammalKind&) const = default;
};

/// Reads data/mammals/NAME.yaml: name, source, status, surfaces_every_s, calls_every_s, speed_m_s,
/// turns_every_s. @throws Error(invalid_input)
[[nodiscard]] MammalKind read_mammal(const std::string& name,
                                     const std::filesystem::path& data_folder);

/// Animals about a place.
struct Mammals {
  MammalKind kind;
  double north_m = 0;
  double east_m = 0;
  double half_side_m = 0;  ///< of the square they swim in; who leaves it comes in on the other side
  std::size_t count = 0;
};
struct Mammal {
  Triple<double> position_m;  ///< NED
  double course_rad = 0;
  double surfaced = 0;  ///< 1: in the last step
  double called = 0;    ///< the same
};
struct MammalsState {
  std::vector<Mammal> animals;
  Rng rng{0, ""};
};

/// Anywhere in the square, on any course.
[[nodiscard]] MammalsState begin_swim(const Mammals& mammals, Rng rng);

/// Swims on, straight but for turns to any course. The same whoever looks: no draw is of a
/// watcher's.
void swim(const Mammals& mammals, double dt_s, MammalsState& state) noexcept;

/// How many are within `radius_m` of a place, in the plane.
[[nodiscard]] std::size_t count_within(const MammalsState& state, const Triple<double>& place_m,
                                       double radius_m) noexcept;

}  // namespace slackwater::twin
