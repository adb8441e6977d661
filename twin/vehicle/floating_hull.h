#pragma once
#include <array>
#include <cstddef>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "twin/vehicle/spatial.h"

namespace slackwater::twin {

inline constexpr std::size_t most_strips = 16;
inline constexpr std::size_t section_points = 65;

/// The hulls of a surface craft as strips across them, all of one section, whose geometry up to a waterline parallel to
/// the deck says all that is needed. No strips: a craft that does not float.
struct FloatingHull {
  std::size_t strips = 0;
  std::array<Triple<double>, most_strips> keel_m{};  ///< the lowest point of a strip, body axes
  double strip_length_m = 0;
  double section_depth_m = 0;  ///< from keel to deck
  // At heights of the waterline above the keel from 0 to `section_depth_m`, evenly.
  std::array<double, section_points> area_m2{};           ///< under water
  std::array<double, section_points> moment_m3{};         ///< of that area about the keel
  std::array<double, section_points> breadth_m{};         ///< of the waterline
  std::array<double, section_points> second_moment_m3{};  ///< of the waterline: breadth cubed/12
  /// Above the keel: where a strip feels the waves, see `strip_place`.
  double felt_height_m = 0;
  Triple<double> middle_m;  ///< of the strips, along x and y
  double spread_x_m2 = 0;   ///< mean square distance of the strips from it
  double spread_y_m2 = 0;
};

/// The waves at the strips of a craft, NED, each at its `strip_place`; zeros: calm.
template <typename Real>
struct WaterAtStrips {
  /// Dynamic pressure over rho g: the elevation of the surface less what of it does not reach down there.
  std::array<Real, most_strips> head_m{};
  std::array<Triple<Real>, most_strips> velocity_m_s{};  ///< orbital
  std::array<Triple<Real>, most_strips> acceleration_m_s2{};
};

/// Where the waves are to be asked for on behalf of a strip: NED from the site's origin.
///
/// Waves fade with depth, so that a hull feels less of them than their elevation (Smith effect). A section of area A and
/// breadth B at the waterline is lifted by rho g B zeta (1 - k A/B + ...): the pressure at the depth A/B, its mean draught,
/// times its breadth. Source: Salvesen, Tuck & Faltinsen (1970), whose decay is that at the draught times the area coefficient.
template <typename Real>
[[nodiscard]] Triple<Real> strip_place(const FloatingHull& hull, std::size_t strip,
                                       const Rotation<Real>& r, const Triple<Real>& position_m) {
  const Triple<double>& keel = hull.keel_m[strip];
  return position_m + r.to_ned(Triple<Real>{Real{} + keel.x, Real{} + keel.y,
                                            Real{} + (keel.z - hull.felt_height_m)});
}

/// The rigid motion, body axes about the origin, that comes nearest to what the water does at the strips, by least
/// squares; `ned` are velocities or accelerations. With the strip theory's mass and damping spread evenly along the hulls,
/// what a hull feels of the water is what it would feel of its own motion against this one.
template <typename Real>
[[nodiscard]] Spatial<Real> motion_of_strips(const FloatingHull& hull, const Rotation<Real>& r,
                                             const std::array<Triple<Real>, most_strips>& ned) {
  Triple<Real> mean{};
  Real rolled{}, pitched{}, turned{};
  for (std::size_t i = 0; i < hull.strips; ++i) {
    const Triple<Real> v = r.to_body(ned[i]);
    const double x = hull.keel_m[i].x - hull.middle_m.x;
    const double y = hull.keel_m[i].y - hull.middle_m.y;
    mean = mean + v;
    rolled = rolled + y * v.z;
    pitched = pitched - x * v.z;
    turned = turned + (x * v.y - y * v.x);
  }
  const double share = 1.0 / static_cast<double>(hull.strips);
  const auto over = [&](double spread_m2) { return spread_m2 > 0 ? share / spread_m2 : 0.0; };
  const Triple<Real> angular{over(hull.spread_y_m2) * rolled, over(hull.spread_x_m2) * pitched,
                             over(hull.spread_x_m2 + hull.spread_y_m2) * turned};
  const Triple<Real> middle{Real{} + hull.middle_m.x, Real{} + hull.middle_m.y, Real{}};
  const Triple<Real> at_middle{share * mean.x, share * mean.y, share * mean.z};
  return {at_middle - cross(angular, middle), angular};
}

/// Buoyancy and the push of the waves, body axes about the origin.
///
/// The water bears a strip up against n, the plumb line in the accelerated water, which is square to its surface:
/// n = (z - a/g) with a the horizontal acceleration (the Froude-Krylov force, for waves long beside the breadth of a hull).
/// In calm water the force is the gradient of an energy, so that none is won or lost. Per length of a strip over rho g,
///
///   U = A(h) s - n_z M(h) + (I_y(h) n_y^2 + I_x(h) n_x^2)/2,   h = s/n_z
///
/// with s how far the keel lies below the surface, h the height of the waterline up the section, A and M the area under
/// water and its moment about the keel, I_y = B^3/12 and I_x = B l^2/12 the waterplane's own second moments (small heel: the
/// centre of the water displaced moves to the low side). Upside down it is the rest of the section that is under water.
/// Source: Fossen (2011) 4.2 and 5.3; Faltinsen (1990), ch. 3.
template <typename Real>
[[nodiscard]] Spatial<Real> floating_force(const FloatingHull& hull, double water_density_kg_m3,
                                           const Rotation<Real>& r, const Real& down_m,
                                           const WaterAtStrips<Real>& water) {
  using constants::gravity_m_s2;
  constexpr double last = section_points - 1;
  // Within 12 degrees of lying on its side, where a waterline up the section means little, n_z is kept off 0.
  constexpr double on_its_side = 0.2;
  const double middle_m = 0.5 * hull.section_depth_m;
  const double per_m = last / hull.section_depth_m;
  const double length2_m2 = hull.strip_length_m * hull.strip_length_m / 12;
  const Real weight_n_m2 =
      Real{} + water_density_kg_m3 * gravity_m_s2 * hull.strip_length_m;  // per area of section
  Spatial<Real> sum{};
  for (std::size_t i = 0; i < hull.strips; ++i) {
    const Triple<double>& keel = hull.keel_m[i];
    const Triple<Real>& a = water.acceleration_m_s2[i];
    const Triple<Real> n =
        r.to_body(Triple<Real>{-(a.x / gravity_m_s2), -(a.y / gravity_m_s2), Real{} + 1.0});
    const Real upright = select(n.z < 0.0, smaller_of(n.z, Real{} - on_its_side),
                                larger_of(n.z, Real{} + on_its_side));
    const Real under =
        down_m + (r.down.x * keel.x + r.down.y * keel.y + r.down.z * keel.z) + water.head_m[i];
    const Real wanted = (middle_m + (under - middle_m * n.z) / upright) * per_m;
    const Real place = smaller_of(larger_of(wanted, Real{} + 0.0), Real{} + last);
    const Real low = smaller_of(whole_below(place), Real{} + (last - 1));
    const Real share = place - low;
    // A section that is all dry or all drowned has no waterline.
    const Real is_cut =
        select(wanted < 0.0, Real{} + 0.0, select(wanted < last, Real{} + 1.0, Real{} + 0.0));
    struct Entry {
      Real value;
      Real slope;
    };
    const auto look_up = [&](const std::array<double, section_points>& table) -> Entry {
      const Real below = entry_of(table.data(), low);
      const Real step = entry_of(table.data() + 1, low) - below;
      return {below + share * step, per_m * step};
    };
    const Real height = place / per_m;
    const Real area = look_up(hull.area_m2).value;
    const Real moment =
        entry_of(hull.moment_m3.data(), low) +
        (area - entry_of(hull.area_m2.data(), low)) * (0.5 * (height + low / per_m));
    const Entry across = look_up(hull.second_moment_m3);
    const Entry along = look_up(hull.breadth_m);
    const Real heeled2 = n.y * n.y;
    const Real trimmed2 = length2_m2 * (n.x * n.x);
    // d/ds of the last term.
    const Real eased = is_cut * (0.5 * (across.slope * heeled2 + along.slope * trimmed2)) / upright;
    const Real area_under =
        select(n.z < 0.0, hull.area_m2[section_points - 1] - area, area) + eased;
    const Real moment_under =
        select(n.z < 0.0, hull.moment_m3[section_points - 1] - moment, moment) + height * eased;
    const Triple<Real> by_n{is_cut * (length2_m2 * along.value) * n.x, is_cut * across.value * n.y,
                            -moment_under};
    const Spatial<Real> at_keel =
        force_at(Triple<Real>{Real{} + keel.x, Real{} + keel.y, Real{} + keel.z}, -area_under * n);
    sum = sum + Spatial<Real>{weight_n_m2 * at_keel.linear,
                              weight_n_m2 * (at_keel.angular + cross(n, by_n))};
  }
  return sum;
}

/// `hulls` of a vehicle's YAML: cylinders (`radius_m`) or boxes with a deadrise (`beam_m`, `depth_m`, `deadrise_deg`),
/// `from_x_m` to `to_x_m`, at each of `centre_y_m`, `keel_z_m` below the origin, cut into `strips` each. Waves shorter than
/// two strips are not told from longer ones: six or more to a hull.
[[nodiscard]] FloatingHull read_floating_hull(const Config& vehicle);

/// How far below the surface the origin of a craft at rest lies, level, in still water; negative above it.
/// @throws Error(invalid_input) for one that sinks
[[nodiscard]] double floating_depth_m(const FloatingHull& hull, double mass_kg,
                                      double water_density_kg_m3);

/// `felt_height_m` of a hull that floats with its keel this far under water.
[[nodiscard]] double felt_height_m(const FloatingHull& hull, double draught_m);

}  // namespace slackwater::twin
