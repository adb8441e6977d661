#pragma once
#include <filesystem>

#include "api/ask/decisions/decisions.h"
#include "api/pipeline/past_mornings.h"

namespace slackwater::api {

/// What came of the start of a decision, by the forecast that it rests on and what came of it.
/// @param asked  of the site, with nothing else asked
[[nodiscard]] WhatCame what_came_of_start(const WindowsQuestion& asked,
                                          const store::DecisionRow& decision,
                                          const ForecastAndCame& forecast,
                                          const std::filesystem::path& store_folder);

}  // namespace slackwater::api
