#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/run/set_up.h"
#include "twin/scenario/expand_mission.h"

namespace slackwater::twin {

/// The same mission, done otherwise in one way.
struct Variation {
  std::string what;  ///< "at half the speed"
  Scenario mission;
  Surround surround;
  UtcTime start;
};

/// Every speed that the mission asks for, halved; nothing where it asks for none.
[[nodiscard]] std::optional<Variation> at_half_speed(const Scenario& mission,
                                                     const Surround& surround, UtcTime start);

/// Each battery beside another like it (twice the charge, half the resistance), whose weight is not
/// counted; nothing where all burn fuel.
[[nodiscard]] std::optional<Variation> with_another_battery(const Scenario& mission,
                                                            const Surround& surround,
                                                            UtcTime start);

/// One vehicle that another could stand in for: every other of data/vehicles of a kind that its
/// task takes and with the instruments that it needs. Whether it can do it in its place, its
/// set-up has to say.
[[nodiscard]] std::vector<Variation> with_other_vehicles(const Scenario& mission,
                                                         const Surround& surround, UtcTime start,
                                                         const ExpandedMission& expanded);

/// From the other side of the tide: at the moment within 7 hours, to the quarter hour, when the
/// central current at the first place of work runs most against that at the start. Nothing where it
/// does not turn by more than a right angle within the forecast or runs slower than 0.05 m/s.
[[nodiscard]] std::optional<Variation> from_the_other_tide(const Scenario& mission,
                                                           const Surround& surround, UtcTime start);

}  // namespace slackwater::twin
