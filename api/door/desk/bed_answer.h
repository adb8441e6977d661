#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/desk/site_answers.h"
#include "fields/record/piece.h"

namespace slackwater::api::desk {

/// Depth contours around a site as GeoJSON, a feature for each depth of 5, 10, 20, 30, 50, 100,
/// 200, 500 and 1000 m that the bed reaches: lines of longitude and latitude, which run on past 180
/// at the antimeridian. Grids of more than 1000 nodes a side are thinned to less. No words.
/// @throws Error(not_found) where the store has no bathymetry there
[[nodiscard]] nlohmann::json bed_answer(const Answers& from, const std::string& site,
                                        const std::string& query);

/// The lines of a field of depths.
[[nodiscard]] nlohmann::json bed_json(const ScalarPiece& bed);

}  // namespace slackwater::api::desk
