#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "twin/rehearse/adapt_intensity.h"

namespace slackwater::api {

/// How closely a start of a mission can look and come home with its reserve.
struct AdaptedStart {
  UtcTime start;
  double keep_share = 0.9;
  twin::IntensityChoice choice;
};

/// Of a rehearsal's JSON, key `intensity`: api/docs/rehearse.md has the schema.
[[nodiscard]] nlohmann::json intensity_json(const AdaptedStart& adapted);
/// The same for people, a line each.
[[nodiscard]] std::vector<std::string> intensity_texts(const AdaptedStart& adapted);

/// The mission as YAML, its work thinned as chosen, at that start; it flies as it stands, from the
/// folder of the mission that it is of.
/// @param mission  as it was read
/// @param roles    of all of its agents
/// @throws ContractViolation where nothing was chosen
[[nodiscard]] std::string adapted_mission_yaml(const Config& mission,
                                               const std::vector<std::string>& roles,
                                               const AdaptedStart& adapted);

}  // namespace slackwater::api
