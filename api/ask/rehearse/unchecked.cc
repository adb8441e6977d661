#include "api/ask/rehearse/unchecked.h"

#include <algorithm>
#include <set>

#include "fields/base/text.h"

namespace slackwater::api {

Unchecked unchecked_of(const twin::Scenario& mission) {
  std::set<std::string> not_checked, assumed;
  for (const twin::ScenarioVehicle& vehicle : mission.vehicles) {
    if (!vehicle.conduct) continue;
    for (const twin::Limit& limit : vehicle.conduct->limits) {
      const auto found =
          std::find_if(vehicle.conduct->assumed.begin(), vehicle.conduct->assumed.end(),
                       [&](const twin::Assumption& a) { return a.variable == limit.variable; });
      const bool is_assumed = found != vehicle.conduct->assumed.end();
      if (twin::word_of(limit.variable).is_served && !is_assumed) continue;
      if (!is_assumed)
        not_checked.insert(text_of(limit));
      else
        assumed.insert(formatted("{} {:g} {}", twin::word_of(limit.variable).meaning, found->value,
                                 twin::word_of(limit.variable).unit));
    }
  }
  return {{not_checked.begin(), not_checked.end()}, {assumed.begin(), assumed.end()}};
}

}  // namespace slackwater::api
