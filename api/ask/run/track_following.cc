#include "api/ask/run/track_following.h"

#include <limits>

#include "fields/base/text.h"
#include "twin/body/frame.h"

namespace slackwater::api {

double TrackFollowing::share_within() const noexcept {
  return deviation.samples == 0
             ? 0
             : static_cast<double>(deviation.within) / static_cast<double>(deviation.samples);
}

std::vector<TrackFollowing> tracks_followed(std::span<const twin::Agent> agents,
                                            const twin::RunLog& log) {
  std::vector<TrackFollowing> out;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const auto& tasks = agents[i].mission.tasks;
    for (std::size_t k = 0; k < tasks.size(); ++k) {
      if (!tasks[k].follow) continue;
      const std::vector<double> x = log.column(i, "x"), y = log.column(i, "y"),
                                task = log.column(i, "task"), halt = log.column(i, "halt");
      std::vector<twin::FollowedPoint> points;
      for (std::size_t t = 0; t < log.t_s.size(); ++t)
        if (task[t] == static_cast<double>(k) && halt[t] == 0)
          points.push_back({log.t_s[t], twin::ned_of(Horizontal(x[t], y[t]))});
      const twin::TrackToFollow& follow = *tasks[k].follow;
      // However far it has fallen behind.
      constexpr double window_m = std::numeric_limits<double>::infinity();
      out.push_back({i, agents[i].name, k, follow.mmsi, follow.name, follow.within_m,
                     twin::deviation_from(*follow.track, {}, points, window_m, follow.within_m)});
    }
  }
  return out;
}

std::string text_of(const TrackFollowing& f) {
  const twin::Deviation& d = f.deviation;
  std::string text = f.vehicle_name + " followed " + std::to_string(f.mmsi) +
                     (f.name.empty() ? "" : " (" + f.name + ")") + ": ";
  if (d.samples == 0) return text + "the track says nothing of the time of that task";
  return text + formatted(
                    "across {:.2f} m rms, {:.2f} m at most; along {:.2f} m rms, {:.2f} m at most "
                    "(mean {:+.2f} m); within {:g} m for {:.1f} % of {} samples",
                    d.across.rms_m, d.across.most_m, d.along.rms_m, d.along.most_m, d.along.mean_m,
                    f.within_m, 100 * f.share_within(), d.samples);
}

}  // namespace slackwater::api
