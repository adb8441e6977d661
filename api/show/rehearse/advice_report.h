#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/rehearse/advice.h"

namespace slackwater::api {

[[nodiscard]] nlohmann::json advice_json(const std::vector<Advice>& advice);
/// "an hour later: 22 of 24 done instead of 10".
[[nodiscard]] std::string text_of(const Advice& advice);
[[nodiscard]] std::string advice_table_html(const std::string& title,
                                            const std::vector<Advice>& advice);

}  // namespace slackwater::api
