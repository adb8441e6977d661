#include "api/ask/run/scenario_at_hand.h"

#include "api/ask/run/heard_traffic.h"
#include "fields/base/error.h"

namespace slackwater::api {

ScenarioAtHand scenario_at_hand(const std::filesystem::path& file,
                                const std::filesystem::path& store_folder) {
  ScenarioAtHand out;
  out.scenario = twin::read_scenario(file);
  const auto folder = std::filesystem::absolute(file).parent_path();
  out.water = water_of(out.scenario, store_folder, folder);
  with_context(file.string(), [&] { add_heard_traffic(out.scenario, folder, out.water); });
  return out;
}

}  // namespace slackwater::api
