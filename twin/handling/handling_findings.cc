#include "twin/handling/handling_findings.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/step/open_loop.h"
#include "twin/vehicle/own_autopilot.h"
#include "twin/vehicle/top_speed.h"

namespace slackwater::twin {
namespace {

using constants::degree;

/// The plane in which a vehicle leaves its way.
enum class Plane { horizontal, vertical, roll };

Plane plane_of(const KeptCourse& course, const OpenLoop& by_itself) {
  if (course.over_at_s && !(by_itself.pitch_per_s > 0)) return Plane::roll;
  return course.over_at_s || course.depth_off_m > 3 ? Plane::vertical : Plane::horizontal;
}

/// The derivatives of lift that hold a vehicle in a plane, as their keys have them, of which its
/// file has none; all of them where it has no lift at all.
std::vector<std::string> absent_lift(const Vehicle& vehicle, Plane plane) {
  const SpeedLift& lift = vehicle.body.speed_lift;
  std::vector<std::string> absent;
  const auto note = [&](const char* key, double value) {
    if (value == 0) absent.emplace_back(key);
  };
  if (plane == Plane::horizontal) {
    note("Y_uv", lift.y_uv);
    note("N_uv", lift.n_uv);
    note("Y_ur", lift.y_ur);
    note("N_ur", lift.n_ur);
  } else {
    note("Z_uw", lift.z_uw);
    note("M_uw", lift.m_uw);
    note("Z_uq", lift.z_uq);
    note("M_uq", lift.m_uq);
  }
  return absent;
}

/// Fins that the water meets aslant hold it too.
bool has_holding_fins(const Vehicle& vehicle, Plane plane) {
  const FinPair& fins = plane == Plane::horizontal ? vehicle.rudder : vehicle.elevator;
  return fins.area_m2 > 0 && fins.passive_share > 0 && fins.position_x_m < 0;
}

struct Cause {
  const char* key;  ///< of the file
  std::string advice;
};

/// What its file most likely lacks. In words of its keys.
Cause likely_cause(const Vehicle& vehicle, Plane plane, bool grows_by_itself) {
  const bool horizontal = plane == Plane::horizontal;
  const char* const loop = horizontal ? "heading_period_s" : "tilt_period_s";
  Cause slow{"autopilot", formatted("Give `autopilot` a shorter {}, or the fins and "
                                    "thrusters that it steers by more room",
                                    loop)};
  if (plane == Plane::roll)
    return {"displacement",
            "Check what holds it upright (centre_of_gravity_m, K_p of `damping`), the periods of "
            "`autopilot` and the masses"};
  if (!grows_by_itself) return slow;
  const std::vector<std::string> absent = absent_lift(vehicle, plane);
  const bool has_edge = horizontal && vehicle.body.trailing_edge_kg_m > 0;
  if (absent.size() == 4 && !has_edge && !has_holding_fins(vehicle, plane))
    return {"lift",
            formatted("Nothing of its hull or its fins holds it against the moment of its added "
                      "mass (Munk): most likely `lift` with {} is missing",
                      joined(absent, ", "))};
  if (!absent.empty() && absent.size() < 4)
    return {"lift", formatted("Most likely {} of `lift` is missing, or `munk` counts the moment of "
                              "the added mass twice",
                              joined(absent, ", "))};
  return slow;
}

std::string came_to(const KeptCourse& course) {
  if (course.over_at_s) return formatted("it goes over after {:.0f} s", *course.over_at_s);
  std::string off =
      formatted("it goes {:.0f} degrees off its course", course.heading_off_rad / degree);
  if (course.depth_off_m > 0.05)
    off += formatted(" and {:.2g} m off its depth", course.depth_off_m);
  return off;
}

std::string grows(const OpenLoop& by_itself, Plane plane) {
  const double per_s = plane == Plane::horizontal ? by_itself.yaw_per_s
                       : plane == Plane::vertical ? by_itself.pitch_per_s
                                                  : by_itself.roll_per_s;
  if (!(per_s > 0)) return "";
  const char* const what = plane == Plane::horizontal ? "yaw"
                           : plane == Plane::vertical ? "pitch"
                                                      : "roll";
  return formatted("; by itself {} grows e-fold in {:.2g} s", what, 1 / per_s);
}

}  // namespace

std::vector<VehicleFinding> findings_on_handling(const Vehicle& vehicle) {
  if (vehicle.kind == VehicleKind::uav) return {};
  const double voltage_v = usual_voltage_v(vehicle);
  const Autopilot autopilot = own_autopilot(vehicle, vehicle.autopilot, voltage_v);
  // One that it does not reach is another finding (`expect_speeds`).
  const double speed_m_s =
      std::min(vehicle.cruise_speed_m_s, top_speed_m_s(vehicle, autopilot, voltage_v, true));
  const KeptCourse course = kept_course(vehicle, autopilot, speed_m_s);
  if (is_kept(course)) return {};
  if (!course.over_at_s && !course.is_judged)
    return {
        {false, "autopilot",
         formatted("its loops are so slow that {:.0f} s do not tell whether it keeps its course "
                   "and its depth: fly it in a scenario before it is relied on",
                   course.lasts_s)}};
  const OpenLoop by_itself = open_loop_of(vehicle);
  const Plane plane = plane_of(course, by_itself);
  const bool grows_by_itself =
      (plane == Plane::horizontal ? by_itself.yaw_per_s : by_itself.pitch_per_s) > 0;
  const Cause cause = likely_cause(vehicle, plane, grows_by_itself);
  const bool is_error = is_lost(course);
  return {{is_error, cause.key,
           formatted("found that its own autopilot does not {} it straight and level at {:.3g} "
                     "m/s in still water: {} in {:.0f} s{}; expected at most 5 degrees and 1 m. {}",
                     is_error ? "keep" : "quite keep", course.speed_m_s, came_to(course),
                     course.lasts_s, grows(by_itself, plane), cause.advice)}};
}

Vehicle read_handled_vehicle(const std::filesystem::path& file,
                             const std::filesystem::path& data_folder) {
  Vehicle vehicle = read_vehicle(file, data_folder);
  for (const VehicleFinding& finding : findings_on_handling(vehicle)) {
    if (finding.is_error)
      throw Error(ErrorKind::invalid_input,
                  vehicle.place_of(finding.key) + ": " + finding.key + ": " + finding.what);
    vehicle.warnings.push_back(std::string(finding.key) + ": " + finding.what);
  }
  return vehicle;
}

}  // namespace slackwater::twin
