#include "twin/mission/fault.h"

#include <array>
#include <limits>

#include "twin/mission/read_seconds.h"

namespace slackwater::twin {
namespace {

constexpr std::array kinds{FaultKind::lost_link, FaultKind::lost_gnss, FaultKind::lost_thruster,
                           FaultKind::fouled_tether};

Fault read_fault(const Config& config) {
  const std::string word = config.text("fault");
  Fault fault;
  bool is_known = false;
  for (const FaultKind kind : kinds) {
    if (word != name_of(kind)) continue;
    fault.kind = kind;
    is_known = true;
  }
  if (!is_known)
    config.refuse("fault", "found " + word +
                               ", expected lost_link, lost_gnss, lost_thruster or fouled_tether");
  constexpr double longest_s = 30 * 86400.0;
  fault.from_s = read_seconds(config, "at", {0, longest_s});
  fault.to_s = has_seconds(config, "for")
                   ? fault.from_s + read_seconds(config, "for", {0.001, longest_s})
                   : std::numeric_limits<double>::infinity();
  if (fault.kind == FaultKind::lost_thruster)
    fault.thruster = static_cast<std::size_t>(config.integer("thruster", 0, 15));
  return fault;
}

}  // namespace

const char* name_of(FaultKind kind) noexcept {
  switch (kind) {
    case FaultKind::lost_link:
      return "lost_link";
    case FaultKind::lost_gnss:
      return "lost_gnss";
    case FaultKind::lost_thruster:
      return "lost_thruster";
    case FaultKind::fouled_tether:
      return "fouled_tether";
  }
  return "unknown";
}

const Fault* fault_at(std::span<const Fault> faults, FaultKind kind, double t_s) noexcept {
  for (const Fault& fault : faults)
    if (fault.kind == kind && fault.is_on(t_s)) return &fault;
  return nullptr;
}

std::vector<Fault> read_faults(const Config& vehicle) {
  std::vector<Fault> faults;
  for (const Config& entry : vehicle.children("faults")) faults.push_back(read_fault(entry));
  return faults;
}

}  // namespace slackwater::twin
