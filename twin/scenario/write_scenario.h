#pragma once
#include <string>

#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// A scenario as YAML: what `parse_scenario` reads as the same value, to the bit. Angles and other
/// numbers whose unit is another in the file come back to the bit where they came of a file or of a
/// mission. What is as it is without a word is left out.
///
/// Neither `rays_per_look` nor a track that was found is written: they are the caller's.
[[nodiscard]] std::string write_scenario(const Scenario& scenario);

}  // namespace slackwater::twin
