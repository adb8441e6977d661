#pragma once
#include <string>

#include "api/pipeline/past_skill.h"

namespace slackwater::api {

/// How past forecasts did, in a sentence or two: do they beat the plainest alternatives where the
/// truth is in? Or why that is not known.
[[nodiscard]] std::string verified_text(const PastSkill& past);

}  // namespace slackwater::api
