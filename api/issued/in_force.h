#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/service/field.h"
#include "ingest/cf/forecast_file.h"

// Which forecast answers. Every door asks here: the commands, the HTTP service, the twin.

namespace slackwater::api {

/// Which of the issued forecasts may answer. What is not set does not restrict.
struct WantedForecast {
  std::string site_id;        ///< empty: of any site
  std::optional<UtcDay> day;  ///< day D
  std::optional<UtcTime> valid_at;
};

/// Whether `a` comes before `b` of the same site: what was issued as a forecast before what was
/// made in hindsight; of those the newest day D, then the latest issued, then the latest stored.
[[nodiscard]] bool has_more_force(const store::ForecastRow& a,
                                  const store::ForecastRow& b) noexcept;

/// The forecasts that may answer, by site, each site's forecast in force before its others.
[[nodiscard]] std::vector<store::ForecastRow> by_force(store::Store& store,
                                                       const WantedForecast& wanted);

/// The forecast in force of one site. @throws Error(not_found) where none is wanted or stored
[[nodiscard]] store::ForecastRow forecast_in_force(store::Store& store,
                                                   const WantedForecast& wanted);

/// An issued forecast laid out for sampling.
[[nodiscard]] std::shared_ptr<const Field> read_field(const store::Store& store,
                                                      const store::ForecastRow& row,
                                                      ingest::Members members);

/// Of the fields that reach a place, the index of the one whose site is nearest; nothing where none
/// reaches it. Null fields are passed over.
[[nodiscard]] std::optional<std::size_t> nearest_reaching(
    std::span<const std::shared_ptr<const Field>> fields, double longitude_deg,
    double latitude_deg) noexcept;

}  // namespace slackwater::api
