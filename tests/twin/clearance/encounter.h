#pragma once
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fields/base/numbers/random.h"
#include "twin/clearance/clear_way.h"

namespace slackwater::tests {

/// A point mass over ground in a current that veers: its velocity follows what it is told behind a
/// lag, its acceleration behind another, and both are bounded. It feels the change of the current
/// until it has made it good.
struct PointMass {
  twin::Handling handling;
  twin::OwnMotion motion;
  twin::Planar acceleration_m_s2;
  twin::Planar goal_m;
  double lag_s = 0.3;
  double actuator_lag_s = 0.1;
  twin::ClearanceState clearance;
  double arrived_s = -1;
  double least_slack_m = std::numeric_limits<double>::infinity();

  void step(const twin::Planar& wanted_m_s, const twin::Planar& current_change_m_s2, double dt_s) {
    twin::Planar push = (1 / lag_s) * (wanted_m_s - motion.velocity_m_s);
    const double most = handling.acceleration_m_s2, size = twin::size_of(push);
    if (size > most) push = (most / size) * push;
    acceleration_m_s2 =
        acceleration_m_s2 + (1 - std::exp(-dt_s / actuator_lag_s)) * (push - acceleration_m_s2);
    const twin::Planar change = dt_s * (acceleration_m_s2 + current_change_m_s2);
    motion.position_m = motion.position_m + dt_s * (motion.velocity_m_s + 0.5 * change);
    motion.velocity_m_s = motion.velocity_m_s + change;
  }
  /// Straight to its goal, and no faster there than it can stop.
  [[nodiscard]] twin::Planar wish_m_s() const {
    const twin::Planar way = goal_m - motion.position_m;
    const double away = twin::size_of(way);
    const double speed = std::min(handling.most_speed_m_s,
                                  std::min(std::sqrt(handling.deceleration_m_s2 * away), away));
    return away > 0 ? (speed / away) * way : twin::Planar{};
  }
};

enum class Meeting { head_on, crossing, overtaking, structures, line, traffic, all_of_it };
inline constexpr int meetings = 7;

/// Vehicles that would run into each other and into what is around.
struct Encounter {
  Meeting kind = Meeting::head_on;
  twin::StandOff stand_off;
  std::vector<PointMass> vehicles;
  std::vector<twin::Structure> structures;
  std::vector<std::array<twin::Triple<double>, twin::tether_nodes>> lines;
  std::vector<twin::Passer> passers;
  double barrier_s = 0.1;
  double current_m_s = 0;
  double current_turns_s = 600;
  double current_from_rad = 0;
  double straight_s = 0;  ///< the longest that one would need alone
};

inline twin::Planar towards(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

inline PointMass random_vehicle(Rng& rng, double barrier_s) {
  PointMass v;
  twin::Handling& h = v.handling;
  h.most_speed_m_s = rng.uniform(0.5, 3);
  h.acceleration_m_s2 = rng.uniform(0.2, 0.8);
  h.deceleration_m_s2 = 0.5 * h.acceleration_m_s2;
  v.lag_s = rng.uniform(0.2, 0.5);
  v.actuator_lag_s = rng.uniform(0.05, 0.2);
  h.reaction_s = 4 * (v.lag_s + v.actuator_lag_s) + barrier_s;
  h.sure_speed_m_s = 0.5 * h.most_speed_m_s;
  h.vertical_deceleration_m_s2 = 0.2;
  h.radius_m = rng.uniform(0.3, 1.5);
  h.above_m = h.below_m = 0.3;
  return v;
}

/// What an encounter has from around, as the vehicles are told of it.
struct Around {
  std::vector<twin::Craft> craft;
  std::vector<twin::Line> lines;
  twin::Lookout of(const Encounter& e) {
    craft.clear();
    for (const PointMass& v : e.vehicles)
      craft.push_back(twin::craft_of(v.handling, v.motion, v.clearance));
    lines.clear();
    for (const auto& nodes : e.lines) lines.push_back({nodes, 1000, true});
    return {craft, 0, e.structures, lines, e.passers};
  }
};

/// The least distance between hulls less the stand-off, at the same depth: of all pairs, and from
/// each thing around.
inline double least_slack_m(const Encounter& e) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < e.vehicles.size(); ++i) {
    const PointMass& v = e.vehicles[i];
    const twin::Planar at = v.motion.position_m;
    for (std::size_t j = 0; j < i; ++j) {
      const PointMass& o = e.vehicles[j];
      least = std::min(least, twin::size_of(at - o.motion.position_m) - v.handling.radius_m -
                                  o.handling.radius_m - e.stand_off.craft_m);
    }
    for (const twin::Structure& s : e.structures)
      least = std::min(least, twin::signed_distance_m(s, {at.north, at.east, v.motion.depth_m}) -
                                  v.handling.radius_m - e.stand_off.structure_m);
    for (const auto& nodes : e.lines)
      for (std::size_t k = 1; k < nodes.size(); ++k) {
        const twin::Triple<double>&a = nodes[k - 1], &b = nodes[k];
        const double aside_m =
            twin::size_of(at - twin::nearest_on({twin::planar(a), twin::planar(b)}, at)) -
            v.handling.radius_m - e.stand_off.tether_m;
        const double in_depth_m =
            std::max(std::min(a.z, b.z) - v.motion.depth_m - v.handling.below_m,
                     v.motion.depth_m - v.handling.above_m - std::max(a.z, b.z)) -
            e.stand_off.vertical_m;
        least = std::min(least, std::max(aside_m, in_depth_m));
      }
    for (const twin::Passer& p : e.passers) {
      const twin::Planar ahead = twin::unit_of(p.velocity_m_s, {1, 0});
      const twin::Stretch hull{p.position_m - p.half_length_m * ahead,
                               p.position_m + p.half_length_m * ahead};
      least = std::min(least, twin::size_of(at - twin::nearest_on(hull, at)) - p.half_beam_m -
                                  v.handling.radius_m - e.stand_off.vessel_m);
    }
  }
  return least;
}

