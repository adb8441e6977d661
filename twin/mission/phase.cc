#include "twin/mission/phase.h"

namespace slackwater::twin {

const char* name_of(Phase phase) noexcept {
  switch (phase) {
    case Phase::transit:
      return "transit";
    case Phase::launch:
      return "launch";
    case Phase::work:
      return "work";
    case Phase::recovery:
      return "recovery";
    case Phase::return_home:
      return "return";
  }
  return "unknown";
}

std::optional<Phase> phase_of(std::string_view word) noexcept {
  for (std::size_t i = 0; i < phase_count; ++i)
    if (const auto phase = static_cast<Phase>(i); word == name_of(phase)) return phase;
  return std::nullopt;
}

}  // namespace slackwater::twin
