#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/desk/site_answers.h"

// The stored past of a site, as the commands tell it.

namespace slackwater::api::desk {

/// `slackwater workability --site SITE --json`. Words: limit, duration, contingency, start-hours,
/// daylight, timezone, depth (m, of
/// currents), from, to. @throws Error(usage) without a limit or a duration
[[nodiscard]] nlohmann::json workability_answer(const Answers& from, const std::string& site,
                                                const std::string& query);
/// `slackwater climate --site SITE --json`. Words: of, sectors, return-period, depth, from,
/// to; and
/// `what`: roses, scatter, extremes, all where none is named.
[[nodiscard]] nlohmann::json climate_answer(const Answers& from, const std::string& site,
                                            const std::string& query);

}  // namespace slackwater::api::desk
