#include "twin/agent/sense.h"

#include <cmath>
#include <string>

#include "fields/base/error.h"

namespace slackwater::twin {
namespace {

constexpr double alignment_s = 30;

double interval_s(const SensorSuite& instruments, std::uint64_t every) {
  return static_cast<double>(every) * instruments.dt_s;
}

/// The lever of the antenna is known and taken out: a fix is that of the vehicle's origin.
std::optional<GnssFix> look_up(const SensorSuite& instruments, InstrumentState& state,
                               const Triple<double>& position_m, const Rotation<double>& r,
                               const Triple<double>& velocity_m_s, double surface_m) {
  const Gnss& gnss = *instruments.sensors.gnss;
  const Triple<double> lever_m = r.to_ned({0, 0, -gnss.antenna_up_m});
  constexpr double far_below_m = 1e9;
  std::optional<GnssFix> fix = measured(gnss, state.gnss, position_m + lever_m, velocity_m_s,
                                        instruments.is_dry ? far_below_m : surface_m,
                                        interval_s(instruments, instruments.gnss_every));
  if (fix) fix->position_m = fix->position_m - lever_m;
  constexpr Triple<double> none{nothing_shown, nothing_shown, nothing_shown};
  state.shown.gnss_position_m = fix ? fix->position_m : none;
  state.shown.gnss_velocity_m_s = fix ? fix->velocity_m_s : none;
  return fix;
}

std::optional<DvlReading> ping(const SensorSuite& instruments, InstrumentState& state,
                               const SensedWater& water, const Triple<double>& position_m,
                               const Rotation<double>& r, const Triple<double>& velocity_m_s) {
  const Scene scene = scene_at(water, position_m);
  // One pointer is kept in the function itself: no allocation.
  const WaterAt flow = [&water](const Triple<double>& at_m) {
    return water.sampler.current(at_m, 0, water.t_s).current_m_s;
  };
  const std::optional<DvlReading> heard =
      measured(*instruments.sensors.dvl, state.dvl, scene, flow, position_m, r, velocity_m_s);
  constexpr Triple<double> none{nothing_shown, nothing_shown, nothing_shown};
  state.shown.dvl_velocity_m_s = heard ? heard->track.velocity_m_s : none;
  state.shown.dvl_is_bottom = heard && heard->bottom ? 1 : 0;
  state.shown.dvl_ahead_m_s = heard && heard->water ? heard->water->velocity_m_s.x : nothing_shown;
  state.shown.dvl_altitude_m = heard && heard->altitude_m ? *heard->altitude_m : nothing_shown;
  return heard;
}

}  // namespace

Navigation plan_navigation(const Vehicle& vehicle, double dt_s, bool steers) {
  const bool floats = vehicle.body.hull.strips > 0;
  const bool dives = vehicle.kind != VehicleKind::uav && !floats;
  const Sensors& sensors = vehicle.sensors;
  const char* missing = !sensors.gnss && !sensors.dvl
                            ? "gnss or dvl, without which it knows no velocity"
                        : dives && !sensors.depth ? "depth, without which it knows no depth"
                                                  : nullptr;
  if (steers && missing != nullptr) {
    throw Error(ErrorKind::invalid_input, std::string("its file has no sensors: ") + missing +
                                              "; add one, or give it navigation: truth");
  }
  Navigation navigation;
  navigation.instruments = plan_instruments(sensors, dt_s, !dives);
  navigation.navigator.has_depth = sensors.depth.has_value();
  navigation.steers = steers;
  return navigation;
}

NavigationState begun(const Navigation& navigation, std::uint64_t seed, std::string_view vehicle,
                      const BodyState<double>& body) {
  const SensorSuite& instruments = navigation.instruments;
  NavigationState state;
  state.instruments = started(instruments, seed, vehicle, body);
  const ImuReading mean = at_rest(instruments, state.instruments, body, alignment_s);
  const double heading_rad = heading_at_rest_rad(instruments, state.instruments, body, alignment_s);
  state.navigator = aligned(body.position_m, mean, heading_rad);
  if (instruments.sensors.gnss) {
    const auto fix =
        look_up(instruments, state.instruments, body.position_m, rotation_of(body.attitude), {}, 0);
    if (fix) {
      state.navigator.position_m.x = fix->position_m.x;
      state.navigator.position_m.y = fix->position_m.y;
      if (!instruments.sensors.depth) state.navigator.position_m.z = fix->position_m.z;
    }
  }
  state.error_m = state.navigator.position_m - body.position_m;
  return state;
}

Scene scene_at(const SensedWater& water, const Triple<double>& position_m) noexcept {
  constexpr double bottomless_m = 1e9;
  const BedSample bed = water.sampler.bed(position_m);
  return {water.sampler.environment().structures,
          has_value(bed.status) ? bed.water_depth_m : bottomless_m, -water.elevation_m};
}

Measured sense(const Navigation& navigation, const SensedWater& water,
               const BodyState<double>& body, NavigationState& state) {
  const SensorSuite& instruments = navigation.instruments;
  const Navigator& navigator = navigation.navigator;
  InstrumentState& looked = state.instruments;
  const Rotation<double> r = rotation_of(body.attitude);
  const Triple<double> velocity_m_s = r.to_ned(body.nu.linear);
  const double surface_m = -water.elevation_m;
  if (looked.steps > 0) {
    const Felt felt = feel(instruments, looked, body);
    reckon(navigator, state.navigator, felt.mean, felt.turn_rate_now_rad_s, instruments.dt_s);
  }
  if (is_due(instruments.compass_every, looked)) {
    looked.shown.heading_rad = measured_heading_rad(*instruments.sensors.compass, looked.compass,
                                                    std::atan2(r.east.x, r.north.x));
    take_heading(navigator, state.navigator, looked.shown.heading_rad,
                 interval_s(instruments, instruments.compass_every));
  }
  if (is_due(instruments.depth_every, looked)) {
    looked.shown.depth_m =
        measured_depth_m(*instruments.sensors.depth, looked.depth, body.position_m.z, surface_m);
    take_depth(navigator, state.navigator, looked.shown.depth_m,
               interval_s(instruments, instruments.depth_every));
  }
  if (!water.has_gnss) {
    looked.shown.gnss_position_m = {nothing_shown, nothing_shown, nothing_shown};
    looked.shown.gnss_velocity_m_s = looked.shown.gnss_position_m;
  }
  if (water.has_gnss && is_due(instruments.gnss_every, looked)) {
    const double passed_s = interval_s(instruments, instruments.gnss_every);
    const auto fix = look_up(instruments, looked, body.position_m, r, velocity_m_s, surface_m);
    if (fix) {
      take_position(navigator, state.navigator, fix->position_m, passed_s);
      take_velocity(navigator, state.navigator, fix->velocity_m_s, passed_s);
    }
  }
  if (is_due(instruments.dvl_every, looked)) {
    const auto heard = ping(instruments, looked, water, body.position_m, r, velocity_m_s);
    // Against the water is against the ground where the water stands still, which is all that is
    // known of it; a fix knows better.
    const bool has_fix = !std::isnan(looked.shown.gnss_position_m.x);
    if (heard && (heard->bottom || !has_fix)) {
      const Rotation<double> taken_for = rotation_of(state.navigator.attitude);
      take_velocity(navigator, state.navigator, taken_for.to_ned(heard->track.velocity_m_s),
                    interval_s(instruments, instruments.dvl_every));
    }
  }
  ++looked.steps;
  state.error_m = state.navigator.position_m - body.position_m;
  Measured measured = measured_of(state.navigator);
  measured.log_m_s = looked.shown.dvl_ahead_m_s;
  if (!std::isnan(looked.shown.dvl_altitude_m)) measured.altitude_m = looked.shown.dvl_altitude_m;
  return measured;
}

}  // namespace slackwater::twin