inline Encounter random_encounter(std::uint64_t seed, int number) {
  Rng rng(seed, "encounter/" + std::to_string(number));
  Encounter e;
  e.kind = static_cast<Meeting>(number % meetings);
  e.barrier_s = 0.1 * std::floor(rng.uniform(1, 4));
  e.stand_off = {rng.uniform(0.5, 4), rng.uniform(0.5, 4), rng.uniform(0.5, 3), rng.uniform(3, 20),
                 1.0};
  const double size_m = rng.uniform(25, 60);
  e.current_m_s = rng.uniform(0, 0.2);
  e.current_turns_s = rng.uniform(200, 1200);
  e.current_from_rad = rng.uniform(0, 6.28);
  const double from_rad = rng.uniform(0, 6.28);
  const auto aside = [&] { return rng.uniform() < 0.3 ? 0.0 : rng.uniform(-3, 3); };
  const auto put = [&](double bearing_rad, double start_m, double goal_m) {
    PointMass v = random_vehicle(rng, e.barrier_s);
    const twin::Planar way = towards(bearing_rad), right = twin::to_the_right(way);
    v.motion.position_m = -start_m * way + aside() * right;
    v.goal_m = goal_m * way + aside() * right;
    e.vehicles.push_back(v);
  };
  const double pi = 3.14159265358979;
  switch (e.kind) {
    case Meeting::head_on:
      put(from_rad, size_m, size_m);
      put(from_rad + pi, size_m, size_m);
      break;
    case Meeting::crossing: {
      const int all = 2 + static_cast<int>(rng.uniform(0, 3));
      for (int i = 0; i < all; ++i) put(from_rad + i * 2 * pi / all * 0.7, size_m, size_m);
      break;
    }
    case Meeting::overtaking:
      put(from_rad, 0.5 * size_m, 2 * size_m);
      put(from_rad, size_m, 3 * size_m);
      e.vehicles[0].handling.most_speed_m_s *= 0.4;
      e.vehicles[0].handling.sure_speed_m_s *= 0.4;
      if (rng.uniform() < 0.5) std::swap(e.vehicles[0], e.vehicles[1]);
      break;
    case Meeting::structures:
    case Meeting::line:
    case Meeting::traffic:
      put(from_rad, size_m, size_m);
      put(from_rad + rng.uniform(0.5, 5.5), size_m, size_m);
      break;
    case Meeting::all_of_it: {
      const int all = 3 + static_cast<int>(rng.uniform(0, 2));
      for (int i = 0; i < all; ++i) put(from_rad + i * 2 * pi / all, size_m, size_m);
      break;
    }
  }
  const bool all = e.kind == Meeting::all_of_it;
  if (all || e.kind == Meeting::structures) {
    const twin::Planar at = rng.uniform(0, 4) * towards(rng.uniform(0, 6.28));
    if (rng.uniform() < 0.5)
      e.structures.push_back(twin::Cylinder{at.north, at.east, rng.uniform(1, 5), -20, 60});
    else
      e.structures.push_back(twin::box_of({at.north, at.east, 20},
                                          {rng.uniform(1, 6), rng.uniform(1, 6), 40},
                                          rng.uniform(0, 6.28)));
  }
  if (all || e.kind == Meeting::line) {
    // Down, and aside with a bow.
    const twin::Planar top = rng.uniform(-6, 6) * towards(rng.uniform(0, 6.28)) +
                             (all ? 14.0 : 0.0) * towards(rng.uniform(0, 6.28));
    const twin::Planar along = rng.uniform(0, 12) * towards(rng.uniform(0, 6.28));
    std::array<twin::Triple<double>, twin::tether_nodes> nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double share = static_cast<double>(k) / twin::tether_segments;
      const twin::Planar at =
          top + share * along + share * (1 - share) * 4 * twin::to_the_right(towards(from_rad));
      nodes[k] = {at.north, at.east, -5 + 30 * share};
    }
    e.lines.push_back(nodes);
    // Only what is at its depth is in the way: at theirs.
    for (PointMass& v : e.vehicles) v.motion.depth_m = 10;
  }
  for (PointMass& v : e.vehicles) {
    // What it strays. An acceleration that is left over when it is told otherwise moves it by a
    // times its lags, half as much again where it is told so again and again. A current that
    // changes moves it by the lag times that change faster than it means to, and at the edge of its
    // room it means to go back no faster than in the time that it takes to stop.
    const double change_m_s2 = 6.2832 / e.current_turns_s * e.current_m_s;
    const double lags_s = v.lag_s + v.actuator_lag_s;
    v.handling.stray_m = 1.5 * v.handling.acceleration_m_s2 * v.actuator_lag_s * lags_s +
                         change_m_s2 * lags_s *
                             (1.25 * v.handling.reaction_s + e.barrier_s +
                              v.handling.most_speed_m_s / (2 * v.handling.deceleration_m_s2));
  }
  for (const PointMass& v : e.vehicles)
    e.straight_s = std::max(
        e.straight_s, twin::size_of(v.goal_m - v.motion.position_m) / v.handling.most_speed_m_s);
  if (all || e.kind == Meeting::traffic) {
    const double course_rad = rng.uniform(0, 6.28);
    twin::Passer p;
    p.half_length_m = rng.uniform(5, 60);
    p.half_beam_m = 0.15 * p.half_length_m;
    p.top_m = -30;
    p.bottom_m = 15;
    const double speed = rng.uniform(2, 12);
    p.velocity_m_s = speed * towards(course_rad);
    // Heard of in time: farther than the slowest needs to leave its way, whatever it does.
    double warning_s = rng.uniform(0, 60);
    for (const PointMass& v : e.vehicles)
      warning_s = std::max(
          warning_s, 20 + twin::leaving_time_s(v.handling, p.half_beam_m + v.handling.radius_m +
                                                               e.stand_off.vessel_m));
    p.position_m = -1.0 *
                       (size_m + 20 + p.half_length_m + e.stand_off.vessel_m + speed * warning_s) *
                       towards(course_rad) +
                   rng.uniform(-10, 10) * twin::to_the_right(towards(course_rad));
    e.passers.push_back(p);
  }
  return e;
}

