#include "api/door/people/playback/logged_surround.h"

#include "api/ask/run/logged_water.h"
#include "api/log/command_tables.h"
#include "fields/base/error.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::people {
namespace {

using ingest::TrajectoryFile;

/// A time is known to be after a step by more than rounding.
constexpr double rounding_s = 1e-6;

/// Which is asked for its surroundings alone.
api::ScenarioWater water_of(const TrajectoryFile& log, const twin::Scenario& scenario,
                            const std::filesystem::path& store_folder,
                            const std::optional<std::filesystem::path>& forecast) {
  api::ScenarioWater water = api::logged_water(log, scenario, store_folder, forecast);
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

LoggedSurround::LoggedSurround(const TrajectoryFile& log, const std::filesystem::path& path,
                               const std::filesystem::path& store_folder,
                               const std::optional<std::filesystem::path>& forecast)
    : scenario_(api::scenario_of_log(log, path)),
      water_(water_of(log, scenario_, store_folder, forecast)),
      ready_(twin::set_up(scenario_, water_.surround)),
      asked_(weather_in(log, scenario_.step_s)) {
  if (ready_.agents.empty())
    throw Error(ErrorKind::invalid_input,
                path.string() +
                    ": its scenario has no vehicle; give a log that `slackwater "
                    "simulate` or `live` wrote");
}

nlohmann::json LoggedSurround::facts() const {
  return place_facts(run_place(water_, ready_.agents, ready_.start, ready_.origin),
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
  return surroundings_of(run_place(water_, ready_.agents, ready_.start, ready_.origin), t_s,
                         vehicles_m);
}

std::optional<FarmNow> LoggedSurround::farm(const Surroundings& around) const {
  const auto& turbines = ready_.environment->turbines;
  if (!turbines || !around.hub_wind_m_s) return std::nullopt;
  return FarmOutput(*turbines).at(*around.hub_wind_m_s);  // whoever looked before
}

FoundSurround find_surround(const std::filesystem::path& log,
                            const std::filesystem::path& store_folder,
                            const std::optional<std::filesystem::path>& forecast) {
  const TrajectoryFile tracks = ingest::read_tracks_apart(log);
  try {
    return {std::make_unique<LoggedSurround>(tracks, log, store_folder, forecast), {}};
  } catch (const Error& problem) {
    if (forecast) throw;  // somebody means that it is this one
    return {nullptr, problem.message()};
  }
}

}  // namespace slackwater::people
