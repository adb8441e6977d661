#pragma once
#include <optional>
#include <span>

#include "twin/control/reference.h"
#include "twin/mission/conduct.h"
#include "twin/scene/structure.h"
#include "twin/state/helm_state.h"

namespace slackwater::twin {

/// What a vehicle's own conduct has to say to a stick.
struct StickLimits {
  Envelope envelope;
  Triple<double> home_m;  ///< NED, of the fence
  std::span<const Structure> structures;
};

/// What a person's stick becomes where it is shared with the vehicle, and what shaped it.
struct SharedStick {
  HelmVelocity velocity;
  bool is_slowed = false;    ///< to the conduct's largest speed
  bool is_kept_off = false;  ///< structures, by its stand-off
  bool is_kept_in = false;   ///< its fence
};

/// The velocity nearest to what is asked that keeps the vehicle off structures and in its fence.
///
/// A distance d to keep is a barrier: its rate is at least -k d, so that the vehicle comes near as
/// exp(-k t) and never across, and is led out, at 0.3 m/s at most, where it is across already. For
/// one barrier with the unit normal n away from it, in a current c, what is asked (u) becomes
///
///     u + max(0, -k d - n.(u + c)) n
///
/// the closest there is (Ames et al. 2019, control barrier functions, eq. for one constraint); of
/// several the one that binds most is met first, four rounds. k = 0.5/s: what the vehicle still
/// does with the last command, `HelmRule::renewal_s`, is within it. A craft that cannot go sideways
/// does not follow that part.
/// @param known  position, heading and current as the vehicle takes them to be
[[nodiscard]] SharedStick shared_stick(const HelmVelocity& asked, const Measured& known,
                                       const StickLimits& limits);

}  // namespace slackwater::twin
