#include "twin/environment/carried_water.h"

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

/// Of the places: those that are looked at together.
using Chosen = std::array<bool, carried_places>;

/// The waves of one moment at the places of a choice; none in a calm.
/// @return how the vehicle's fared, if it was among them
SampleStatus look_at_waves(const EnvironmentSampler& water, const MovingPlaces& places,
                           const Chosen& chosen, double t_s, WaterLook& look) {
  for (std::size_t i = 0; i < places.count; ++i)
    if (chosen[i]) look.at_s[i] = t_s;
  const SeaRealisation* const sea = water.waves();
  if (sea == nullptr) return SampleStatus::ok;
  std::array<MomentPlace, carried_places> asked;
  std::array<MomentSample, carried_places> found;
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.count; ++i) {
    if (!chosen[i]) continue;
    const Vector3<Enu> at = enu_of(places.at_m[i]);
    // The vehicle wants the acceleration of the water, the nodes' shall be carried.
    const Vector3<Enu> goes = enu_of(i == 0 ? look.current_m_s : places.velocity_m_s[i]);
    asked[count++] = {at.x(), at.y(), at.z(), {goes.x(), goes.y(), goes.z()}};
  }
  sample_moment(*sea, t_s, std::span(asked).first(count), std::span(found).first(count));
  count = 0;
  for (std::size_t i = 0; i < places.count; ++i) {
    if (!chosen[i]) continue;
    const MomentSample& sample = found[count++];
    const bool is_wet = has_value(sample.motion.status);
    look.orbital_m_s[i] = is_wet ? ned_of(sample.motion.velocity_m_s) : Triple<double>{};
    look.orbital_m_s2[i] = is_wet ? ned_of(sample.acceleration_m_s2) : Triple<double>{};
  }
  if (!chosen[0]) return SampleStatus::ok;
  look.elevation_m = found[0].motion.elevation_m;
  look.rise_m_s = found[0].rise_m_s;
  return found[0].motion.status;
}

/// The vehicle, and what else is chosen with it. @return whether the vehicle has water there
bool look_at(const EnvironmentSampler& water, const MovingPlaces& places, const Chosen& chosen,
             double t_s, WaterLook& look) {
  const WaterSample current = water.current(places.at_m[0], places.vehicle_height_m, t_s);
  look.current_m_s = current.current_m_s;
  look.shear_per_s = current.motion.shear_per_s;
  const SampleStatus status = look_at_waves(water, places, chosen, t_s, look);
  return has_value(current.status) && (has_value(status) || status == SampleStatus::above_surface);
}

/// For how many looks ahead a node at a depth is looked at: see `look_ahead`.
constexpr std::array looks_ahead{1, 2, 4, 8};
constexpr double depth_for_m_s2 = 10;
int looks_for(double depth_m, double ahead_s) {
  int looks = 1;
  for (const int more : looks_ahead)
    if (depth_m > depth_for_m_s2 * (more * ahead_s) * (more * ahead_s)) looks = more;
  return looks;
}

/// Where the places will be. Line goes to and fro with the waves, if not all the way: short ones
/// turn meanwhile.
MovingPlaces places_after(const MovingPlaces& places, const WaterLook& now, double ahead_s,
                          double follows) {
  MovingPlaces then = places;
  for (std::size_t i = 0; i < places.count; ++i) {
    const double share = i > 0 ? follows : 0;
    const Triple<double> gain_m_s = (share * ahead_s) * now.orbital_m_s2[i];
    then.at_m[i] = places.at_m[i] + ahead_s * (places.velocity_m_s[i] + 0.5 * gain_m_s);
    then.velocity_m_s[i] = places.velocity_m_s[i] + gain_m_s;
  }
  return then;
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

/// Between the looks at a place.
struct Between {
  double share = 0;
  double length_s = 0;
};
Between between_looks(const CarriedWater& water, std::size_t place, double t_s) {
  const double from_s = water.before.at_s[place];
  const double length_s = water.after.at_s[place] - from_s;
  return {(t_s - from_s) / length_s, length_s};
}

double elevation_of(const Cubic& c, const CarriedWater& water) {
  return c.before * water.before.elevation_m + c.after * water.after.elevation_m +
         c.slope_before * water.before.rise_m_s + c.slope_after * water.after.rise_m_s;
}

}  // namespace

