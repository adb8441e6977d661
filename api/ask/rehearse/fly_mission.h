#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "api/ask/rehearse/mission_file.h"
#include "api/ask/rehearse/rehearsal.h"

namespace slackwater::api {

/// How a mission is rehearsed where nothing else was said: at these starts or the mission's own, in
/// so many futures, its workers told apart, zones kept.
/// @param mission  its water is given further members where more are asked for than were issued;
///                 the plan looks at it from then on
/// @param members  0: as issued, or 1 in made-up water
[[nodiscard]] RehearsalPlan rehearsal_plan(LoadedMission& mission, std::vector<UtcTime> starts,
                                           std::size_t members, int threads,
                                           const std::filesystem::path& store_folder);

/// Flies it, once it is known that it can be flown at all.
/// @throws Error(invalid_input) for a mission that does not fit its vehicles, cannot see in calm
///         water what it is to see, or has no start that may be flown; what `rehearse` throws, and
///         what `on_progress` throws
[[nodiscard]] Rehearsal fly_mission(
    const LoadedMission& mission, const RehearsalPlan& plan,
    const std::function<void(double share, const Rehearsal& so_far)>& on_progress = {});

}  // namespace slackwater::api
