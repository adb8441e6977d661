#include "api/ask/plan/plan_setup.h"

#include <algorithm>
#include <cmath>

#include "api/ask/plan/candidates.h"
#include "api/ask/plan/sea_way.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/geo/local_frame.h"

namespace slackwater::api {
namespace {

constexpr Duration widest_gap = std::chrono::hours(1);

Minute minutes_up(Duration duration) {
  return static_cast<Minute>(std::chrono::ceil<std::chrono::minutes>(duration).count());
}

/// Minutes after the beginning of the UTC day at which the site's clocks show a time of that date.
Minute minute_at(const PlanFile& plan, UtcDay day, std::chrono::minutes clock) {
  if (!plan.site.time_zone) return static_cast<Minute>(clock.count());
  const UtcTime as_utc = day + clock;
  const auto guess = plan.site.time_zone->offset_at(as_utc);
  return static_cast<Minute>((clock - plan.site.time_zone->offset_at(as_utc - guess)).count());
}

PlanHours hours_of(const PlanFile& plan, UtcDay day, const twin::DayHours& hours) {
  return {minute_at(plan, day, hours.from), minute_at(plan, day, hours.to)};
}

/// The places of the turbines that have work, and of the ports.
std::vector<GeoPoint> add_places(const PlanFile& plan, PlanProblem& problem) {
  std::vector<GeoPoint> points;
  const auto add = [&](const std::string& id, const GeoPoint& point) {
    problem.places.push_back(id);
    points.push_back(point);
  };
  for (const TurbinePlace& turbine : plan.site.turbines) add(turbine.id, turbine.point);
  for (std::size_t v = 0; v < plan.vessels.size(); ++v) {
    const auto& port = plan.vessels[v].port;
    if (!port) continue;
    problem.vessels[v].port = points.size();
    add(port->name, port->point);
  }
  return points;
}

void add_ways(const PlanFile& plan, const std::vector<GeoPoint>& points, PlanProblem& problem) {
  const std::vector<ConstraintArea> closed =
      closed_areas(plan.site.areas, problem.begin, problem.begin + std::chrono::hours(24));
  const std::size_t n = points.size();
  std::vector<std::vector<double>> ways_m(n, std::vector<double>(n, 0.0));
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < a; ++b)
      ways_m[a][b] = ways_m[b][a] = sea_way_m(points[b], points[a], closed);
  for (std::size_t v = 0; v < problem.vessels.size(); ++v) {
    auto& ways = problem.vessels[v].way_min;
    ways.assign(n, std::vector<Minute>(n, 0));
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        ways[a][b] =
            static_cast<Minute>(std::ceil(ways_m[a][b] / plan.vessels[v].speed_m_s / 60 - 1e-9));
  }
}

/// What the windows say of a start at a time, see `problem_of`.
std::optional<DayChances::Start> start_at(const std::vector<DayChances::Start>& starts,
                                          UtcTime time) {
  const auto after =
      std::lower_bound(starts.begin(), starts.end(), time,
                       [](const DayChances::Start& one, UtcTime at) { return one.time < at; });
  if (after == starts.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == starts.begin()) return std::nullopt;
  const auto before = after - 1;
  if (after->time - before->time > widest_gap) return std::nullopt;
  return DayChances::Start{time, std::min(before->probability, after->probability),
                           std::max(before->duration, after->duration),
                           std::max(before->energy_wh, after->energy_wh)};
}

/// Why work may not go on at a place from one time to another; empty: it may.
class Closed {
 public:
  Closed(const PlanFile& plan, const GeoPoint& point, const std::optional<twin::Light>& light,
         const StepClock& quarters)
      : quarters_(quarters) {
    const LocalFrame frame(point);
    for (const ConstraintArea& area : plan.site.areas) {
      if (area.kind != AreaKind::exclusion) continue;
      std::vector<Horizontal> corners;
      for (const GeoPoint& corner : area.corners)
        corners.push_back(horizontal_of(frame.to_local(corner)));
      if (is_inside(corners, {0, 0})) about_.push_back(&area);
    }
    if (!light) return;
    name_of_light_ = twin::name_of(*light);
    is_light_.assign(quarters.steps, 0);
    for (const twin::StepRange& range : twin::light_steps(quarters, plan.site.point, *light))
      for (std::size_t i = range.begin; i < range.end; ++i) is_light_[i] = 1;
  }

  std::string why(UtcTime from, UtcTime to) const {
    for (const ConstraintArea* area : about_) {
      for (UtcTime time = from; time < to; time += std::chrono::minutes(5))
        if (area->is_in_force(time))
          return "it lies in zone " + area->id +
                 (area->reason.empty() ? "" : " (" + area->reason + ")") + ", in force then";
    }
    if (is_light_.empty()) return {};
    for (UtcTime time = from; time < to; time += quarters_.step) {
      const auto i = static_cast<std::size_t>((time - quarters_.first) / quarters_.step);
      if (i >= is_light_.size() || is_light_[i] == 0)
        return "it needs daylight (" + name_of_light_ + ")";
    }
    return {};
  }

