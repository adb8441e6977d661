#include "twin/risk/held_without.h"

#include "fields/base/check.h"
#include "twin/risk/first_stops.h"

namespace slackwater::twin {

std::vector<std::size_t> held_without(const StartQuestion& question, std::size_t limit) {
  expects(limit < question.limits, "a limit is one of the task's");
  StartQuestion rest = question;
  std::erase_if(rest.watched, [&](const WatchedLimit& watched) { return watched.limit == limit; });
  std::vector<std::size_t> held(question.starts.count, 0);
  for (const FirstStops& member : first_stops(rest))
    for (std::size_t s = 0; s < held.size(); ++s) held[s] += member.limit[s] == no_limit ? 1 : 0;
  return held;
}

}  // namespace slackwater::twin
