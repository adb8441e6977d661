#pragma once
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fields/base/constants.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "twin/inspection/inspection_outcome.h"

namespace slackwater::twin::tests {

inline constexpr double degree = constants::pi / 180;

/// A data folder with the instruments of a test, and what the program has of defects.
class InspectionFolder {
 public:
  InspectionFolder() {
    std::filesystem::create_directories(folder_ / "instruments");
    for (const char* shared : {"defects", "detection"})
      std::filesystem::create_directory_symlink(
          slackwater::tests::source_folder() / "data" / shared, folder_ / shared);
  }
  void add(const std::string& name, const std::string& yaml) const {
    std::ofstream(folder_ / "instruments" / (name + ".yaml"))
        << "name: " << name << "\nsource: test\nstatus: estimate\n"
        << yaml;
  }
  /// @param yaml  of the inspection
  [[nodiscard]] std::shared_ptr<const Inspection> made(const std::string& yaml,
                                                       const std::vector<Waypoint>& way,
                                                       std::size_t rays = 1000000) const {
    const Config config = Config::parse(yaml, "test.yaml");
    return ready_inspection("eye", read_inspection(config), way, folder_.path(), rays);
  }

 private:
  slackwater::tests::TemporaryFolder folder_;
};

/// Where a vehicle is, level, with its bow to a bearing.
inline Carriage level(const Triple<double>& at_m, double heading_rad,
                      const Triple<double>& velocity_m_s = {}) {
  EulerAngles angles;
  angles.yaw_rad = heading_rad;
  return {at_m, rotation_of(attitude_of(angles)), velocity_m_s, {}};
}

/// An inspection along a way: a carriage for each step.
inline InspectionState inspected_along(const Inspection& inspection, std::size_t steps, double dt_s,
                                       const std::function<Carriage(std::size_t)>& at,
                                       std::uint64_t seed = 1) {
  InspectionState state = begin_inspection(inspection, seed);
  for (std::size_t i = 0; i < steps; ++i) {
    const Carriage carriage = at(i);
    inspect(inspection, true, carriage, carriage.position_m, static_cast<double>(i) * dt_s, dt_s,
            state);
  }
  return state;
}

/// Share of the area that its first line covered.
inline double covered_share(const Inspection& inspection, const InspectionState& state) {
  return inspection_outcome(inspection, state).share();
}

}  // namespace slackwater::twin::tests
