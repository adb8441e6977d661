#include "api/ask/windows/limits_of_task.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "api/ask/windows/vessel_access.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"
#include "twin/agent/conduct.h"
#include "twin/mission/site_work.h"
#include "twin/risk/peak_after.h"

namespace slackwater::api {
namespace {

bool is_known_nowhere(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

bool is_unknown(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

/// By start the least bound that the limit has while it counts: one number, but of a table.
std::vector<double> least_bounds(const Outlook& outlook, const twin::Limit& limit,
                                 const twin::LimitAhead& ahead, const twin::StepRanges& when,
                                 bool is_split) {
  std::vector<double> least(outlook.starts.count, limit.bound);
  if (!limit.table) return least;
  std::vector<double> bounds;
  for (const twin::HeightBound& by_sea : ahead.by_sea) bounds.push_back(by_sea.at_most_m);
  if (is_split) {  // visits are made at any hour
    least.assign(least.size(), *std::min_element(bounds.begin(), bounds.end()));
    return least;
  }
  const auto peaks = twin::peaks_after(bounds, when, outlook.starts, false);
  for (std::size_t s = 0; s < least.size(); ++s)
    if (peaks[s].step) least[s] = peaks[s].value;
  return least;
}

/// Factors by start, each period rounded up to the hour; empty where practice has none for such
/// limits. Of a table that of the least bound which the limit has while it counts.
/// @param bounds  of the limit, by start
std::vector<double> factors_of(const WindowsQuestion& question, const SharedOutlook& shared,
                               const Outlook& outlook, const twin::Limit& limit,
                               const std::vector<double>& bounds, const TaskWindows& task,
                               std::string& why) {
  const UtcTime issued = shared.water->surround.field->snapshot().issued;
  std::vector<double> factors;
  std::map<std::pair<double, double>, twin::AlphaFactor> known;
  for (std::size_t s = 0; s < outlook.starts.count; ++s) {
    const UtcTime start = outlook.clock.time_of(outlook.starts.step_of(s));
    const double waits_h =
        question.period_from_start ? 0 : std::max(0.0, hours_between(issued, start));
    const UtcTime visits_from = question.period_from_start ? shared.from : issued;
    const double period_h = std::ceil(
        (task.is_split ? hours_between(visits_from, shared.to) : waits_h + task.planned_s / 3600) -
        1e-9);
    const std::pair asked(period_h, bounds[s]);
    if (!known.contains(asked)) {
      const auto factor = question.practice.at(limit, bounds[s], period_h);
      if (!factor) return {};
      known[asked] = *factor;
    }
    const twin::AlphaFactor& factor = known[asked];
    if (!factor.value && why.empty()) why = factor.why;
    factors.push_back(factor.value.value_or(std::nan("")));
  }
  return factors;
}

twin::Bound bound_of(const twin::Limit& limit, const twin::LimitAhead& ahead) {
  return {limit.is_least ? twin::BoundSide::at_least : twin::BoundSide::at_most,
          ahead.bound_of(limit)};
}

/// @param where  it is written
void expect_known_somewhere(const TaskLimit& limit, const char* where,
                            const twin::LimitAhead& ahead) {
  if (limit.limit->may_be_missing || !is_known_nowhere(ahead.members.front())) return;
  throw Error(ErrorKind::invalid_input,
              "found the limit \"" + text_of(limit) +
                  "\", and the forecast has no value for it at any hour; ingest a product that "
                  "has it, or say `if_missing: not_checked` in " +
                  where);
}

bool is_unknown_anywhere(const twin::LimitAhead& ahead) {
  return std::any_of(ahead.members.begin(), ahead.members.end(), is_unknown);
}

/// The limits of every worker, at the steps of the phases that they name.
void watch_limits(const WindowsQuestion& question, const SharedOutlook& shared, Outlook& outlook,
                  TaskWindows& out) {
  const double step_s = std::chrono::duration<double>(outlook.clock.step).count();
  std::set<std::string> not_checked;
  for (std::size_t a = 0; a < outlook.ready.agents.size(); ++a) {
    const twin::Agent& agent = outlook.ready.agents[a];
    if (!agent.conduct) continue;
    const std::size_t before = out.limits.size();
    for (const twin::Limit& limit : agent.conduct->plan.limits) {
      out.limits.push_back({agent.name, twin::text_of(limit), limit});
      if (twin::only_a_run_shows(limit.variable))
        not_checked.insert(text_of(out.limits.back()) + ", which only a run shows");
    }
    for (twin::LimitAhead& ahead :
         twin::limits_ahead(outlook.ready, a, outlook.clock, shared.members, shared.waves)) {
      const twin::Limit& limit = agent.conduct->plan.limits[ahead.limit];
      twin::PhaseSet phase;
      phase.bits = 0;
      phase.add(ahead.phase);
      twin::WatchedLimit watched;
      watched.limit = before + ahead.limit;
      watched.bound = bound_of(limit, ahead);
      watched.may_be_missing = limit.may_be_missing;
      // Half of a level that counts from mean sea level is no half of anything.
      watched.is_gate = limit.variable == twin::LimitVariable::sea_surface_height;
      watched.when = twin::steps_of(out.workers[a].plan, phase, out.contingency_s, step_s);
      if (watched.when.empty()) continue;
      expect_known_somewhere(out.limits[watched.limit], "the task", ahead);
      if (out.is_split) watched.when = whole_stay(outlook, out);
      watched.alpha = factors_of(question, shared, outlook, limit,
                                 least_bounds(outlook, limit, ahead, watched.when, out.is_split),
                                 out, out.no_alpha);
      if (limit.may_be_missing && is_unknown_anywhere(ahead))
        not_checked.insert(text_of(out.limits[watched.limit]));
      outlook.ahead.push_back(std::move(ahead));
      outlook.question.watched.push_back(std::move(watched));
    }
  }
  out.not_checked.assign(not_checked.begin(), not_checked.end());
}

/// When a limit of the vessel counts; empty: always.
std::string when_text(twin::PhaseSet phases) {
  using twin::Phase;
  const bool is_under_way = phases.has(Phase::transit) || phases.has(Phase::return_home);
  const bool goes_over = phases.has(Phase::launch) || phases.has(Phase::recovery);
  if (is_under_way == goes_over) return {};
  return goes_over ? " as people go over" : " under way";
}

/// Her limits. Where people go over, her bow is on the boat landing: a table that goes by her
/// heading has it, where it is the same at all turbines of the task.
std::vector<twin::Limit> limits_of_vessel(const SharedOutlook& shared, const TaskWindows& task) {
  using twin::Phase;
  std::vector<twin::Limit> limits = shared.vessel->limits;
  std::set<double> headings_rad;
  for (const twin::WorkTurbine& turbine : twin::work_site_of(*shared.site).turbines)
    if (std::find(task.turbines.begin(), task.turbines.end(), turbine.id) != task.turbines.end())
      headings_rad.insert(compass_rad(turbine.landing_rad + constants::pi));
  for (twin::Limit& limit : limits) {
    const twin::PhaseSet& when = limit.phases;
    const bool is_on_landing = !when.has(Phase::transit) && !when.has(Phase::return_home) &&
                               !when.has(Phase::work) && headings_rad.size() == 1;
    if (is_on_landing && limit.table && limit.table->goes_by_heading())
      limit.table->heading_rad = *headings_rad.begin();
  }
  return limits;
}

/// The limits of the vessel, on her ways, while people go over and while she waits.
void watch_vessel(const SharedOutlook& shared, Outlook& outlook, TaskWindows& out) {
  if (shared.vessel == nullptr) return;
  const VesselAccess& vessel = *shared.vessel;
  const std::size_t before = out.limits.size();
  const std::size_t lead = outlook.starts.first;
  const std::vector<twin::Limit> limits = limits_of_vessel(shared, out);
  for (const twin::Limit& limit : limits)
    out.limits.push_back({vessel.name, twin::text_of(limit) + when_text(limit.phases), limit});
  for (twin::LimitAhead& ahead :
       twin::limits_ahead(outlook.ready, 0, limits, outlook.clock, shared.members, shared.waves)) {
    const twin::Limit& limit = limits[ahead.limit];
    twin::WatchedLimit watched;
    watched.limit = before + ahead.limit;
    watched.bound = bound_of(limit, ahead);
    watched.may_be_missing = limit.may_be_missing;
    watched.before = lead;
    watched.when = out.is_split ? whole_stay(outlook, out)
                                : steps_of_access(vessel, limit.phases, lead, out.planned_s,
                                                  out.contingency_s, outlook.clock.step);
    if (watched.when.empty()) continue;
    expect_known_somewhere(out.limits[watched.limit], "the vessel's sheet", ahead);
    if (limit.may_be_missing && is_unknown_anywhere(ahead))
      out.not_checked.push_back(text_of(out.limits[watched.limit]));
    outlook.ahead.push_back(std::move(ahead));
    outlook.question.watched.push_back(std::move(watched));
  }
}

/// Lays the series of all limits beside each other, one for each future: those of the waves, where
/// a limit is on their height, with the water of the member that each goes with.
void lay_futures(const SharedOutlook& shared, Outlook& outlook, TaskWindows& out) {
  const auto has = [&](std::size_t series) {
    return std::any_of(outlook.ahead.begin(), outlook.ahead.end(),
                       [&](const twin::LimitAhead& one) { return one.members.size() == series; });
  };
  const std::size_t of_waves = shared.waves == nullptr ? 0 : shared.waves->futures();
  const bool is_by_waves = of_waves > 1 && has(of_waves);
  out.futures = is_by_waves ? of_waves : shared.members;
  const bool is_by_water = shared.members > 1 && has(shared.members);
  out.independent = is_by_waves && is_by_water ? shared.members : out.futures;
  for (std::size_t i = 0; i < outlook.ahead.size(); ++i) {
    const std::vector<std::vector<double>>& series = outlook.ahead[i].members;
    std::vector<std::span<const double>>& watched = outlook.question.watched[i].members;
    if (series.size() == 1 || series.size() == out.futures) {
      watched.assign(series.begin(), series.end());
    } else {
      // Fewer waters may be looked at than the forecast has.
      watched.emplace_back(series.front());
      for (std::size_t f = 1; f < out.futures; ++f)
        watched.emplace_back(series[(shared.waves->member_of(f) - 1) % (series.size() - 1) + 1]);
    }
  }
  outlook.question.members = out.futures;
}

/// Hours that are open to the whole of a task, or shut.
void add_gate(const std::string& text, const twin::StepRanges& open, Outlook& outlook,
              TaskWindows& out) {
  std::vector<double> values(outlook.clock.steps, 0);
  for (const twin::StepRange& range : open)
    std::fill(values.begin() + static_cast<std::ptrdiff_t>(range.begin),
              values.begin() + static_cast<std::ptrdiff_t>(range.end), 1);
  outlook.gates.push_back(std::move(values));
  twin::WatchedLimit watched;
  watched.limit = out.limits.size();
  watched.bound = {twin::BoundSide::at_least, 1};
  watched.is_gate = true;
  watched.when = whole_stay(outlook, out);
  // The values move with the vector that holds them, their place does not.
  watched.members.emplace_back(outlook.gates.back());
  outlook.question.watched.push_back(std::move(watched));
  out.limits.push_back({{}, text, {}});
}

/// Polar days and nights are told.
void note_light(const SharedOutlook& shared, const WindowsQuestion& question, twin::Light light,
                TaskWindows& out) {
  const auto day = twin::light_of(shared.site->point, day_of(shared.from), light, question.zone);
  if (day.kind == twin::DayOfLight::Kind::comes_and_goes) return;
  out.notes.push_back("daylight (" + std::string(twin::name_of(light)) + ") at " +
                      formatted("{:.1f}", shared.site->point.latitude_deg()) +
                      " degrees north on " + format_day(day_of(shared.from)) + ": " +
                      twin::text_of(day, question.zone));
}

void add_gates(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
               Outlook& outlook, TaskWindows& out) {
  std::set<twin::Light> lights;
  if (question.light) lights.insert(*question.light);
  if (sheet.daylight) lights.insert(*sheet.daylight);
  outlook.gates.reserve(lights.size() + 1);
  for (const twin::Light light : lights) {
    add_gate("daylight (" + std::string(twin::name_of(light)) + ")",
             twin::light_steps(outlook.clock, shared.site->point, light), outlook, out);
    note_light(shared, question, light, out);
  }
  if (question.shift)
    add_gate("shift " + twin::text_of(*question.shift) + " " +
                 (question.zone ? question.zone->name() : "UTC"),
             twin::steps_at(outlook.clock, *question.shift, question.zone), outlook, out);
}

/// What stops a start of split work from which there is too little time left.
void add_too_little_time(const SharedOutlook& shared, Outlook& outlook, TaskWindows& out) {
  if (!outlook.question.split) return;
  outlook.question.split->limit = out.limits.size();
  out.limits.push_back({{}, "hours enough for the work by " + format_utc(shared.to), {}});
}

}  // namespace

std::string text_of(const TaskLimit& limit) {
  return limit.worker.empty() ? limit.text : limit.text + " (" + limit.worker + ")";
}

void watch(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
           Outlook& outlook, TaskWindows& out) {
  watch_limits(question, shared, outlook, out);
  watch_vessel(shared, outlook, out);
  lay_futures(shared, outlook, out);
  add_gates(question, shared, sheet, outlook, out);
  add_too_little_time(shared, outlook, out);
  outlook.question.steps = outlook.clock.steps;
  outlook.question.limits = out.limits.size();
  outlook.question.starts = outlook.starts;
}

}  // namespace slackwater::api
