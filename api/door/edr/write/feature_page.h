#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/edr/read/feature_filter.h"

namespace slackwater::api::edr {

/// A FeatureCollection of those features that fall on the page that is asked for, with links to
/// itself, to its other renditions and to the next page.
/// @param href       of the list, without a query
/// @param all_taken  the features that the filter takes, those of other pages too
[[nodiscard]] nlohmann::json feature_page(const std::string& href, const FeatureFilter& filter,
                                          nlohmann::json all_taken);

}  // namespace slackwater::api::edr
