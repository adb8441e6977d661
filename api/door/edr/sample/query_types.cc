#include <array>

#include "api/door/edr/sample/queries.h"

namespace slackwater::api::edr {

std::span<const QueryType> query_types() {
  static const std::array<QueryType, 6> all{{
      {"position",
       "Position",
       "Series and profiles at one or several points (POINT, MULTIPOINT), interpolated in place, "
       "time and depth",
       {"coords", "z", "datetime", "parameter-name", "crs", "f"},
       1,
       position_plan},
      {"radius",
       "Radius",
       "The forecast's columns within a distance of a point (POINT)",
       {"coords", "within", "within-units", "z", "datetime", "parameter-name", "resolution-x",
        "resolution-y", "crs", "f"},
       3,
       radius_plan},
      {"area",
       "Area",
       "The forecast's columns within a POLYGON or MULTIPOLYGON",
       {"coords", "z", "datetime", "parameter-name", "resolution-x", "resolution-y", "crs", "f"},
       1,
       area_plan},
      {"cube",
       "Cube",
       "The forecast's columns within a box of longitude, latitude and levels",
       {"bbox", "z", "datetime", "parameter-name", "resolution-x", "resolution-y", "resolution-z",
        "crs", "f"},
       2,
       cube_plan},
      {"trajectory",
       "Trajectory",
       "Along a LINESTRING; Z gives each vertex its vertical, M its time in seconds since 1970",
       {"coords", "z", "datetime", "parameter-name", "crs", "f"},
       1,
       trajectory_plan},
      {"corridor",
       "Corridor",
       "Along a LINESTRING and beside it, above and below it",
       {"coords", "corridor-width", "width-units", "corridor-height", "height-units", "z",
        "datetime", "parameter-name", "resolution-x", "resolution-y", "resolution-z", "crs", "f"},
       5,
       corridor_plan},
  }};
  return all;
}

const std::vector<std::string_view>& location_parameters() {
  static const std::vector<std::string_view> all{"datetime", "parameter-name", "z", "crs", "f"};
  return all;
}

}  // namespace slackwater::api::edr
