#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"

// Which forecast answers. Every door asks here: the commands, the HTTP service, the twin.

namespace slackwater::api {

/// Which of the issued forecasts may answer. What is not set does not restrict.
struct WantedForecast {
  std::string site_id;        ///< empty: of any site
  std::optional<UtcDay> day;  ///< day D
  std::optional<UtcTime> valid_at;
};

/// Whether `a` comes before `b` of the same site, now: what was issued as a forecast before what
/// was made in hindsight; of those the newest day D; of that day what was issued before its last
/// hour had passed; then the latest issued, then the latest stored.
[[nodiscard]] bool has_more_force(const store::ForecastRow& a,
                                  const store::ForecastRow& b) noexcept;

/// The forecasts that may answer, by site, each site's forecast in force before its others. Where a
/// time is asked about, it is the one in force then: of one day D what was issued by that time
/// stands first, the latest of it before the others; what was issued only later follows as
/// `as_issued_first` orders it. Where a day is asked about without a time, so does all of it.
[[nodiscard]] std::vector<store::ForecastRow> by_force(store::Store& store,
                                                       const WantedForecast& wanted);

/// "forecast 12 of site S, issued 2025-03-10T05:00:00Z, is damaged (its file files/ab/ab….nc is
/// missing); run `slackwater store check`"; nothing where its file is whole
/// (data/store/proven_content.h).
[[nodiscard]] std::optional<std::string> damage_of(const store::Store& store,
                                                   const store::ForecastRow& row);

/// The forecast that answers, its file found whole, and what was passed over for it.
struct InForce {
  store::ForecastRow row;
  /// The damage of each forecast of more force, to be told beside the answer.
  std::vector<std::string> passed_over;
};

/// The forecast in force of one site: of those whose files are whole the first by force.
/// @throws Error(not_found) where none is wanted or stored, Error(invalid_input) where all that
/// might answer are damaged
[[nodiscard]] InForce forecast_in_force(store::Store& store, const WantedForecast& wanted);

/// An issued forecast laid out for sampling.
/// @throws Error(invalid_input) with `damage_of` it
[[nodiscard]] std::shared_ptr<const Field> read_field(const store::Store& store,
                                                      const store::ForecastRow& row,
                                                      ingest::Members members);

/// Of the fields that reach a place, the index of the one with the nearest column (of columns that
/// are equally near the field with more columns, then the first); nothing where none reaches it.
/// Null fields are passed over.
[[nodiscard]] std::optional<std::size_t> nearest_reaching(
    std::span<const std::shared_ptr<const Field>> fields, double longitude_deg,
    double latitude_deg) noexcept;

}  // namespace slackwater::api
