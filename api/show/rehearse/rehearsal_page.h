#pragma once
#include <filesystem>

#include "api/ask/rehearse/advice.h"
#include "api/ask/rehearse/mission_file.h"
#include "api/ask/rehearse/rehearsal.h"

namespace slackwater::api {

/// A rehearsal for people: the verdict with its cause, the starts, and of one start what each
/// vehicle does when, the plan, the charge left against what the way home takes, what is covered of
/// the surfaces it inspects and what the current has to do with that, and the weather felt with
/// the limits drawn in.
/// @param advice  for its best start; may be empty
[[nodiscard]] std::string rehearsal_page_html(const LoadedMission& mission,
                                              const RehearsalPlan& plan, const Rehearsal& rehearsal,
                                              const std::vector<Advice>& advice,
                                              std::string_view plotting_library);
/// @throws Error(unavailable) where it cannot be written
void write_rehearsal_page(const LoadedMission& mission, const RehearsalPlan& plan,
                          const Rehearsal& rehearsal, const std::vector<Advice>& advice,
                          const std::filesystem::path& file);

}  // namespace slackwater::api
