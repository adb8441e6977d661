#pragma once
#include "data/store/store.h"
#include "fields/record/piece.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// The depth of the bed around a site by the bathymetry in the store, m below the geoid: of the
/// first product, in the order of `bathymetry_at`, that knows it at the site's own point, else of
/// the first that knows any. It reaches 0.8 degrees beyond all that the site describes: turbines,
/// cables, areas and columns. NaN on land and where nobody sounded.
/// @throws Error(not_found) where none is stored there, and Error(invalid_input) where what is
///         stored is damaged
[[nodiscard]] ScalarPiece bed_around(store::Store& store, const Site& site);

}  // namespace slackwater::api