 private:
  StepClock quarters_;
  std::vector<const ConstraintArea*> about_;
  std::string name_of_light_;
  std::vector<char> is_light_;
};

PlanJob job_of(const PlanFile& plan, const PlanFile::Work& work, std::size_t turbine,
               const DayChances& windows, const PlanProblem& problem) {
  PlanJob job;
  const TurbinePlace& at = plan.site.turbines[turbine];
  job.id = work.task + "@" + at.id;
  job.task = work.task;
  job.place = turbine;
  job.priority = work.priority;
  job.vehicles = work.vehicles;
  job.skills = work.skills;
  const DayChances::Task* task = windows.find(work.task, at.id);
  if (task == nullptr)
    refuse(windows.name + ": found no starts of " + work.task + " at " + at.id +
           ", which the plan asks for; make the windows of this task too");
  if (!task->impossible.empty()) job.without_starts = "no chances: " + task->impossible;
  const Duration contingency = work.contingency.value_or(task->contingency);
  job.contingency_min = minutes_up(contingency);
  job.drop_off_min = minutes_up(work.drop_off.value_or(Duration(0)));
  // Five minutes tell the light; two days hold the longest work that is not refused.
  const Closed closed(plan, at.point, work.light, {problem.begin, std::chrono::minutes(5), 576});
  for (std::size_t slot = 0; slot < problem.slots; ++slot) {
    const UtcTime time = problem.begin + std::chrono::minutes(problem.minute_of(slot));
    const auto start = start_at(task->starts, time);
    if (!start) continue;
    const Duration duration = work.duration.value_or(start->duration);
    const std::string why = closed.why(time, time + duration + contingency);
    if (!why.empty()) {
      job.without_starts = why;
      continue;
    }
    job.starts.push_back({slot, start->probability, minutes_up(duration),
                          work.energy_wh.value_or(start->energy_wh)});
  }
  return job;
}

/// Refuses a job that nobody could do even in the best of weather.
void expect_possible(const PlanProblem& problem, std::size_t j) {
  const PlanJob& job = problem.jobs[j];
  const std::vector<Assignment> teams = teams_of(problem, j);
  if (teams.empty())
    refuse(job.id +
           ": found no vessel that could carry a crew for it and the vehicles it takes "
           "together; put them on one vessel, or leave `vessel` out");
  if (job.starts.empty()) return;
  const Minute shortest =
      std::min_element(job.starts.begin(), job.starts.end(),
                       [](const JobStart& a, const JobStart& b) { return a.hold_min < b.hold_min; })
          ->hold_min +
      job.contingency_min;
  Minute longest_day = 0;
  bool fits = false;
  for (const Assignment& team : teams) {
    const PlanVessel& vessel = problem.vessels[team.vessel];
    const PlanCrew& crew = problem.crews[team.crew];
    const Minute day =
        std::min(vessel.hours.to, crew.shift.to) - std::max(vessel.hours.from, crew.shift.from);
    const Minute way = vessel.port ? vessel.way_min[*vessel.port][job.place] +
                                         vessel.way_min[job.place][*vessel.port]
                                   : 0;
    longest_day = std::max(longest_day, day - way);
    fits = fits || shortest + way <= day;
  }
  if (!fits)
    refuse(
        formatted("{}: found {:.1f} h of work with its contingency, longer than the day: {:.1f} h "
                  "are left of the hours of those who could do it once they are there and back; "
                  "split it, or give longer hours",
                  job.id, shortest / 60.0, std::max(0, longest_day) / 60.0));
}

}  // namespace

PlanProblem problem_of(const PlanFile& plan, const DayChances& windows, double least_probability) {
  if (windows.site != plan.site.id)
    refuse(windows.name + ": found windows of " + windows.site + ", expected those of " +
           plan.site.id + ", the plan's site");
  if (plan.day && windows.day != *plan.day)
    refuse(windows.name + ": found windows of " + format_day(windows.day) + ", expected those of " +
           format_day(*plan.day) + ", the plan's day; make them anew, or change `day`");
  PlanProblem problem;
  problem.begin = windows.day;
  problem.zone = plan.site.time_zone;
  problem.slot_min = plan.grid_min;
  problem.slots = static_cast<std::size_t>(24 * 60 / plan.grid_min);
  problem.least_probability = least_probability;
  problem.batteries = plan.batteries;
  problem.chargers = plan.chargers;
  problem.vehicles = plan.vehicles;
  for (const PlanFile::Vessel& vessel : plan.vessels)
    problem.vessels.push_back(
        {vessel.id, vessel.crews, hours_of(plan, windows.day, vessel.hours), {}, {}});
  for (const PlanFile::Crew& crew : plan.crews)
    problem.crews.push_back(
        {crew.id, crew.skills, hours_of(plan, windows.day, crew.shift), crew.vessel});
  add_ways(plan, add_places(plan, problem), problem);
  for (const PlanFile::Work& work : plan.work) {
    for (const std::size_t turbine : work.turbines) {
      problem.jobs.push_back(job_of(plan, work, turbine, windows, problem));
      expect_possible(problem, problem.jobs.size() - 1);
    }
  }
  return problem;
}

}  // namespace slackwater::api
