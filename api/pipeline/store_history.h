#pragma once
#include "data/store/store.h"
#include "fields/site/site.h"
#include "ingest/history/read_history.h"

namespace slackwater::api {

/// The past of a site as the store holds it: analysed and observed values at the site's own point,
/// by the rules of api/docs/which_value_counts.md; what is a provider's forecast is left out.
///
/// Wind is at 10 m, currents at `depth_m`, between levels linearly; both also as speed and
/// direction.
/// @throws Error(not_found) where the store holds nothing for the site;
///         Error(invalid_input) for a current without a depth
[[nodiscard]] ingest::HistoryOfFile read_store_history(store::Store& store, const Site& site,
                                                       const std::vector<std::string>& wanted,
                                                       std::optional<double> depth_m,
                                                       const ingest::Vocabulary& vocabulary);

}  // namespace slackwater::api
