#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/ask/traffic/heard_vessels.h"
#include "api/ask/traffic/traffic_rule.h"
#include "fields/site/farm.h"

namespace slackwater::api {

/// A log that is listened to.
struct TrafficSource {
  std::string file;     ///< its name, without its folder
  std::string trouble;  ///< a sentence; empty: it is read
};

/// "What ships are about this site at time T?"
struct TrafficQuestion {
  std::string site;  ///< its id
  GeoPoint place;
  std::vector<TurbinePlace> turbines;
  UtcTime at{};
  TrafficRule rule;
};

/// What was known by then.
struct TrafficHeard {
  std::vector<LastHeard> vessels;
  std::optional<UtcTime> last;   ///< receipt of anything by then
  std::optional<UtcTime> first;  ///< of all that the logs hold
  std::vector<TrafficSource> sources;
};

enum class Passing {
  closing,  ///< the closest approach is to come
  past,     ///< it was before, and the vessel goes away
  still,    ///< the vessel lies still: the distance stays
};

/// The closest approach of a vessel on a straight line at constant speed to a place that stays.
struct Approach {
  std::string to;  ///< "" the site itself, else a turbine
  Passing passing = Passing::still;
  double distance_m = 0;  ///< CPA
  double time_s = 0;      ///< TCPA from the time asked about; negative: so long ago
};

/// Why a vessel is marked.
enum class TrafficAlarm {
  none,
  closing,  ///< it passes nearer and sooner than the limits
  inside,   ///< it lies still, nearer than the limit
};

struct VesselThere {
  LastHeard heard;
  Duration age{};         ///< of its last report
  bool is_fresh = false;  ///< by the rule
  /// Where it is by dead reckoning from the last report; of one that is not fresh, or does not say
  /// how it moves, where it last was.
  GeoPoint place;
  bool is_carried_on = false;     ///< `place` is not the reported one
  double distance_m = 0;          ///< from the site
  double bearing_deg = 0;         ///< as the site sees it, clockwise from true north
  std::optional<GeoPoint> ahead;  ///< where it will be after `rule.way`; of one that moves
  // Of a fresh one that says how it moves.
  std::optional<Approach> to_site;
  std::optional<Approach> to_turbine;       ///< to the one that matters most: see `traffic_about`
  std::optional<Approach> told;             ///< of the two the one that matters more
  TrafficAlarm alarm = TrafficAlarm::none;  ///< for the approach that is told
};

struct TrafficAnswer {
  std::vector<VesselThere> vessels;  ///< marked ones first, then the nearest
  std::size_t too_old = 0;           ///< silent for longer than is shown
  std::size_t left_out = 0;          ///< beyond the most that are told
};

/// Positions are laid into the plane at the site (`LocalFrame`): 0.5 m short at 50 km. Of several
/// approaches the one matters most that is within the limits, of these the first; else of those to
/// come the nearest; else that to the place that is nearest now.
///
/// Nothing that was received after `at` may be in `heard`.
[[nodiscard]] TrafficAnswer traffic_about(const TrafficQuestion& question,
                                          const TrafficHeard& heard);

}  // namespace slackwater::api
