#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/live/topics/reserve_advice.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "api/door/people/surroundings.h"
#include "api/door/people/wire/pose.h"

namespace slackwater::people {

/// A vessel that comes too near.
struct AlarmNow {
  twin::Alarm alarm;
  std::string name;             ///< of the vessel; may be empty
  std::string acknowledged_by;  ///< empty: nobody has seen to it
};

/// A circle about the place of noisy work.
struct ZoneNow {
  twin::Triple<double> centre_m;  ///< NED
  double radius_m = 0;
};

/// What is shown of a vehicle beside its pose, and what a stick is shaped by.
struct VehicleNow {
  Pose pose;
  twin::Measured known;  ///< what it goes by itself, with what carries it
  twin::Triple<double> home_m;
  twin::HelmMode mode{};
  twin::HelmCause cause{};
  std::optional<double> home_at_s;  ///< of the run: when it goes home, for want of a helm
  live::MissionWords words;
  std::vector<twin::Waypoint> waypoints;  ///< left of what it goes by, NED
  double margin_s = 0;                    ///< of its energy; not a number where none is computed
  std::string advice;
  std::vector<AlarmNow> alarms;
  twin::CameraPointing camera;
  std::optional<ZoneNow> zone;  ///< that it watches for animals
  /// Its tether from the top to the vehicle, NED; empty: it has none, or it has parted.
  std::vector<twin::Triple<double>> line_m;
  std::vector<double> thrust;  ///< of each thruster, as a share of what it can; -1 to 1
  /// How far its inspection has come, once a second; null: it inspects nothing.
  std::shared_ptr<const twin::InspectionState> looks;
};

/// All vehicles at a barrier.
struct RunNow {
  double time_s = 0;
  std::uint64_t step = 0;
  const twin::Agent* agents = nullptr;  ///< as many as there are vehicles; they stay where they are
  std::vector<VehicleNow> vehicles;
  std::shared_ptr<const Surroundings> around;  ///< once a second another one
};

/// Looks at a run at its barriers. On the thread of the run.
class RunLook {
 public:
  explicit RunLook(const api::RunInHand& hand) : hand_(hand) {}
  [[nodiscard]] RunNow look();

 private:
  api::RunInHand hand_;
  std::vector<live::ReserveAdvice> advice_;
  std::vector<dds::Reserve> reserve_;
  double reserve_at_s_ = -1;
  std::shared_ptr<const Surroundings> around_;
  std::vector<std::shared_ptr<const twin::InspectionState>> looks_;
};

}  // namespace slackwater::people
