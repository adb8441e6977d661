#include "twin/simulate/carried_water.h"

#include "fields/wave/sea_moment.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

static_assert(carried_places <= most_in_moment);

/// The nodes' currents are looked up anew once in so many looks: the line drifts, and the tide
/// turns, by nothing that matters meanwhile.
constexpr std::size_t current_every = 8;

/// Of the acceleration of the water at a look, what a node has on the way to the next. By trial:
/// with none of it, or with all, tensions in steep waves of 4 s are 2 % higher.
constexpr double line_follows = 1.0 / 3;

void look_at_nodes(const EnvironmentSampler& water, const MovingPlaces& places, double t_s,
                   CarriedWater& carried) {
  const auto look = static_cast<std::size_t>(carried.looks);
  for (std::size_t i = 0; i + 1 < places.count; ++i) {
    if (look > 0 && i % current_every != look % current_every) continue;
    const WaterSample found = water.current(places.at_m[i + 1], 0, t_s);
    // Line that touches the bed has the water of the bed's edge: none.
    carried.node_current_m_s[i] = has_value(found.status) ? found.current_m_s : Triple<double>{};
  }
}

/// @return whether the vehicle has water there
bool look_at(const EnvironmentSampler& water, const MovingPlaces& places, double t_s,
             WaterLook& look) {
  look = {};
  const WaterSample current = water.current(places.at_m[0], places.vehicle_height_m, t_s);
  look.current_m_s = current.current_m_s;
  look.shear_per_s = current.motion.shear_per_s;
  const SeaRealisation* const sea = water.environment().sea.get();
  if (sea == nullptr) return has_value(current.status);
  std::array<MomentPlace, carried_places> asked;
  std::array<MomentSample, carried_places> found;
  for (std::size_t i = 0; i < places.count; ++i) {
    const Vector3<Enu> at = enu_of(places.at_m[i]);
    // The vehicle wants the acceleration of the water, the nodes' shall be carried.
    const Vector3<Enu> goes = enu_of(i == 0 ? look.current_m_s : places.velocity_m_s[i]);
    asked[i] = {at.x(), at.y(), at.z(), {goes.x(), goes.y(), goes.z()}};
  }
  sample_moment(*sea, t_s, std::span(asked).first(places.count),
                std::span(found).first(places.count));
  look.elevation_m = found[0].motion.elevation_m;
  look.rise_m_s = found[0].rise_m_s;
  for (std::size_t i = 0; i < places.count; ++i) {
    if (!has_value(found[i].motion.status)) continue;
    look.orbital_m_s[i] = ned_of(found[i].motion.velocity_m_s);
    look.orbital_m_s2[i] = ned_of(found[i].acceleration_m_s2);
  }
  const SampleStatus status = found[0].motion.status;
  return has_value(current.status) && (has_value(status) || status == SampleStatus::above_surface);
}

/// The weights of a cubic's values and slopes at both ends.
struct Cubic {
  double before = 0, after = 0, slope_before = 0, slope_after = 0;
};

Cubic value_at(double share, double length_s) {
  const double s2 = share * share;
  const double s3 = s2 * share;
  return {2 * s3 - 3 * s2 + 1, 3 * s2 - 2 * s3, length_s * (s3 - 2 * s2 + share),
          length_s * (s3 - s2)};
}
Cubic slope_at(double share, double length_s) {
  const double s2 = share * share;
  return {(6 * s2 - 6 * share) / length_s, (6 * share - 6 * s2) / length_s, 3 * s2 - 4 * share + 1,
          3 * s2 - 2 * share};
}

Triple<double> along(const Cubic& c, const CarriedWater& water, std::size_t place) {
  return c.before * water.before.orbital_m_s[place] + c.after * water.after.orbital_m_s[place] +
         c.slope_before * water.before.orbital_m_s2[place] +
         c.slope_after * water.after.orbital_m_s2[place];
}

double share_at(const CarriedWater& carried, double t_s) {
  return (t_s - carried.from_s) / (carried.to_s - carried.from_s);
}

double elevation_of(const Cubic& c, const CarriedWater& water) {
  return c.before * water.before.elevation_m + c.after * water.after.elevation_m +
         c.slope_before * water.before.rise_m_s + c.slope_after * water.after.rise_m_s;
}

}  // namespace

void look_ahead(const EnvironmentSampler& water, const MovingPlaces& places, double t_s,
                double ahead_s, CarriedWater& carried) {
  bool had_water = carried.holds > 0.5;
  if (carried.looks > 0.5 && had_water) {
    carried.before = carried.after;
  } else {
    had_water = look_at(water, places, t_s, carried.before);
    carried.looks = 0;
  }
  carried.from_s = t_s;
  carried.to_s = t_s + ahead_s;
  MovingPlaces then = places;
  for (std::size_t i = 0; i < places.count; ++i) {
    // Line goes to and fro with the waves, if not all the way: short ones turn meanwhile.
    const double share = i > 0 ? line_follows : 0;
    const Triple<double> gain_m_s = (share * ahead_s) * carried.before.orbital_m_s2[i];
    then.at_m[i] = places.at_m[i] + ahead_s * (places.velocity_m_s[i] + 0.5 * gain_m_s);
    then.velocity_m_s[i] = places.velocity_m_s[i] + gain_m_s;
  }
  const bool will_have = look_at(water, then, carried.to_s, carried.after);
  look_at_nodes(water, then, carried.to_s, carried);
  carried.holds = had_water && will_have ? 1 : 0;
  carried.looks += 1;
}

WaterSample vehicle_water(const CarriedWater& carried, double t_s) noexcept {
  const double share = share_at(carried, t_s);
  const double length_s = carried.to_s - carried.from_s;
  const auto between = [&](const Triple<double>& a, const Triple<double>& b) {
    return (1 - share) * a + share * b;
  };
  WaterSample out;
  out.status = SampleStatus::ok;
  out.current_m_s = between(carried.before.current_m_s, carried.after.current_m_s);
  const Cubic value = value_at(share, length_s);
  out.motion.velocity_m_s = out.current_m_s + along(value, carried, 0);
  out.motion.acceleration_m_s2 = along(slope_at(share, length_s), carried, 0);
  out.motion.shear_per_s = between(carried.before.shear_per_s, carried.after.shear_per_s);
  out.motion.elevation_m = elevation_of(value, carried);
  return out;
}

WaterAtNodes<double> node_water(const CarriedWater& carried, double t_s) noexcept {
  const double share = share_at(carried, t_s);
  const Cubic cubic = value_at(share, carried.to_s - carried.from_s);
  WaterAtNodes<double> out;
  for (std::size_t i = 0; i < tether_inner_nodes; ++i)
    out.velocity_m_s[i + 1] = carried.node_current_m_s[i] + along(cubic, carried, i + 1);
  out.velocity_m_s.front() = out.velocity_m_s[1];
  const Triple<double> current_m_s =
      (1 - share) * carried.before.current_m_s + share * carried.after.current_m_s;
  out.velocity_m_s.back() = current_m_s + along(cubic, carried, 0);
  out.elevation_m = elevation_of(cubic, carried);
  return out;
}

}  // namespace slackwater::twin
