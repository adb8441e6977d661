#pragma once
#include "api/ask/windows/windows.h"
#include "fields/site/site.h"
#include "twin/risk/wave_futures.h"

namespace slackwater::api {

/// What the tasks of one answer share.
struct SharedOutlook {
  const Site* site = nullptr;
  const ScenarioWater* water = nullptr;
  std::size_t members = 1;
  const twin::WaveFutures* waves = nullptr;  ///< null: as forecast in all members
  UtcTime from;                              ///< of the starts
  UtcTime to;
  bool is_one_day = false;  ///< nobody asked for other hours
  std::filesystem::path store_folder;
  const VesselAccess* vessel = nullptr;  ///< that brings the tasks; null: none is judged
  const PastOutlooks* past = nullptr;    ///< mornings that the chances are calibrated on
};

/// The windows of one task. Thread-safe.
/// @throws as `windows_of`
[[nodiscard]] TaskWindows task_windows(const WindowsQuestion& question,
                                       const SharedOutlook& outlook, const std::string& task);

/// The task as it is flown: where it was asked about, for as long as it was planned with its
/// contingency.
[[nodiscard]] LoadedMission mission_to_fly(const WindowsQuestion& question, const TaskWindows& task,
                                           std::uint64_t seed, std::size_t wave_components,
                                           const std::filesystem::path& store_folder);

}  // namespace slackwater::api
