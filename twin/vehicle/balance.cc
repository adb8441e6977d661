#include "twin/vehicle/balance.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

using constants::gravity_m_s2;

using constants::degree;

double weight_n(const Vehicle& vehicle) { return vehicle.body.mass_kg * gravity_m_s2; }

/// The section of a hull at a draught, by the table's own linear steps.
Section section_at(const FloatingHull& hull, double draught_m) {
  const double place = (section_points - 1) * draught_m / hull.section_depth_m;
  const auto low =
      static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(section_points - 2)));
  const double share = place - static_cast<double>(low);
  const Section& a = hull.section[low];
  const Section& b = hull.section[low + 1];
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  return {between(a.area_m2, b.area_m2), between(a.moment_m3, b.moment_m3),
          between(a.breadth_m, b.breadth_m), between(a.second_moment_m3, b.second_moment_m3)};
}

Balance afloat(const Vehicle& vehicle) {
  const Body& body = vehicle.body;
  const FloatingHull& hull = body.hull;
  const double keel_m = hull.keel_m[0].z;
  Balance balance;
  balance.draught_m = keel_m + floating_depth_m(hull, body.mass_kg, body.fluid_density_kg_m3);
  const Section section = section_at(hull, balance.draught_m);
  const double strips = static_cast<double>(hull.strips);
  const double length_m = hull.strip_length_m;
  const double volume_m3 = strips * length_m * section.area_m2;
  const double across_m4 =
      strips * length_m * (section.second_moment_m3 + section.breadth_m * hull.spread_y_m2);
  const double along_m4 =
      strips * length_m * section.breadth_m * (hull.spread_x_m2 + length_m * length_m / 12);
  const double below_gravity_m =
      section.moment_m3 / section.area_m2 - (keel_m - body.centre_of_gravity_m.z);
  balance.stability_m = below_gravity_m + across_m4 / volume_m3;
  balance.stability_long_m = below_gravity_m + along_m4 / volume_m3;
  const double aside_m = body.centre_of_gravity_m.y - hull.middle_m.y;
  const double ahead_m = body.centre_of_gravity_m.x - hull.middle_m.x;
  if (balance.stability_m > 0) balance.heel_rad = std::atan(aside_m / balance.stability_m);
  if (balance.stability_long_m > 0)
    balance.trim_rad = std::atan(ahead_m / balance.stability_long_m);
  double forward_m = 0, outward_m = 0;
  for (std::size_t i = 0; i < hull.strips; ++i) {
    forward_m = std::max(forward_m, std::abs(hull.keel_m[i].x - hull.middle_m.x) + 0.5 * length_m);
    outward_m = std::max(outward_m, std::abs(hull.keel_m[i].y - hull.middle_m.y));
  }
  balance.least_freeboard_m = hull.section_depth_m - balance.draught_m -
                              std::abs(std::tan(balance.trim_rad)) * forward_m -
                              std::abs(std::tan(balance.heel_rad)) * outward_m;
  return balance;
}

Balance submerged(const Vehicle& vehicle) {
  const Body& body = vehicle.body;
  const double weight = weight_n(vehicle);
  const double buoyancy = body.fluid_density_kg_m3 * gravity_m_s2 * body.displaced_volume_m3;
  Balance balance;
  balance.net_buoyancy_n = buoyancy - weight;
  balance.stability_m = balance.stability_long_m =
      body.centre_of_gravity_m.z - body.centre_of_buoyancy_m.z;
  // Moments about the origin, where the thrusters make good what weight and buoyancy leave.
  const Triple<double> moment =
      weight * body.centre_of_gravity_m - buoyancy * body.centre_of_buoyancy_m;
  const double most_n_m = vehicle.trim.moving_mass_kg * gravity_m_s2 * vehicle.trim.travel_m;
  balance.trim_n_m = moment.x - std::clamp(moment.x, -most_n_m, most_n_m);
  balance.trim_rad = std::atan2(balance.trim_n_m, std::max(moment.z, 0.0));
  balance.heel_rad = std::atan2(moment.y, std::max(moment.z, 0.0));
  return balance;
}

struct Findings {
  std::vector<BalanceFinding> all;
  void error(const char* key, std::string what) { all.push_back({true, key, std::move(what)}); }
  void warning(const char* key, std::string what) { all.push_back({false, key, std::move(what)}); }
};

/// The vertical force that an AUV bears by pitching at a speed, at a share of its steepest pitch.
/// Its autopilot makes up for no more sinking than three tenths of its most speed.
double borne_n(const Vehicle& vehicle, double speed_m_s, double share) {
  const AutopilotSettings& s = vehicle.autopilot;
  const double most_m_s = s.most_speed_m_s > 0 ? s.most_speed_m_s : vehicle.cruise_speed_m_s;
  const double sine = std::min(std::tan(s.most_tilt_rad), 0.9);
  const double down_m_s = std::min(share * sine * speed_m_s, 0.3 * most_m_s);
  return (vehicle.body.linear_damping.linear.z +
          vehicle.body.quadratic_damping.linear.z * down_m_s) *
         down_m_s;
}

