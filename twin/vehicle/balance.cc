#include "twin/vehicle/balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/vehicle/level_flight.h"

namespace slackwater::twin {
namespace {

using constants::gravity_m_s2;

using constants::degree;

double weight_n(const Vehicle& vehicle) { return vehicle.body.mass_kg * gravity_m_s2; }

/// What the strips of a craft that floats level add up to.
struct AfloatSums {
  double volume_m3 = 0;
  Triple<double> volume_at_m;  ///< sum of volume times place of its centre
  double area_m2 = 0;          ///< of the waterline
  double area_x_m3 = 0, area_y_m3 = 0;
  double along_m4 = 0, across_m4 = 0;  ///< second moments of the waterline about the origin
};

AfloatSums afloat_sums(const FloatingHull& hull, double down_m) {
  AfloatSums sum;
  for (std::size_t p = 0; p < hull.parts; ++p) {
    const HullPart& part = hull.part[p];
    const double length_m = part.strip_length_m;
    for (std::size_t i = part.first; i < part.first + part.strips; ++i) {
      const Triple<double>& keel = hull.keel_m[i];
      if (down_m + keel.z <= 0) continue;
      const Section section = section_at(part, down_m + keel.z);
      const double volume = length_m * section.area_m2;
      const double area = length_m * section.breadth_m;
      sum.volume_m3 += volume;
      sum.volume_at_m.x += volume * keel.x;
      sum.volume_at_m.y += volume * keel.y;
      sum.volume_at_m.z += volume * keel.z - length_m * section.moment_m3;
      sum.area_m2 += area;
      sum.area_x_m3 += area * keel.x;
      sum.area_y_m3 += area * keel.y;
      sum.along_m4 += area * (keel.x * keel.x + length_m * length_m / 12);
      sum.across_m4 += area * keel.y * keel.y + length_m * section.second_moment_m3;
    }
  }
  return sum;
}

Balance afloat(const Vehicle& vehicle) {
  const Body& body = vehicle.body;
  const FloatingHull& hull = body.hull;
  const double down_m = floating_depth_m(hull, body.mass_kg, body.fluid_density_kg_m3);
  const AfloatSums sum = afloat_sums(hull, down_m);
  const Triple<double> buoyancy_m = (1 / sum.volume_m3) * sum.volume_at_m;
  // About the centre of the waterline, where a craft turns that keeps its displacement.
  const double middle_x_m = sum.area_x_m3 / sum.area_m2;
  const double middle_y_m = sum.area_y_m3 / sum.area_m2;
  const double along_m4 = sum.along_m4 - middle_x_m * sum.area_x_m3;
  const double across_m4 = sum.across_m4 - middle_y_m * sum.area_y_m3;
  Balance balance;
  const double below_gravity_m = body.centre_of_gravity_m.z - buoyancy_m.z;
  balance.stability_m = below_gravity_m + across_m4 / sum.volume_m3;
  balance.stability_long_m = below_gravity_m + along_m4 / sum.volume_m3;
  const double aside_m = body.centre_of_gravity_m.y - buoyancy_m.y;
  const double ahead_m = body.centre_of_gravity_m.x - buoyancy_m.x;
  if (balance.stability_m > 0) balance.heel_rad = std::atan(aside_m / balance.stability_m);
  if (balance.stability_long_m > 0)
    balance.trim_rad = std::atan(ahead_m / balance.stability_long_m);
  balance.aside_m = aside_m;
  balance.ahead_m = ahead_m;
  double forward_m = 0, outward_m = 0;
  double level_m = std::numeric_limits<double>::infinity();  // freeboard
  for (std::size_t p = 0; p < hull.parts; ++p) {
    const HullPart& part = hull.part[p];
    for (std::size_t i = part.first; i < part.first + part.strips; ++i) {
      const Triple<double>& keel = hull.keel_m[i];
      balance.draught_m = std::max(balance.draught_m, keel.z + down_m);
      balance.keel_m = std::max(balance.keel_m, keel.z);
      level_m = std::min(level_m, part.section_depth_m - (keel.z + down_m));
      forward_m = std::max(forward_m, std::abs(keel.x - middle_x_m) + 0.5 * part.strip_length_m);
      outward_m = std::max(outward_m, std::abs(keel.y - middle_y_m));
      const double half_m = 0.5 * section_at(part, std::max(keel.z + down_m, 0.0)).breadth_m;
      balance.beam_m = std::max(balance.beam_m, 2 * (std::abs(keel.y - middle_y_m) + half_m));
    }
  }
  balance.least_freeboard_m = level_m - std::abs(std::tan(balance.trim_rad)) * forward_m -
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
  std::vector<VehicleFinding> all;
  void error(const char* key, std::string what) { all.push_back({true, key, std::move(what)}); }
  void warning(const char* key, std::string what) { all.push_back({false, key, std::move(what)}); }
};

/// At which it circles a place that it is to hold, see steer_by_fins.cc.
double holding_speed_m_s(const Vehicle& vehicle) {
  const AutopilotSettings& s = vehicle.autopilot;
  const double most_m_s = s.most_speed_m_s > 0 ? s.most_speed_m_s : vehicle.cruise_speed_m_s;
  return std::max(s.least_speed_m_s, 0.6 * most_m_s);
}

/// The next tenth of a metre a second, up to its most, at which its elevator holds it level.
std::optional<double> held_from_m_s(const Vehicle& vehicle, double speed_m_s, double net_n) {
  const AutopilotSettings& s = vehicle.autopilot;
  const double most_m_s = std::max(s.most_speed_m_s, vehicle.cruise_speed_m_s);
  for (double at_m_s = 0.1 * std::ceil(10 * speed_m_s); at_m_s <= most_m_s; at_m_s += 0.1) {
    const LevelFlight level = level_flight(vehicle, at_m_s, net_n);
    if (level.is_held && std::abs(level.borne_n) >= 0.999 * std::abs(net_n)) return at_m_s;
  }
  return std::nullopt;
}

/// At its cruise speed, and at the least at which its file says that its fins steer it; nobody says
/// so of the default.
void look_at_level_flight(const Vehicle& vehicle, const std::string& found, double net_n,
                          Findings& findings) {
  constexpr const char* least_key = "autopilot.least_speed_m_s";
  std::vector<double> speeds{vehicle.cruise_speed_m_s};
  if (vehicle.places.line.contains(least_key)) speeds.push_back(vehicle.autopilot.least_speed_m_s);
  for (const double speed_m_s : speeds) {
    const LevelFlight level = level_flight(vehicle, speed_m_s, net_n);
    const double limit_rad = vehicle.elevator.limit_rad;
    const double asked_rad = std::abs(level.elevator_rad);
    const bool is_borne = std::abs(level.borne_n) >= 0.999 * std::abs(net_n);
    const std::string takes = formatted(
        "{}; at {:.3g} m/s {}", found, speed_m_s,
        is_borne ? formatted("level flight takes {:.1f} of {:.1f} degrees of elevator",
                             asked_rad / degree, limit_rad / degree)
                 : formatted("hull and fins bear {:.3g} N at most", std::abs(level.borne_n)));
    if (!is_borne || !level.is_held) {
      const auto enough_m_s = held_from_m_s(vehicle, speed_m_s, net_n);
      findings.error(
          "displacement",
          takes + ", so that it could not keep its depth. Trim it (mass_kg, volume_m3)" +
              (enough_m_s ? formatted(", or raise {} to {:.3g}",
                                      speed_m_s == vehicle.cruise_speed_m_s ? "cruise_speed_m_s"
                                                                            : least_key,
                                      *enough_m_s)
                          : std::string()));
      return;
    }
    constexpr double usable = 0.8;
    if (asked_rad > usable * limit_rad) {
      findings.warning("displacement", takes + ": little is left to steer by");
      return;
    }
  }
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
  const LevelFlight most = strongest_level_flight(vehicle, slow_m_s, net);
  const double cruise_m_s = vehicle.cruise_speed_m_s;
  const double steepest_rad = strongest_level_flight(vehicle, cruise_m_s, net).pitch_rad;
  const double half = std::abs(
      level_flight_at(vehicle, cruise_m_s, 0.5 * std::tan(steepest_rad) * cruise_m_s).borne_n);
  const std::string bears = formatted(
      "its buoyancy engine takes {:.3g} N of it and its hull bears {:.3g} N at the steepest pitch "
      "that it has or its elevator holds, {:.0f} degrees, and the {:.3g} m/s at which it circles a "
      "place",
      by_bladder_n, std::abs(most.borne_n), std::abs(most.pitch_rad) / degree, slow_m_s);
  if (left > std::abs(most.borne_n)) {
    findings.error("displacement", found + "; " + bears +
                                       ", so that it could not keep its depth. Check mass_kg and "
                                       "volume_m3");
    return;
  }
  if (left > half)
    findings.warning("displacement",
                     found + "; " + bears + ": it goes with its bow well up or down");
  look_at_level_flight(vehicle, found, std::copysign(left, net), findings);
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
  const double heel_deg = std::abs(balance.heel_rad) / degree;
  const double trim_deg = std::abs(balance.trim_rad) / degree;
  const std::string lies = formatted(
      "found it to lie at {:.1f} degrees of heel and {:.1f} of trim at rest (centre of "
      "gravity [{:.4g}, {:.4g}, {:.4g}] m, of buoyancy [{:.4g}, {:.4g}, {:.4g}] m)",
      heel_deg, trim_deg, body.centre_of_gravity_m.x, body.centre_of_gravity_m.y,
      body.centre_of_gravity_m.z, body.centre_of_buoyancy_m.x, body.centre_of_buoyancy_m.y,
      body.centre_of_buoyancy_m.z);
  const FinPair& fins = vehicle.elevator;
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
  look_at_buoyancy(vehicle, balance, findings);
}

void look_at_floating(const Vehicle& vehicle, const Balance& balance, Findings& findings) {
  const Body& body = vehicle.body;
  const std::string found = formatted(
      "found a metacentric height of {:.3g} m across and {:.3g} m along, at a draught of "
      "{:.3g} m with the centre of gravity {:.3g} m above the keel",
      balance.stability_m, balance.stability_long_m, balance.draught_m,
      balance.keel_m - body.centre_of_gravity_m.z);
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
      "the centre of its buoyancy",
      heel_deg, trim_deg, balance.least_freeboard_m, balance.aside_m, balance.ahead_m);
  constexpr double most_deg = 10, usual_deg = 3;
  if (heel_deg > most_deg || trim_deg > most_deg || !(balance.least_freeboard_m > 0))
    findings.error("hulls",
                   lies + formatted("; expected at most {:g} degrees and a dry deck. Check "
                                    "centre_of_gravity_m and the places of the hulls",
                                    most_deg));
  else if (heel_deg > usual_deg || trim_deg > usual_deg)
    findings.warning("hulls", lies);
  const double usual_m = vehicle.kind == VehicleKind::vessel ? 0.15 : 0.05 * balance.beam_m;
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

std::vector<VehicleFinding> findings_on(const Vehicle& vehicle, const Balance& balance) {
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
