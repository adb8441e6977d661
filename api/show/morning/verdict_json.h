#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "calibration/verify/verdict.h"

namespace slackwater::api {

/// A verdict as in `forecast --json`; null before any truth is in.
[[nodiscard]] nlohmann::json verdict_json(const std::optional<calibration::Verdict>& verdict);

}  // namespace slackwater::api