/// At which it circles a place that it is to hold, see steer_by_fins.cc.
double holding_speed_m_s(const Vehicle& vehicle) {
  const AutopilotSettings& s = vehicle.autopilot;
  const double most_m_s = s.most_speed_m_s > 0 ? s.most_speed_m_s : vehicle.cruise_speed_m_s;
  return std::max(s.least_speed_m_s, 0.6 * most_m_s);
}

void look_at_buoyancy(const Vehicle& vehicle, const Balance& balance, Findings& findings) {
  const double weight = weight_n(vehicle);
  const double net = balance.net_buoyancy_n;
  const std::string found = formatted(
      "found {:.4g} N of weight and {:.4g} N of buoyancy, {:.3g} N ({:.1f} %) too {}", weight,
      weight + net, std::abs(net), 100 * std::abs(net) / weight, net > 0 ? "light" : "heavy");
  if (vehicle.kind == VehicleKind::rov) {
    constexpr double usual = 0.05;
    if (std::abs(net) > usual * weight)
      findings.warning("displacement",
                       found +
                           "; ROVs are ballasted to within 5 %, or their thrusters hold them "
                           "all day. Check mass_kg and volume_m3");
    return;
  }
  const double by_bladder_n =
      vehicle.body.fluid_density_kg_m3 * gravity_m_s2 *
      (net > 0 ? -vehicle.trim.least_volume_m3 : vehicle.trim.most_volume_m3);
  const double left = std::max(std::abs(net) - by_bladder_n, 0.0);
  const double slow_m_s = holding_speed_m_s(vehicle);
  const double most = borne_n(vehicle, slow_m_s, 1);
  const double half = borne_n(vehicle, vehicle.cruise_speed_m_s, 0.5);
  const std::string bears = formatted(
      "its buoyancy engine takes {:.3g} N of it and its hull bears {:.3g} N at its steepest pitch "
      "of "
      "{:.0f} degrees and the {:.3g} m/s at which it circles a place",
      by_bladder_n, most, vehicle.autopilot.most_tilt_rad / degree, slow_m_s);
  if (left > most)
    findings.error("displacement", found + "; " + bears +
                                       ", so that it could not keep its depth. Check mass_kg and "
                                       "volume_m3");
  else if (left > half)
    findings.warning("displacement",
                     found + "; " + bears + ": it goes with its bow well up or down");
}

void look_at_submerged(const Vehicle& vehicle, const Balance& balance, Findings& findings) {
  const Body& body = vehicle.body;
  const double bg_m = balance.stability_m;
  if (!(body.displaced_volume_m3 > 0)) {
    findings.error("kind",
                   "found no displacement; what swims gives its volume_m3 and its "
                   "centre_of_buoyancy_m");
    return;
  }
  if (!(bg_m > 0)) {
    findings.error(
        "displacement",
        formatted(
            "found the centre of gravity {:.4g} m {} that of buoyancy (z {:.4g} and {:.4g} m, "
            "down): it turns over; expected it below. Check the signs of "
            "centre_of_gravity_m and centre_of_buoyancy_m",
            -bg_m, bg_m == 0 ? "from" : "above", body.centre_of_gravity_m.z,
            body.centre_of_buoyancy_m.z));
    return;
  }
  if (bg_m < 0.01 * body.height_m)
    findings.warning("displacement",
                     formatted("the centre of gravity lies {:.2g} m below that of buoyancy, less "
                               "than 1 % of the height of {:.3g} m: it is hardly stable",
                               bg_m, body.height_m));
  look_at_buoyancy(vehicle, balance, findings);
  const double heel_deg = std::abs(balance.heel_rad) / degree;
  const double trim_deg = std::abs(balance.trim_rad) / degree;
  const std::string lies = formatted(
      "found it to lie at {:.1f} degrees of heel and {:.1f} of trim at rest (centre of "
      "gravity [{:.4g}, {:.4g}, {:.4g}] m, of buoyancy [{:.4g}, {:.4g}, {:.4g}] m)",
      heel_deg, trim_deg, body.centre_of_gravity_m.x, body.centre_of_gravity_m.y,
      body.centre_of_gravity_m.z, body.centre_of_buoyancy_m.x, body.centre_of_buoyancy_m.y,
      body.centre_of_buoyancy_m.z);
  const Fins& fins = vehicle.fins;
  const double speed = vehicle.cruise_speed_m_s;
  const double by_fins_n_m = 0.5 * body.fluid_density_kg_m3 * fins.area_m2 *
                             fins.lift_slope_per_rad * std::abs(fins.position_x_m) *
                             std::min(fins.stall_rad, fins.limit_rad) * speed * speed;
  constexpr double most_deg = 30, usual_deg = 5;
  if (heel_deg > most_deg || trim_deg > most_deg)
    findings.error("displacement",
                   lies + formatted("; expected at most {:g}. Bring the two centres "
                                    "above each other",
                                    most_deg));
  else if (vehicle.kind == VehicleKind::auv && std::abs(balance.trim_n_m) > by_fins_n_m)
    findings.error(
        "displacement",
        lies + formatted("; that is {:.3g} N m beyond its moving mass, and its fins give "
                         "{:.3g} N m at {:.3g} m/s. Bring the two centres above each "
                         "other",
                         std::abs(balance.trim_n_m), by_fins_n_m, speed));
  else if (heel_deg > usual_deg || trim_deg > usual_deg)
    findings.warning("displacement", lies);
}