struct Outcome {
  double least_slack_m = std::numeric_limits<double>::infinity();
  double alarms = 0;
  bool all_arrived = false;
  double took_s = 0;
  std::string text;
};

/// Makes the encounter, with the rule or without it.
inline Outcome outcome_of(Encounter e, bool with_rule, double most_s) {
  Outcome out;
  Around around;
  constexpr double pi = 3.14159265358979;
  for (double t_s = 0; t_s < most_s; t_s += e.barrier_s) {
    twin::Lookout lookout = around.of(e);
    const int steps = 2;
    const double dt_s = e.barrier_s / steps;
    bool all = true;
    for (std::size_t i = 0; i < e.vehicles.size(); ++i) {
      PointMass& v = e.vehicles[i];
      lookout.own = i;
      for (int k = 0; k < steps; ++k) {
        twin::Planar wanted = v.wish_m_s();
        if (with_rule) {
          const twin::ClearWay way = twin::clear_way(v.handling, e.stand_off, lookout, v.motion,
                                                     {wanted, 0}, dt_s, v.clearance);
          if (!way.is_as_wished_aside) wanted = way.velocity_m_s;
        }
        const double rate = 2 * pi / e.current_turns_s;
        const double angle = e.current_from_rad + rate * (t_s + k * dt_s);
        v.step(wanted, rate * e.current_m_s * twin::to_the_right(towards(angle)), dt_s);
      }
      if (v.arrived_s < 0 && twin::size_of(v.goal_m - v.motion.position_m) < 1) v.arrived_s = t_s;
      all = all && v.arrived_s >= 0;
    }
    for (twin::Passer& p : e.passers) p.position_m = p.position_m + e.barrier_s * p.velocity_m_s;
    out.least_slack_m = std::min(out.least_slack_m, least_slack_m(e));
    out.took_s = t_s;
    if (all) {
      out.all_arrived = true;
      break;
    }
  }
  for (const PointMass& v : e.vehicles) out.alarms += v.clearance.alarms;
  return out;
}

}  // namespace slackwater::tests
