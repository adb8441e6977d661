#pragma once
#include <array>
#include <cstddef>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "twin/body/spatial.h"

namespace slackwater::twin {

inline constexpr std::size_t most_strips = 16;
inline constexpr std::size_t section_points = 65;

/// The section of a hull up to a waterline parallel to its deck.
struct Section {
  double area_m2 = 0;           ///< under water
  double moment_m3 = 0;         ///< of that area about the keel
  double breadth_m = 0;         ///< of the waterline
  double second_moment_m3 = 0;  ///< of the waterline: breadth cubed/12
};

inline constexpr std::size_t most_sections = 4;

/// Strips of one section, whose geometry up to a waterline parallel to the deck says all that is
/// needed.
struct HullPart {
  std::size_t first = 0;   ///< of its strips
  std::size_t strips = 0;  ///< one behind the other from the stern on, then comes the next hull
  std::size_t strips_in_row = 0;
  double strip_length_m = 0;
  double section_depth_m = 0;                     ///< from keel to deck
  std::array<Section, section_points> section{};  ///< from keel to deck, at even heights
  /// Above the keel: where a strip feels the waves, see `strip_place`.
  double felt_height_m = 0;
};

/// The hulls of a surface craft as strips across them. No strips: a craft that does not float.
struct FloatingHull {
  std::size_t strips = 0;
  std::array<Triple<double>, most_strips> keel_m{};  ///< the lowest point of a strip, body axes
  std::size_t parts = 0;
  std::array<HullPart, most_sections> part{};
  /// Of each strip in what the whole craft feels of the water's motion; they add up to one.
  std::array<double, most_strips> share{};
  Triple<double> middle_m;  ///< of the strips, along x and y
  double spread_x_m2 = 0;   ///< mean square distance of the strips from it
  double spread_y_m2 = 0;
};

/// The waves at the strips of a craft, NED, each at its `strip_place`; zeros: calm.
template <typename Real>
struct WaterAtStrips {
  /// Dynamic pressure over rho g: the elevation of the surface less what of it does not reach down
  /// there.
  std::array<Real, most_strips> head_m{};
  std::array<Triple<Real>, most_strips> velocity_m_s{};  ///< orbital
  std::array<Triple<Real>, most_strips> acceleration_m_s2{};
};

/// Where the waves are to be asked for on behalf of a strip: NED from the site's origin.
///
/// Waves fade with depth, so that a hull feels less of them than their elevation (Smith effect). A
/// section of area A and breadth B at the waterline is lifted by rho g B zeta (1 - k A/B + ...):
/// the pressure at the depth A/B, its mean draught, times its breadth. Source: Salvesen, Tuck &
/// Faltinsen (1970), whose decay is that at the draught times the area coefficient.
template <typename Real>
[[nodiscard]] Triple<Real> strip_place(const FloatingHull& hull, const HullPart& part,
                                       std::size_t strip, const Rotation<Real>& r,
                                       const Triple<Real>& position_m) {
  const Triple<double>& keel = hull.keel_m[strip];
  return position_m + r.to_ned(Triple<Real>{Real{} + keel.x, Real{} + keel.y,
                                            Real{} + (keel.z - part.felt_height_m)});
}

/// What of the water's motion at the strips a rigid body can follow, NED: means over the strips,
/// which stay as they are while the hull turns. `ned` of `moments_of` are velocities or
/// accelerations.
template <typename Real>
struct StripMoments {
  Triple<Real> mean;
  Triple<Real> by_x;  ///< times how far forward of the middle the strip is
  Triple<Real> by_y;  ///< and how far to starboard
};
template <typename Real>
[[nodiscard]] StripMoments<Real> moments_of(const FloatingHull& hull,
                                            const std::array<Triple<Real>, most_strips>& ned) {
  StripMoments<Real> sum;
  for (std::size_t i = 0; i < hull.strips; ++i) {
    const double share = hull.share[i];
    const double x = share * (hull.keel_m[i].x - hull.middle_m.x);
    const double y = share * (hull.keel_m[i].y - hull.middle_m.y);
    const Triple<Real>& v = ned[i];
    sum.mean = sum.mean + Triple<Real>{share * v.x, share * v.y, share * v.z};
    sum.by_x = sum.by_x + Triple<Real>{x * v.x, x * v.y, x * v.z};
    sum.by_y = sum.by_y + Triple<Real>{y * v.x, y * v.y, y * v.z};
  }
  return sum;
}

/// The rigid motion, body axes about the origin, that comes nearest to what the water does at the
/// strips, by least squares. With the strip theory's mass and damping spread evenly along the
/// hulls, what a hull feels of the water is what it would feel of its own motion against this one.
template <typename Real>
[[nodiscard]] Spatial<Real> motion_of_strips(const FloatingHull& hull, const Rotation<Real>& r,
                                             const StripMoments<Real>& moments) {
  const Triple<Real> by_x = r.to_body(moments.by_x);
  const Triple<Real> by_y = r.to_body(moments.by_y);
  const auto over = [](double spread_m2) { return spread_m2 > 0 ? 1 / spread_m2 : 0.0; };
  const Triple<Real> angular{over(hull.spread_y_m2) * by_y.z, -(over(hull.spread_x_m2) * by_x.z),
                             over(hull.spread_x_m2 + hull.spread_y_m2) * (by_x.y - by_y.x)};
  const Triple<Real> middle{Real{} + hull.middle_m.x, Real{} + hull.middle_m.y, Real{}};
  return {r.to_body(moments.mean) - cross(angular, middle), angular};
}

/// The waves that a hull meets during a step.
template <typename Real>
struct WavesMet {
  const WaterAtStrips<Real>* at_strips = nullptr;  ///< null: calm
  StripMoments<Real> velocity;
  StripMoments<Real> acceleration;
};
/// Points to `water`, which outlives it.
template <typename Real>
[[nodiscard]] WavesMet<Real> waves_met(const FloatingHull& hull, const WaterAtStrips<Real>& water) {
  return {&water, moments_of(hull, water.velocity_m_s), moments_of(hull, water.acceleration_m_s2)};
}
template <typename Real>
WavesMet<Real> waves_met(const FloatingHull&, WaterAtStrips<Real>&&) = delete;

/// Buoyancy and the push of the waves, body axes about the origin.
///
/// The water bears a strip up against n, the plumb line in the accelerated water, which is square
/// to its surface: n = (z - a/g) with a the horizontal acceleration (the Froude-Krylov force, for
/// waves long beside the breadth of a hull). In calm water the force is the gradient of an energy,
/// so that none is won or lost. Per length of a strip over rho g,
///
///   U = A(h) s - n_z M(h) + (I_y(h) n_y^2 + I_x(h) n_x^2)/2,   h = s/n_z
///
/// with s how far the keel lies below the surface, h the height of the waterline up the section, A
/// and M the area under water and its moment about the keel, I_y = B^3/12 and I_x = B l^2/12 the
/// waterplane's own second moments (small heel: the centre of the water displaced moves to the low
/// side). Upside down it is the rest of the section that is under water.
/// Source: Fossen (2011) 4.2 and 5.3; Faltinsen (1990), ch. 3.
///
/// Adds it for the strips of one section to `sum`.
template <typename Real>
void add_floating_force(const FloatingHull& hull, const HullPart& part, double water_density_kg_m3,
                        const Rotation<Real>& r, const Real& down_m,
                        const WaterAtStrips<Real>* water, Spatial<Real>& sum) {
  constexpr double per_gravity_s2_m = 1 / constants::gravity_m_s2;
  constexpr double last = section_points - 1;
  // Within 12 degrees of lying on its side, where a waterline up the section means little, n_z is
  // kept off 0.
  constexpr double on_its_side = 0.2;
  const double middle_m = 0.5 * part.section_depth_m;
  const double per_m = last / part.section_depth_m;
  const double point_m = part.section_depth_m / last;
  const double length2_m2 = part.strip_length_m * part.strip_length_m / 12;
  const Real weight_n_m2 = Real{} + water_density_kg_m3 * constants::gravity_m_s2 *
                                        part.strip_length_m;  // per area of section
  for (std::size_t i = part.first; i < part.first + part.strips; ++i) {
    const Triple<double>& keel = hull.keel_m[i];
    const Triple<Real> a = water ? water->acceleration_m_s2[i] : Triple<Real>{};
    const Triple<Real> n =
        r.to_body(Triple<Real>{-per_gravity_s2_m * a.x, -per_gravity_s2_m * a.y, Real{} + 1.0});
    const Real upright = select(n.z < 0.0, smaller_of(n.z, Real{} - on_its_side),
                                larger_of(n.z, Real{} + on_its_side));
    const Real per_upright = 1.0 / upright;
    const Real head = water ? water->head_m[i] : Real{};
    const Real under = down_m + (r.down.x * keel.x + r.down.y * keel.y + r.down.z * keel.z) + head;
    const Real wanted = (middle_m + (under - middle_m * n.z) * per_upright) * per_m;
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
    // A `Section` is a row of four numbers.
    const std::array<Real, 4> below = four_entries_of(&part.section[0].area_m2, low);
    const std::array<Real, 4> above = four_entries_of(&part.section[1].area_m2, low);
    const auto look_up = [&](std::size_t of) -> Entry {
      const Real step = above[of] - below[of];
      return {below[of] + share * step, per_m * step};
    };
    const Real height = point_m * place;
    const Real area = look_up(0).value;
    const Real moment = below[1] + (area - below[0]) * (0.5 * (height + point_m * low));
    const Entry along = look_up(2);
    const Entry across = look_up(3);
    const Real heeled2 = n.y * n.y;
    const Real trimmed2 = length2_m2 * (n.x * n.x);
    // d/ds of the last term.
    const Real eased =
        is_cut * (0.5 * (across.slope * heeled2 + along.slope * trimmed2)) * per_upright;
    const Real area_under =
        select(n.z < 0.0, part.section[section_points - 1].area_m2 - area, area) + eased;
    const Real moment_under =
        select(n.z < 0.0, part.section[section_points - 1].moment_m3 - moment, moment) +
        height * eased;
    const Triple<Real> by_n{is_cut * (length2_m2 * along.value) * n.x, is_cut * across.value * n.y,
                            -moment_under};
    const Spatial<Real> at_keel =
        force_at(Triple<Real>{Real{} + keel.x, Real{} + keel.y, Real{} + keel.z}, -area_under * n);
    sum = sum + Spatial<Real>{weight_n_m2 * at_keel.linear,
                              weight_n_m2 * (at_keel.angular + cross(n, by_n))};
  }
}

template <typename Real>
[[nodiscard]] Spatial<Real> floating_force(const FloatingHull& hull, double water_density_kg_m3,
                                           const Rotation<Real>& r, const Real& down_m,
                                           const WaterAtStrips<Real>* water) {
  Spatial<Real> sum{};
  for (std::size_t i = 0; i < hull.parts; ++i)
    add_floating_force(hull, hull.part[i], water_density_kg_m3, r, down_m, water, sum);
  return sum;
}

/// `hulls` of a vehicle's YAML, a mapping or a list of up to four, each with its own section:
/// cylinders (`radius_m`) or boxes with a deadrise (`beam_m`, `depth_m`, `deadrise_deg`),
/// `from_x_m` to `to_x_m`, at each of `centre_y_m`, `keel_z_m` below the origin, cut into `strips`
/// each. Waves shorter than two strips are not told from longer ones: six or more to a hull.
[[nodiscard]] FloatingHull read_floating_hull(const Config& vehicle);

/// How far below the surface the origin of a craft at rest lies, level, in still water; negative
/// above it.
/// @throws Error(invalid_input) for one that sinks
[[nodiscard]] double floating_depth_m(const FloatingHull& hull, double mass_kg,
                                      double water_density_kg_m3);

/// The section at a draught, by the table's own linear steps.
[[nodiscard]] Section section_at(const HullPart& part, double draught_m);

/// Tells a hull how deep it floats, its origin this far below the surface: where its strips feel
/// the waves, and what share of them each has where sections differ.
void settle(FloatingHull& hull, double down_m);

}  // namespace slackwater::twin