void look_at_floating(const Vehicle& vehicle, const Balance& balance, Findings& findings) {
  const Body& body = vehicle.body;
  const FloatingHull& hull = body.hull;
  const std::string found = formatted(
      "found a metacentric height of {:.3g} m across and {:.3g} m along, at a draught of "
      "{:.3g} m with the centre of gravity {:.3g} m above the keel",
      balance.stability_m, balance.stability_long_m, balance.draught_m,
      hull.keel_m[0].z - body.centre_of_gravity_m.z);
  if (!(balance.stability_m > 0) || !(balance.stability_long_m > 0)) {
    findings.error("hulls", found +
                                ": it capsizes at rest; expected more than 0. Check "
                                "centre_of_gravity_m, keel_z_m, centre_y_m and the beam");
    return;
  }
  const double heel_deg = std::abs(balance.heel_rad) / degree;
  const double trim_deg = std::abs(balance.trim_rad) / degree;
  const std::string lies = formatted(
      "found it to lie at {:.1f} degrees of heel and {:.1f} of trim at rest, its deck {:.3g} m "
      "above the water at the lowest corner: its weight is {:.3f} m aside and {:.3f} m forward of "
      "the middle of its hulls",
      heel_deg, trim_deg, balance.least_freeboard_m, body.centre_of_gravity_m.y - hull.middle_m.y,
      body.centre_of_gravity_m.x - hull.middle_m.x);
  constexpr double most_deg = 10, usual_deg = 3;
  if (heel_deg > most_deg || trim_deg > most_deg || !(balance.least_freeboard_m > 0))
    findings.error("hulls",
                   lies + formatted("; expected at most {:g} degrees and a dry deck. Check "
                                    "centre_of_gravity_m and the places of the hulls",
                                    most_deg));
  else if (heel_deg > usual_deg || trim_deg > usual_deg)
    findings.warning("hulls", lies);
  double outward_m = 0;
  for (std::size_t i = 0; i < hull.strips; ++i)
    outward_m = std::max(outward_m, std::abs(hull.keel_m[i].y - hull.middle_m.y));
  const double beam_m = 2 * outward_m + section_at(hull, balance.draught_m).breadth_m;
  const double usual_m = vehicle.kind == VehicleKind::vessel ? 0.15 : 0.05 * beam_m;
  if (balance.stability_m < usual_m)
    findings.warning(
        "hulls",
        found + formatted("; expected at least {:.2g} m: its stability is too small", usual_m));
}

}  // namespace

Balance balance_of(const Vehicle& vehicle) {
  if (vehicle.kind == VehicleKind::uav) return {};
  return vehicle.body.hull.strips > 0 ? afloat(vehicle) : submerged(vehicle);
}

std::vector<BalanceFinding> findings_on(const Vehicle& vehicle, const Balance& balance) {
  Findings findings;
  if (vehicle.kind == VehicleKind::uav) return {};
  if (vehicle.body.hull.strips > 0)
    look_at_floating(vehicle, balance, findings);
  else
    look_at_submerged(vehicle, balance, findings);
  return std::move(findings.all);
}

void expect_strength(const Vehicle& vehicle, const Autopilot& autopilot) {
  if (vehicle.kind == VehicleKind::rov) {
    const double net = balance_of(vehicle).net_buoyancy_n;
    const double most =
        net > 0 ? autopilot.allocation.most_ahead[2] : autopilot.allocation.most_astern[2];
    constexpr double usable = 0.8;
    if (std::abs(net) > usable * most)
      throw Error(
          ErrorKind::invalid_input,
          formatted("displacement: found {:.3g} N too {}, and its thrusters push {:.3g} N {}; "
                    "expected at most 80 % of that, that some is left to steer by. Check "
                    "mass_kg and volume_m3",
                    std::abs(net), net > 0 ? "light" : "heavy", most, net > 0 ? "down" : "up"));
  }
  if (vehicle.kind == VehicleKind::uav) {
    const Triple<double>& at = vehicle.body.centre_of_gravity_m;
    const double weight = autopilot.weight_n;
    const Thrusts hover =
        allocate(autopilot.allocation, {{0, 0, -weight}, {-weight * at.y, weight * at.x, 0}});
    const double share = std::min(hover.share[3], hover.share[4]);
    if (share < 1 - 1e-6)
      throw Error(
          ErrorKind::invalid_input,
          formatted("rigid_body: found the centre of gravity {:.3g} m forward and {:.3g} m to "
                    "starboard; the rotors hold {:.0f} % of the moment of its weight, so "
                    "that it turns over. Check centre_of_gravity_m and mounts",
                    at.x, at.y, 100 * share));
  }
}

}  // namespace slackwater::twin
