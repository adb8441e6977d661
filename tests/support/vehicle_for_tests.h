#pragma once
#include <string>

#include "tests/support/shared_data.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::tests {

/// A vehicle that comes with Slackwater.
[[nodiscard]] inline twin::Vehicle bundled_vehicle(const std::string& id) {
  const auto data = source_folder() / "data";
  return twin::read_vehicle(data / "vehicles" / (id + ".yaml"), data);
}

}  // namespace slackwater::tests
