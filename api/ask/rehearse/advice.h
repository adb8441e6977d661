#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "api/ask/rehearse/mission_file.h"
#include "api/ask/rehearse/rehearsal.h"

namespace slackwater::api {

/// What would come of a mission done otherwise in one way, in the same futures.
struct Advice {
  std::string what;         ///< "an hour later"
  std::string impossible;   ///< why it was not flown; empty: it was
  std::size_t flights = 0;  ///< of the mission as it is and of the changed one, each
  std::size_t done = 0;     ///< of the changed one: done, and where something is asked, seen
  std::size_t done_as_is = 0;
  std::size_t gained = 0;  ///< futures that are done only if it is changed
  std::size_t lost = 0;    ///< and those that are done only as it is
  double low = 0, high = 1;

  [[nodiscard]] double gain() const noexcept {
    return flights > 0 ? (static_cast<double>(gained) - static_cast<double>(lost)) /
                             static_cast<double>(flights)
                       : 0;
  }
};

/// A start as it was flown.
struct FlownStart {
  UtcTime start;
  std::vector<std::uint8_t> done;  ///< by member from 0 on: 1 where it was, and saw what is asked
};
/// @param members  how many of them at most
[[nodiscard]] FlownStart flown_start(const StartOutcome& flown, std::size_t members);

/// Flies a start of a mission an hour earlier and later, from the other side of the tide, at half
/// the speed, with another battery and with other vehicles, each in the futures that the start was
/// flown in, and says what changes the answer most: best first, what is impossible last.
/// @param plan  where it bounds the time of the clock, each change has an even share of that; each
///              is flown once however long that takes
[[nodiscard]] std::vector<Advice> advice_for(const LoadedMission& mission,
                                             const RehearsalPlan& plan, const FlownStart& flown);

}  // namespace slackwater::api
