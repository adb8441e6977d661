#include "api/ask/run/logged_water.h"

#include "api/ask/run/heard_traffic.h"
#include "fields/base/error.h"

namespace slackwater::api {

twin::Scenario scenario_of_log(const ingest::TrajectoryFile& log,
                               const std::filesystem::path& path) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty())
    throw Error(ErrorKind::invalid_input,
                path.string() +
                    ": holds no scenario, so that nobody knows what there was to see; "
                    "give a log that `slackwater simulate` or `live` wrote");
  return twin::parse_scenario(yaml, path.string() + " (scenario)");
}

ScenarioWater logged_water(const ingest::TrajectoryFile& log, const twin::Scenario& scenario,
                           const std::filesystem::path& store_folder,
                           const std::optional<std::filesystem::path>& forecast) {
  ScenarioWater water =
      water_of_log(scenario, log.attribute("forecast_sha256"), store_folder, forecast);
  add_logged_traffic(log, scenario, water);
  return water;
}

}  // namespace slackwater::api
