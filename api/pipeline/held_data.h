#pragma once
#include <string>

#include "data/store/store.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// What the store holds around a site, in words for the error that says that it holds nothing of
/// what was asked: over which times, and which `--day` and `--at` would work; where nothing lies
/// near the site, which area the store covers, and whether latitude and longitude look swapped.
[[nodiscard]] std::string held_text(store::Store& store, const Site& site);

}  // namespace slackwater::api
