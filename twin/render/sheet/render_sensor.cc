#include "twin/render/sheet/render_sensor.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

Triple<double> unit_across(const Triple<double>& a, const Triple<double>& b,
                           const Triple<double>& otherwise) noexcept {
  const Triple<double> across = cross(a, b);
  const double length = length_of(across);
  return length > 1e-6 ? (1 / length) * across : otherwise;
}

}  // namespace

const char* name_of(SensorMedium medium) noexcept {
  constexpr const char* names[] = {"water", "air", "both"};
  return names[static_cast<int>(medium)];
}

Pose pose_of(const RenderSensor& sensor, const Carriage& carriage) noexcept {
  const Rotation<double>& r = carriage.attitude;
  Pose pose;
  const Triple<double> arm_m = r.to_ned(sensor.position_m);
  pose.turning_rad_s = r.to_ned(carriage.rates_rad_s);
  pose.position_m = carriage.position_m + arm_m;
  pose.velocity_m_s = carriage.velocity_m_s + cross(pose.turning_rad_s, arm_m);
  pose.axis = r.to_ned(sensor.axis);
  pose.right = unit_across(r.to_ned({0, 0, 1}), pose.axis, r.to_ned({0, 1, 0}));
  return pose;
}

Pose pose_of(const RenderSensor& sensor, const Carriage& carriage,
             const Triple<double>& place_m) noexcept {
  Instrument turned;
  turned.footprint = FrameFootprint{};
  turned.aim = Aim::surface;
  turned.position_m = sensor.position_m;
  return pose_of(turned, carriage, {place_m, {}});
}

Carriage hull_that_has(const RenderSensor& sensor, const Pose& pose) noexcept {
  const Triple<double> down = cross(pose.axis, pose.right);
  const Rotation<double> turned{{pose.axis.x, pose.right.x, down.x},
                                {pose.axis.y, pose.right.y, down.y},
                                {pose.axis.z, pose.right.z, down.z}};
  return {pose.position_m - turned.to_ned(sensor.position_m), turned, pose.velocity_m_s, {}};
}

Lamp lamp_of(const MountedLamp& lamp, const Carriage& carriage) noexcept {
  const Rotation<double>& r = carriage.attitude;
  return {carriage.position_m + r.to_ned(lamp.position_m), r.to_ned(lamp.axis), lamp.range_m,
          lamp.half_beam_rad};
}

void expect_in_medium(const RenderSensor& sensor, bool is_under_water, const std::string& where) {
  if (sensor.medium == SensorMedium::both) return;
  if ((sensor.medium == SensorMedium::water) == is_under_water) return;
  throw Error(
      ErrorKind::invalid_input,
      formatted("{}: found it {} at {}, expected it in {}; take another time or vehicle, or "
                "a sensor of that medium",
                sensor.name, is_under_water ? "under water" : "in air", where,
                name_of(sensor.medium)));
}

}  // namespace slackwater::twin
