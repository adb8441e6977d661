#pragma once
#include <optional>
#include <vector>

#include "api/ask/windows/task_outlook.h"
#include "twin/risk/chance_calibration.h"
#include "twin/risk/wave_futures.h"

namespace slackwater::api {

/// A past morning laid out to be asked what is asked today.
struct PastOutlook {
  ScenarioWater said;
  ScenarioWater came;
  std::optional<twin::WaveFutures> waves;  ///< of what was said
  std::chrono::days before{0};             ///< as many days before today's forecast
};

/// Shared by the tasks of an answer, and by the answers about other hours of the same forecast.
struct PastOutlooks {
  std::vector<PastOutlook> mornings;
};

/// Those of the store before a forecast (api/pipeline/past_mornings.h); none where the question
/// wants chances as the futures say.
[[nodiscard]] std::shared_ptr<const PastOutlooks> past_outlooks(
    const WindowsQuestion& question, const Site& site, const Snapshot& forecast,
    const std::filesystem::path& store_folder);

/// Sets what past mornings make of the chances of a task: the same hours of each, as they were said
/// then, beside what came. Mornings that cannot be asked (a shorter forecast, no such limit) count
/// for nothing.
/// @param outlook  of today, planned and its grid laid; @param today  the same
void look_back(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
               const Outlook& outlook, TaskWindows& today);

}  // namespace slackwater::api
