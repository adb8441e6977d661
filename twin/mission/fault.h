#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::twin {

/// What can fail in a mission. Each does something to the vehicle, and is known to it.
enum class FaultKind {
  lost_link,      ///< nobody can steer it, and it can tell nobody
  lost_gnss,      ///< its receiver has no fix
  lost_thruster,  ///< one of them gives nothing
  fouled_tether,  ///< the line is caught at the node that is nearest to a structure
};
/// lost_link, lost_gnss, lost_thruster, fouled_tether.
[[nodiscard]] const char* name_of(FaultKind kind) noexcept;

/// A fault that is put into a run.
struct Fault {
  FaultKind kind{};
  double from_s = 0;         ///< since the start of the run
  double to_s = 0;           ///< infinite: it stays
  std::size_t thruster = 0;  ///< that is lost, by its place among the mounts
  bool operator==(const Fault&) const = default;

  [[nodiscard]] bool is_on(double t_s) const noexcept { return t_s >= from_s && t_s < to_s; }
};

/// The first of a kind that is on; null: none is.
[[nodiscard]] const Fault* fault_at(std::span<const Fault> faults, FaultKind kind,
                                    double t_s) noexcept;

/// `faults` of a vehicle's YAML, a list of
///
///     {fault: lost_thruster, at: 10min, thruster: 2}      {fault: lost_link, at: 5min, for: 2min}
///
/// @throws Error(invalid_input)
[[nodiscard]] std::vector<Fault> read_faults(const Config& vehicle);

}  // namespace slackwater::twin
