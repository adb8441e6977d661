#include "api/ask/rehearse/advice.h"

#include <algorithm>
#include <utility>

#include "fields/base/error.h"
#include "twin/rehearse/expect_fit.h"
#include "twin/rehearse/variation.h"

namespace slackwater::api {
namespace {

using twin::Variation;

std::vector<Variation> variations_of(const LoadedMission& mission, UtcTime start) {
  const twin::Scenario& as_is = mission.scenario;
  const twin::Surround& surround = mission.water.surround;
  std::vector<Variation> out;
  const auto hour = std::chrono::hours(1);
  out.push_back({"an hour earlier", as_is, surround, start - hour});
  out.push_back({"an hour later", as_is, surround, start + hour});
  for (auto& one : {twin::from_the_other_tide(as_is, surround, start),
                    twin::at_half_speed(as_is, surround, start),
                    twin::with_another_battery(as_is, surround, start)})
    if (one) out.push_back(*one);
  for (Variation& one : twin::with_other_vehicles(as_is, surround, start, mission.expanded))
    out.push_back(std::move(one));
  return out;
}

/// Holds the changed flights against those of the same members as it is.
void compare(const StartOutcome& changed, const FlownStart& flown, Advice& out) {
  out.flights = changed.flights.size();
  out.done = changed.success.flights;
  out.low = changed.success.low;
  out.high = changed.success.high;
  for (std::size_t i = 0; i < out.flights; ++i) {
    const bool is_done = changed.flights[i].is_success(), was_done = flown.done[i] != 0;
    out.done_as_is += was_done ? 1 : 0;
    out.gained += is_done && !was_done ? 1 : 0;
    out.lost += was_done && !is_done ? 1 : 0;
  }
}

void fly_changed(const LoadedMission& mission, const RehearsalPlan& plan, const Variation& changed,
                 const FlownStart& flown, Advice& out) {
  if (plan.forbidden) out.impossible = plan.forbidden(changed.start);
  if (!out.impossible.empty()) return;
  twin::Scenario first = changed.mission;
  first.start = changed.start;
  twin::expect_fit(mission.expanded, twin::set_up(first, changed.surround));
  RehearsalPlan once = plan;
  once.starts = {changed.start};
  once.members = flown.done.size();
  once.narrow_enough = 0;
  compare(rehearse(changed.mission, changed.surround, once).starts.front(), flown, out);
}

}  // namespace

FlownStart flown_start(const StartOutcome& flown, std::size_t members) {
  FlownStart out{flown.start, {}};
  for (const twin::Flight& flight : flown.flights) {
    if (out.done.size() == members) break;
    out.done.push_back(flight.is_success() ? 1 : 0);
  }
  return out;
}

std::vector<Advice> advice_for(const LoadedMission& mission, const RehearsalPlan& plan,
                               const FlownStart& flown) {
  std::vector<Advice> all;
  if (flown.done.empty()) return all;
  const std::vector<Variation> variations = variations_of(mission, flown.start);
  RehearsalPlan each = plan;
  each.most_wall_s = plan.most_wall_s / static_cast<double>(variations.size());
  for (const Variation& changed : variations) {
    Advice& out = all.emplace_back();
    out.what = changed.what;
    try {
      fly_changed(mission, each, changed, flown, out);
    } catch (const Error& error) {
      // A vehicle that does not fit, a start outside of the forecast: no answer is one too.
      if (error.kind() != ErrorKind::invalid_input && error.kind() != ErrorKind::not_found) throw;
      out.impossible = error.what();
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Advice& a, const Advice& b) {
    if (a.impossible.empty() != b.impossible.empty()) return a.impossible.empty();
    return a.gain() > b.gain();
  });
  return all;
}

}  // namespace slackwater::api
