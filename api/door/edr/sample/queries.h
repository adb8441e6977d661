#pragma once
#include <functional>

#include "api/door/edr/sample/coverages.h"
#include "api/door/edr/sample/work.h"

// One query type a file. Each takes a query string and the chosen forecast's selection, and says
// what is to be done for an answer; each throws Error(usage) for what it cannot read or is too
// much, and Error(not_found), with the valid range, for what the forecast does not reach.

namespace slackwater::api::edr {

/// A query that was read and found moderate; nothing has been sampled for it yet.
struct QueryPoints {
  Work work;
  std::function<Answer()> answer;  ///< called once
};

[[nodiscard]] QueryPoints position_plan(Selection selection, const QueryString& query);
[[nodiscard]] QueryPoints radius_plan(Selection selection, const QueryString& query);
[[nodiscard]] QueryPoints area_plan(Selection selection, const QueryString& query);
[[nodiscard]] QueryPoints cube_plan(Selection selection, const QueryString& query);
[[nodiscard]] QueryPoints trajectory_plan(Selection selection, const QueryString& query);
[[nodiscard]] QueryPoints corridor_plan(Selection selection, const QueryString& query);

/// A location of a forecast: a site's column.
[[nodiscard]] QueryPoints location_plan(Selection selection, const QueryString& query,
                                        std::size_t column);

/// A query type as clients know it.
struct QueryType {
  std::string_view name;  ///< of the path and of `data_queries`
  std::string_view title;
  std::string_view description;
  std::vector<std::string_view> parameters;  ///< that it takes, those it needs first
  std::size_t needed = 0;                    ///< how many of them it cannot do without
  QueryPoints (*plan)(Selection, const QueryString&) = nullptr;
};

/// position, radius, area, cube, trajectory, corridor.
[[nodiscard]] std::span<const QueryType> query_types();
/// Parameters of a location query.
[[nodiscard]] const std::vector<std::string_view>& location_parameters();

}  // namespace slackwater::api::edr
