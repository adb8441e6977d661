#include "api/ask/traffic/traffic_about.h"

#include <algorithm>
#include <cmath>

#include "api/ask/run/ais_traffic.h"
#include "twin/body/frame.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_vessels = 500;

/// A place that stays, on the site's plane.
struct Fixed {
  std::string id;
  twin::MovingPoint point;
};

Approach approach_of(const twin::MovingPoint& vessel, const Fixed& place) {
  const twin::ClosestApproach closest = twin::closest_of_all_times(place.point, vessel);
  Approach approach{place.id, Passing::past, closest.distance_m, closest.time_s};
  const auto& v = vessel.velocity_m_s;
  if (v.x == 0 && v.y == 0) approach.passing = Passing::still;
  if (closest.is_closing) approach.passing = Passing::closing;
  return approach;
}

TrafficAlarm alarm_of(const Approach& approach, const twin::AlarmLimits& limits) {
  if (!(approach.distance_m < limits.distance_m)) return TrafficAlarm::none;
  if (approach.passing == Passing::still) return TrafficAlarm::inside;
  const bool is_soon = approach.passing == Passing::closing && approach.time_s <= limits.time_s;
  return is_soon ? TrafficAlarm::closing : TrafficAlarm::none;
}

double distance_now_m(const twin::MovingPoint& vessel, const Fixed& place) {
  const auto away = vessel.position_m - place.point.position_m;
  return std::hypot(away.x, away.y);
}

struct Judged {
  Approach approach;
  TrafficAlarm alarm = TrafficAlarm::none;
  double now_m = 0;
};

bool matters_more(const Judged& a, const Judged& b) {
  const bool a_alarms = a.alarm != TrafficAlarm::none, b_alarms = b.alarm != TrafficAlarm::none;
  if (a_alarms != b_alarms) return a_alarms;
  if (a_alarms) return a.approach.time_s < b.approach.time_s;
  const bool a_comes = a.approach.passing == Passing::closing;
  const bool b_comes = b.approach.passing == Passing::closing;
  if (a_comes != b_comes) return a_comes;
  return a_comes ? a.approach.distance_m < b.approach.distance_m : a.now_m < b.now_m;
}

class Surroundings {
 public:
  explicit Surroundings(const TrafficQuestion& question)
      : asked_(question), plane_(question.place) {
    for (const TurbinePlace& turbine : question.turbines)
      turbines_.push_back({turbine.id, {on_plane(turbine.point), {}}});
  }

  /// Nothing for a vessel out of reach.
  [[nodiscard]] std::optional<VesselThere> look_at(const LastHeard& heard) const {
    VesselThere there;
    there.heard = heard;
    there.age = std::max(Duration(0), asked_.at - heard.position.time);
    const TrafficRule& rule = asked_.rule;
    there.is_fresh =
        there.age <= fresh_for(rule, heard.speaker, heard.position.speed_over_ground_m_s);
    there.place = heard.position.point;
    if (distance_m(there.place, asked_.place) > rule.reach_m) return std::nullopt;
    twin::MovingPoint now = reported(heard);
    const bool is_moving = now.velocity_m_s.x != 0 || now.velocity_m_s.y != 0;
    if (there.is_fresh && is_moving) {
      now.position_m = now.position_m + seconds(there.age) * now.velocity_m_s;
      there.is_carried_on = there.age > Duration(0);
      if (there.is_carried_on) there.place = on_earth(now.position_m);
      there.ahead = on_earth(now.position_m + seconds(rule.way) * now.velocity_m_s);
    }
    there.distance_m = std::hypot(now.position_m.x, now.position_m.y);
    there.bearing_deg = to_direction_deg(twin::horizontal_of(now.position_m));
    if (there.is_fresh && says_how_it_moves(heard.position)) judge(now, there);
    return there;
  }

 private:
  static double seconds(Duration duration) {
    return std::chrono::duration<double>(duration).count();
  }
  [[nodiscard]] twin::Triple<double> on_plane(const GeoPoint& point) const {
    return twin::ned_of(horizontal_of(plane_.to_local(point)));
  }
  /// The place under a point of the plane, which leaves the sea: the way down to it is a turn about
  /// the Earth's middle, 1 m a side at 50 km.
  [[nodiscard]] GeoPoint on_earth(const twin::Triple<double>& ned_m) const {
    constexpr double radius_m = 6'371'008.8;
    const double away_m = std::hypot(ned_m.x, ned_m.y);
    const double down_m = radius_m - std::sqrt(radius_m * radius_m - away_m * away_m);
    return plane_.to_geodetic({ned_m.y, ned_m.x, -down_m}).point;
  }
  [[nodiscard]] bool lies_still(const ingest::AisPosition& position) const {
    return position.speed_over_ground_m_s &&
           *position.speed_over_ground_m_s < asked_.rule.still_m_s;
  }
  [[nodiscard]] bool says_how_it_moves(const ingest::AisPosition& position) const {
    return lies_still(position) || (position.speed_over_ground_m_s && position.course_over_ground);
  }
  /// As its last report has it, on the plane.
  [[nodiscard]] twin::MovingPoint reported(const LastHeard& heard) const {
    ingest::AisTrack track;
    track.positions = {heard.position};
    const twin::Track on_site = track_on_site(track, plane_, heard.position.time);
    const twin::TrackPoint& point = on_site.points().front();
    twin::MovingPoint now{point.position_m, {}};
    if (point.velocity_m_s && !lies_still(heard.position)) now.velocity_m_s = *point.velocity_m_s;
    return now;
  }
  [[nodiscard]] Judged judged(const twin::MovingPoint& vessel, const Fixed& place) const {
    const Approach approach = approach_of(vessel, place);
    return {approach, alarm_of(approach, asked_.rule.alarm), distance_now_m(vessel, place)};
  }
  void judge(const twin::MovingPoint& vessel, VesselThere& there) const {
    Judged most = judged(vessel, {});
    there.to_site = most.approach;
    std::optional<Judged> of_turbines;
    for (const Fixed& turbine : turbines_) {
      const Judged one = judged(vessel, turbine);
      if (!of_turbines || matters_more(one, *of_turbines)) of_turbines = one;
    }
    if (of_turbines) {
      there.to_turbine = of_turbines->approach;
      if (!matters_more(most, *of_turbines)) most = *of_turbines;
    }
    there.told = most.approach;
    there.alarm = most.alarm;
  }

  const TrafficQuestion& asked_;
  LocalFrame plane_;
  std::vector<Fixed> turbines_;
};

}  // namespace

TrafficAnswer traffic_about(const TrafficQuestion& question, const TrafficHeard& heard) {
  const Surroundings around(question);
  TrafficAnswer answer;
  for (const LastHeard& last : heard.vessels) {
    std::optional<VesselThere> there = around.look_at(last);
    if (!there) continue;
    if (there->age > question.rule.shown)
      ++answer.too_old;
    else
      answer.vessels.push_back(std::move(*there));
  }
  std::stable_sort(answer.vessels.begin(), answer.vessels.end(),
                   [](const VesselThere& a, const VesselThere& b) {
                     const bool a_marked = a.alarm != TrafficAlarm::none;
                     const bool b_marked = b.alarm != TrafficAlarm::none;
                     if (a_marked != b_marked) return a_marked;
                     return a.distance_m < b.distance_m;
                   });
  if (answer.vessels.size() > most_vessels) {
    answer.left_out = answer.vessels.size() - most_vessels;
    answer.vessels.resize(most_vessels);
  }
  return answer;
}

}  // namespace slackwater::api
