#pragma once
#include "api/edr/sample/coverages.h"

// One query type a file. Each takes a query string and the chosen forecast's selection, and gives an answer;
// each throws Error(usage) for what it cannot read and Error(not_found), with the valid range, for what the
// forecast does not reach.

namespace slackwater::api::edr {

[[nodiscard]] Answer position_answer(Selection selection, const QueryString& query);
[[nodiscard]] Answer radius_answer(Selection selection, const QueryString& query);
[[nodiscard]] Answer area_answer(Selection selection, const QueryString& query);
[[nodiscard]] Answer cube_answer(Selection selection, const QueryString& query);
[[nodiscard]] Answer trajectory_answer(Selection selection, const QueryString& query);
[[nodiscard]] Answer corridor_answer(Selection selection, const QueryString& query);

/// A location of a forecast: a site's column.
[[nodiscard]] Answer location_answer(Selection selection, const QueryString& query,
                                     std::size_t column);

/// A query type as clients know it.
struct QueryType {
  std::string_view name;  ///< of the path and of `data_queries`
  std::string_view title;
  std::string_view description;
  std::vector<std::string_view> parameters;  ///< that it takes, those it needs first
  std::size_t needed = 0;                    ///< how many of them it cannot do without
  Answer (*answer)(Selection, const QueryString&) = nullptr;
};

/// position, radius, area, cube, trajectory, corridor.
[[nodiscard]] std::span<const QueryType> query_types();
/// Parameters of a location query.
[[nodiscard]] const std::vector<std::string_view>& location_parameters();

}  // namespace slackwater::api::edr
