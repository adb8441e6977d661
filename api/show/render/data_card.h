#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "twin/render/stage/look_stage.h"

namespace slackwater::api {

/// What somebody has to know who learns from a folder of looks, or holds a detector against it:
/// from what they were drawn, how many labels there are, what of it stands in for the sea
/// (Markdown).
/// @param coco  the folder's labels
[[nodiscard]] std::string data_card(const twin::LookStage& stage, std::uint64_t seed,
                                    const nlohmann::json& coco);

}  // namespace slackwater::api
