#include "api/door/people/playback/logged_surround.h"

#include "api/ask/run/heard_traffic.h"
#include "api/log/command_tables.h"
#include "fields/base/error.h"

namespace slackwater::people {
namespace {

using ingest::TrajectoryFile;

/// A time is known to be after a step by more than rounding.
constexpr double rounding_s = 1e-6;

twin::Scenario scenario_of(const TrajectoryFile& log) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty()) throw Error(ErrorKind::not_found, "the log holds no scenario");
  return twin::parse_scenario(yaml, "scenario");
}

/// With the traffic as it was heard then.
api::ScenarioWater water_of(const TrajectoryFile& log, const twin::Scenario& scenario,
                            const std::filesystem::path& store_folder,
                            const std::optional<std::filesystem::path>& forecast) {
  api::ScenarioWater water =
      api::water_of_log(scenario, log.attribute("forecast_sha256"), store_folder, forecast);
  api::add_logged_traffic(log, scenario, water);
  water.surround.is_only_asked = true;
  return water;
}

/// In the order of their steps.
std::vector<std::pair<double, twin::WeatherAsked>> weather_in(const TrajectoryFile& log,
                                                              double step_s) {
  std::vector<std::pair<double, twin::WeatherAsked>> asked;
  for (const twin::Command& command : api::commands_in(log))
    if (const auto* weather = std::get_if<twin::SetWeather>(&command.what))
      asked.emplace_back(static_cast<double>(command.step) * step_s, weather->asked);
  return asked;
}

}  // namespace

LoggedSurround::LoggedSurround(const TrajectoryFile& log, const std::filesystem::path& store_folder,
                               const std::optional<std::filesystem::path>& forecast)
    : scenario_(scenario_of(log)),
      water_(water_of(log, scenario_, store_folder, forecast)),
      ready_(twin::set_up(scenario_, water_.surround)),
      asked_(weather_in(log, scenario_.step_s)) {
  if (ready_.agents.empty()) throw Error(ErrorKind::not_found, "its scenario has no vehicle");
  if (ready_.environment->turbines) farm_.emplace(*ready_.environment->turbines);
}

nlohmann::json LoggedSurround::facts() const {
  return place_facts(
      run_place(water_, *ready_.environment, ready_.agents, ready_.start, ready_.origin),
      places_of(ready_.states));
}

/// What was asked at a step is seen after it.
void LoggedSurround::lead_weather(double t_s) {
  const twin::Environment& environment = *ready_.environment;
  if (!environment.weather) return;
  std::size_t by_then = 0;
  while (by_then < asked_.size() && asked_[by_then].first < t_s - rounding_s) ++by_then;
  if (by_then < led_) {
    environment.weather->forget();
    led_ = 0;
  }
  for (; led_ < by_then; ++led_)
    environment.weather->set(asked_[led_].second, environment, asked_[led_].first);
}

Surroundings LoggedSurround::at(double t_s, std::span<const Horizontal> vehicles_m) {
  lead_weather(t_s);
  return surroundings_of(
      run_place(water_, *ready_.environment, ready_.agents, ready_.start, ready_.origin), t_s,
      vehicles_m);
}

std::optional<FarmNow> LoggedSurround::farm(const Surroundings& around) {
  if (!farm_ || !around.hub_wind_m_s) return std::nullopt;
  return farm_->at(*around.hub_wind_m_s);
}

FoundSurround find_surround(const std::filesystem::path& log,
                            const std::filesystem::path& store_folder,
                            const std::optional<std::filesystem::path>& forecast) {
  const TrajectoryFile tracks = ingest::read_trajectories(log);
  try {
    return {std::make_unique<LoggedSurround>(tracks, store_folder, forecast), {}};
  } catch (const Error& problem) {
    return {nullptr, problem.message()};
  }
}

}  // namespace slackwater::people