void look_ahead(const EnvironmentSampler& water, const MovingPlaces& places, double t_s,
                double ahead_s, CarriedWater& carried) {
  const double late_s = 0.5 * ahead_s;
  bool had_water = carried.holds > 0.5;
  Chosen due{};
  if (carried.looks > 0.5 && had_water) {
    for (std::size_t i = 0; i < places.count; ++i) {
      due[i] = i == 0 || t_s > carried.after.at_s[i] - late_s;
      if (!due[i]) continue;
      carried.before.at_s[i] = carried.after.at_s[i];
      carried.before.orbital_m_s[i] = carried.after.orbital_m_s[i];
      carried.before.orbital_m_s2[i] = carried.after.orbital_m_s2[i];
    }
    carried.before.current_m_s = carried.after.current_m_s;
    carried.before.shear_per_s = carried.after.shear_per_s;
    carried.before.elevation_m = carried.after.elevation_m;
    carried.before.rise_m_s = carried.after.rise_m_s;
  } else {
    due.fill(true);
    carried.before = {};
    carried.after = {};
    had_water = look_at(water, places, due, t_s, carried.before);
    carried.looks = 0;
  }
  carried.to_s = t_s + ahead_s;
  bool will_have = false;
  for (const int looks : looks_ahead) {
    Chosen chosen{};
    bool any = false;
    for (std::size_t i = 0; i < places.count; ++i) {
      chosen[i] = due[i] && (i == 0 ? 1 : looks_for(places.at_m[i].z, ahead_s)) == looks;
      any = any || chosen[i];
    }
    if (!any) continue;
    const double far_s = looks * ahead_s;
    const MovingPlaces then = places_after(places, carried.before, far_s, line_follows);
    if (looks == 1) {
      will_have = look_at(water, then, chosen, carried.to_s, carried.after);
      look_at_nodes(water, then, carried.to_s, carried);
    } else {
      (void)look_at_waves(water, then, chosen, t_s + far_s, carried.after);
    }
  }
  carried.holds = had_water && will_have ? 1 : 0;
  carried.looks += 1;
}

WaterSample vehicle_water(const CarriedWater& carried, double t_s) noexcept {
  const auto [share, length_s] = between_looks(carried, 0, t_s);
  const auto between = [rest = 1 - share, gone = share](const Triple<double>& a,
                                                        const Triple<double>& b) {
    return rest * a + gone * b;
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
  const auto [share, length_s] = between_looks(carried, 0, t_s);
  const Cubic at_vehicle = value_at(share, length_s);
  WaterAtNodes<double> out;
  Cubic cubic = at_vehicle;
  std::size_t same = 0;  // looked at together with it
  for (std::size_t i = 1; i <= tether_inner_nodes; ++i) {
    if (carried.before.at_s[i] != carried.before.at_s[same] ||
        carried.after.at_s[i] != carried.after.at_s[same]) {
      const Between node = between_looks(carried, i, t_s);
      cubic = value_at(node.share, node.length_s);
      same = i;
    }
    out.velocity_m_s[i] = carried.node_current_m_s[i - 1] + along(cubic, carried, i);
  }
  out.velocity_m_s.front() = out.velocity_m_s[1];
  const Triple<double> current_m_s =
      (1 - share) * carried.before.current_m_s + share * carried.after.current_m_s;
  out.velocity_m_s.back() = current_m_s + along(at_vehicle, carried, 0);
  out.elevation_m = elevation_of(at_vehicle, carried);
  return out;
}

}  // namespace slackwater::twin
