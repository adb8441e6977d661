#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "twin/helm/command_arbiter.h"
#include "twin/run/command.h"
#include "twin/run/traffic_watch.h"

namespace slackwater::api {

/// A double to the last bit, for people too: "0x1.8p+1"; NaN as its bits, "bits:7ff8000000000000".
[[nodiscard]] std::string exact_text(double value);
/// @throws Error(invalid_input) for what is no such number
[[nodiscard]] double exact_number(const std::string& text);

/// The whole state of a vehicle, by the names of its members.
[[nodiscard]] nlohmann::json state_json(const twin::AgentState& state);
/// @throws Error(invalid_input) or nlohmann::json::exception for what is no state of this program
[[nodiscard]] twin::AgentState state_of(const nlohmann::json& json);

/// Commands in their order, likewise.
[[nodiscard]] nlohmann::json commands_json(std::span<const twin::Command> commands);
/// @throws as `state_of`
[[nodiscard]] std::vector<twin::Command> commands_of(const nlohmann::json& json);

/// How often which commands were refused, likewise.
[[nodiscard]] nlohmann::json refusals_json(std::span<const twin::RefusalCount> refusals);
/// @throws as `state_of`
[[nodiscard]] std::vector<twin::RefusalCount> refusals_of(const nlohmann::json& json);

/// What the watch for traffic has seen so far, likewise.
[[nodiscard]] nlohmann::json watch_json(const twin::TrafficWatch::State& state);
/// @throws as `state_of`
[[nodiscard]] twin::TrafficWatch::State watch_of(const nlohmann::json& json);

}  // namespace slackwater::api
