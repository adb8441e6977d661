#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace slackwater::twin {

/// How near something came, and when.
struct Approach {
  double distance_m = std::numeric_limits<double>::infinity();
  double t_s = 0;
  std::string to;          ///< its name; empty: a vessel that nobody named
  std::uint32_t mmsi = 0;  ///< of a vessel
  friend bool operator==(const Approach&, const Approach&) = default;
};

/// How near a vehicle came to what was around it in a run, and to whom; nothing where there was
/// none of a kind. What is meant by each: twin/clearance/nearest_pass.h.
struct Closest {
  std::optional<Approach> vehicle;
  std::optional<Approach> structure;
  std::optional<Approach> vessel;  ///< of the traffic
  std::optional<Approach> tether;  ///< of another; `to` is that one
  friend bool operator==(const Closest&, const Closest&) = default;
};

}  // namespace slackwater::twin
