#pragma once
#include <vector>

#include "calibration/verify/score_forecast.h"
#include "data/store/store.h"

namespace slackwater::api {

/// Scores every stored forecast of the site in the range whose truth is in: of each D and wind
/// policy one, as it was issued (api/issued/as_issued.h), a hindcast where none was. Forecasts
/// without any truth are left out; none at all is Error(not_found). One that cannot be scored is
/// named (`unscored`) and does not stop the others; an Error where it is all of them.
[[nodiscard]] calibration::Verification verify(store::Store& store, const Site& site,
                                               const calibration::VerifyOptions& options);

/// The same with the site's data read already; empty where nothing is issued yet.
[[nodiscard]] calibration::Verification verify_with(store::Store& store, const Site& site,
                                                    const SiteData& data,
                                                    const calibration::VerifyOptions& options);

}  // namespace slackwater::api
