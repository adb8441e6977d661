#pragma once
#include <string>
#include <vector>

#include "api/door/edr/sample/queries.h"

// Which site's forecast answers a query that names no instance.

namespace slackwater::api::edr {

/// The site that answers, and why it does where others might have: notes of the answer.
struct SiteChoice {
  const ForecastCatalogue::SiteForecast* site = nullptr;  ///< null: no forecast reaches the query
  std::vector<std::string> notes;
};

/// Of an area (polygon, box, circle) the site whose columns, each with a kilometre around it, cover
/// most of it; of sites that cover about as much (nine tenths of the most) the one with the most
/// columns in it. Of these, and of points and lines from the start, the site whose forecast reaches
/// about the most; then the one with the column nearest to the middle (or the first vertex), then
/// the one with the most columns, then the first by name.
/// @throws Error(usage) where `coords`, `bbox` or `within` is missing or cannot be read
[[nodiscard]] SiteChoice site_for(const ForecastCatalogue& catalogue, const QueryType& type,
                                  const QueryString& query);

/// What an answer by the site's forecast in force is to say: which newer ones are damaged.
[[nodiscard]] std::vector<std::string> notes_on(const ForecastCatalogue::SiteForecast& site);

/// "the forecasts in force reach SITE (longitude ..., latitude ..., ...)": what a refusal tells.
[[nodiscard]] std::string reach_of(const ForecastCatalogue& catalogue);

}  // namespace slackwater::api::edr
