#include "api/rehearse/vehicle_log.h"

#include <algorithm>

#include "twin/scene/structure.h"
#include "twin/simulate/set_up.h"

namespace slackwater::api {

using ingest::TrajectoryFile;
using twin::ScenarioStructure;

Approach nearest_structure(const TrajectoryFile& log, const VehicleLog& vehicle,
                           const twin::Scenario& scenario) {
  Approach nearest;
  for (const ScenarioStructure& structure : scenario.structures) {
    const twin::Structure shape = twin::shape_of(structure);
    for (std::size_t t = 0; t < vehicle.rows(); ++t) {
      const double distance =
          twin::least_distance_m(shape, vehicle.place_m(t == 0 ? 0 : t - 1), vehicle.place_m(t));
      if (distance < nearest.distance_m)
        nearest = Approach{distance, log.t_s[t], structure.name, 0};
    }
  }
  return nearest;
}

Approach nearest_vehicle(const TrajectoryFile& log, const std::vector<VehicleLog>& vehicles,
                         std::size_t i) {
  Approach nearest;
  for (std::size_t j = 0; j < vehicles.size(); ++j) {
    if (j == i) continue;
    const std::size_t rows = std::min(vehicles[i].rows(), vehicles[j].rows());
    for (std::size_t t = 0; t < rows; ++t) {
      const auto apart = vehicles[i].place_m(t) - vehicles[j].place_m(t);
      const double distance = std::sqrt(dot(apart, apart));
      if (distance < nearest.distance_m) nearest = Approach{distance, log.t_s[t], log.names[j], 0};
    }
  }
  return nearest;
}

}  // namespace slackwater::api
