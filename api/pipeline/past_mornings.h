#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/service/snapshot.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// A forecast of a past day D, and what came of it.
struct PastMorning {
  std::shared_ptr<const Snapshot> forecast;
  std::shared_ptr<const Snapshot> came;  ///< as far as it was known (`calibration::what_came`)
};

/// The mornings before a forecast of which something had come by the end of its D, at most the last
/// 40 days of them, in order of day: of each the forecast as issued, a hindcast where none was,
/// under the same wind policy, in hindsight where this one is. What came is as the store holds it
/// now. None where it holds none, or is not there; one that cannot be read is left out.
[[nodiscard]] std::vector<PastMorning> past_mornings(const std::filesystem::path& store_folder,
                                                     const Site& site, const Snapshot& forecast,
                                                     int threads);

/// A stored forecast, and what came of it.
struct ForecastAndCame : PastMorning {
  std::string fault;  ///< why its file cannot be read, and `forecast` is null; else empty
};

/// What came of stored forecasts of a site, one of `rows` each: `came` is null where not even the
/// first hour is known.
/// @param until     the data of the store are looked at up to here
/// @param known_by  values that end later are unknown
/// @throws Error(not_found) where the store holds nothing of the site in these times
[[nodiscard]] std::vector<ForecastAndCame> what_came_of(store::Store& store, const Site& site,
                                                        const std::vector<store::ForecastRow>& rows,
                                                        UtcTime until, UtcTime known_by,
                                                        int threads);

}  // namespace slackwater::api
