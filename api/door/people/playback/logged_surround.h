#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "api/door/people/farm_output.h"
#include "api/door/people/surroundings.h"
#include "twin/run/command.h"
#include "twin/run/set_up.h"

namespace slackwater::people {

/// The place of a run that is over, and its weather at any time: the scenario of its log is made
/// ready once more, in the forecast that it ran in. Nothing is stepped. One thread at a time: the
/// weather of a moment is led in its own environment.
class LoggedSurround {
 public:
  /// @param path      of the log, for errors
  /// @param forecast  where given, this file and not that of the store
  /// @throws Error where the log tells no scenario, or what it needs is gone
  LoggedSurround(const ingest::TrajectoryFile& log, const std::filesystem::path& path,
                 const std::filesystem::path& store_folder,
                 const std::optional<std::filesystem::path>& forecast);
  LoggedSurround(const LoggedSurround&) = delete;
  LoggedSurround& operator=(const LoggedSurround&) = delete;

  /// Of a welcome (run_place.h).
  [[nodiscard]] nlohmann::json facts() const;
  /// As a station of the live run was told it then, what people had led of it too.
  /// @param vehicles_m  where they were: east, north
  [[nodiscard]] Surroundings at(double t_s, std::span<const Horizontal> vehicles_m);
  /// What turbines make of it; nothing: there are none, or no wind.
  [[nodiscard]] std::optional<FarmNow> farm(const Surroundings& around) const;

 private:
  void lead_weather(double t_s);

  twin::Scenario scenario_;
  api::ScenarioWater water_;
  twin::ReadyRun ready_;
  std::vector<std::pair<double, twin::WeatherAsked>> asked_;  ///< by people, and when
  std::size_t led_ = 0;                                       ///< of these, in the environment now
};

/// What is to be had of it.
struct FoundSurround {
  std::unique_ptr<LoggedSurround> surround;  ///< null: nobody knows
  std::string missing;                       ///< why, for people
};
/// @throws Error for what is no log, and for a `forecast` that is not that of the log
[[nodiscard]] FoundSurround find_surround(const std::filesystem::path& log,
                                          const std::filesystem::path& store_folder,
                                          const std::optional<std::filesystem::path>& forecast);

}  // namespace slackwater::people
