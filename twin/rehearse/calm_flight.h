#pragma once
#include <span>
#include <string>
#include <vector>

#include "twin/run/set_up.h"

namespace slackwater::twin {

/// The same mission where nothing is in its way: still water and air, no waves, no limits, faults,
/// watches or others about, and vehicles that know where they are. What carries a vehicle whose
/// work counts stays.
/// @param workers  vehicles whose work counts
/// @param depth_m  of the water, positive
[[nodiscard]] Scenario in_dead_calm(const Scenario& mission, std::span<const std::string> workers,
                                    double depth_m);

/// What one instrument of a vehicle covers of the surfaces that it inspects.
struct CalmLook {
  std::string vehicle;
  std::string instrument;
  std::string surfaces;  ///< "A01/monopile, A01/anodes"
  double covered = 0;    ///< share of their area
  double asked = 0;      ///< at least
  std::string why;       ///< in words, what most of the rest lacks, and what to do; empty: nothing

  [[nodiscard]] bool is_seen() const noexcept { return covered >= asked; }
};

/// What a mission sees when it is flown once.
struct CalmFlight {
  /// Its work was done, or all was seen before; else it shows nothing of what could be seen.
  bool is_flown_out = false;
  std::vector<CalmLook> looks;  ///< of all lines that ask for some share
};

/// How far it is flown.
enum class CalmEnd {
  home,  ///< to its end
  seen,  ///< until every look covers what is asked, or to its end: nothing more is to be shown
};

/// Flies what `in_dead_calm` made.
/// @param surround  its field is replaced
/// @throws Error(invalid_input) as `set_up`
[[nodiscard]] CalmFlight fly_in_calm(const Scenario& calm, Surround surround,
                                     CalmEnd until = CalmEnd::home);

}  // namespace slackwater::twin
