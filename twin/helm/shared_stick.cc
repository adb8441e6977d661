#include "twin/helm/shared_stick.h"

#include <algorithm>
#include <cmath>

#include "twin/body/attitude.h"

namespace slackwater::twin {
namespace {

constexpr double approach_per_s = 0.5;
constexpr double most_out_m_s = 0.3;  ///< of what is across already
constexpr int rounds = 4;

/// A distance to keep, and the way out of it.
struct Barrier {
  double left_m = 0;
  Triple<double> away;  ///< unit
};

/// The way in which the distance to a structure grows, by differences.
Triple<double> away_from(const Structure& structure, const Triple<double>& at_m) {
  constexpr double by_m = 1e-3;
  const auto along = [&](const Triple<double>& step) {
    return signed_distance_m(structure, at_m + step) - signed_distance_m(structure, at_m - step);
  };
  const Triple<double> slope{along({by_m, 0, 0}), along({0, by_m, 0}), along({0, 0, by_m})};
  const double steep = length_of(slope);
  return steep > 0 ? (1 / steep) * slope : Triple<double>{};
}

/// Leads the velocity over ground out of what a barrier forbids. @return whether it did
bool keep(const Barrier& barrier, Triple<double>& over_ground) {
  const double asked_m_s = std::min(-approach_per_s * barrier.left_m, most_out_m_s);
  const double short_m_s = asked_m_s - dot(barrier.away, over_ground);
  if (!(short_m_s > 1e-9)) return false;
  over_ground = over_ground + short_m_s * barrier.away;
  return true;
}

void slow_down(double most_m_s, Triple<double>& through_water, bool& is_slowed) {
  const double speed_m_s = length_of(through_water);
  if (!(most_m_s > 0) || speed_m_s <= most_m_s) return;
  through_water = (most_m_s / speed_m_s) * through_water;
  is_slowed = true;
}

}  // namespace

SharedStick shared_stick(const HelmVelocity& asked, const Measured& known,
                         const StickLimits& limits) {
  SharedStick shared{asked};
  const Envelope& envelope = limits.envelope;
  const double yaw_rad = euler_angles(known.attitude).yaw_rad;
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  Triple<double> own{c * asked.surge_m_s - s * asked.sway_m_s,
                     s * asked.surge_m_s + c * asked.sway_m_s, asked.heave_m_s};
  slow_down(envelope.most_speed_m_s, own, shared.is_slowed);
  Triple<double> over_ground = own + known.water_m_s;
  for (int round = 0; round < rounds; ++round) {
    for (const Structure& structure : limits.structures) {
      if (!(envelope.stand_off_m > 0)) break;
      const double left_m = signed_distance_m(structure, known.position_m) - envelope.stand_off_m;
      if (keep({left_m, away_from(structure, known.position_m)}, over_ground))
        shared.is_kept_off = true;
    }
    if (!envelope.fence_m) continue;
    const double north = known.position_m.x - limits.home_m.x;
    const double east = known.position_m.y - limits.home_m.y;
    const double out_m = std::hypot(north, east);
    if (out_m > 0 &&
        keep({*envelope.fence_m - out_m, {-north / out_m, -east / out_m, 0}}, over_ground))
      shared.is_kept_in = true;
  }
  if (!shared.is_slowed && !shared.is_kept_off && !shared.is_kept_in) return shared;
  own = over_ground - known.water_m_s;
  shared.velocity.surge_m_s = c * own.x + s * own.y;
  shared.velocity.sway_m_s = -s * own.x + c * own.y;
  shared.velocity.heave_m_s = own.z;
  return shared;
}

}  // namespace slackwater::twin
