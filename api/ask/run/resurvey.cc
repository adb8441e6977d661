#include "api/ask/run/resurvey.h"

namespace slackwater::api {

twin::Resurvey resurvey_of(const twin::Scenario& scenario, const ScenarioResult& result) {
  std::vector<twin::Structure> structures;
  for (const twin::ScenarioStructure& s : scenario.structures)
    structures.push_back(twin::shape_of(s));
  std::vector<twin::Inspected> inspected;
  for (std::size_t i = 0; i < result.inspected.size(); ++i)
    if (const auto& inspection = result.inspected[i])
      inspected.push_back(
          {i, *inspection->what, inspection->state, scenario.vehicles[i].start_m.z >= 0});
  return twin::resurvey_of(scenario, structures, inspected);
}

}  // namespace slackwater::api
