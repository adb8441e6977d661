#include "api/ask/rehearse/rehearsal.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>

#include "fields/base/error.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "twin/chance/success_interval.h"
#include "twin/step/step_kernel.h"

namespace slackwater::api {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point from) {
  return std::chrono::duration<double>(Clock::now() - from).count();
}

/// A flight that is to be made, and where its outcome belongs.
struct Due {
  std::size_t start = 0;
  twin::FlightCase flown;
};

/// Members [from, to) of every start that needs them, those of a start one after the other: side by
/// side they come to their ends about together, and no lane of a block goes empty.
std::vector<Due> round_of(const Rehearsal& rehearsal, std::size_t from, std::size_t to) {
  std::vector<Due> round;
  for (std::size_t s = 0; s < rehearsal.starts.size(); ++s) {
    if (rehearsal.starts[s].is_narrow || !rehearsal.starts[s].forbidden.empty()) continue;
    for (std::size_t member = from; member < to; ++member)
      round.push_back({s, {rehearsal.starts[s].start, member}});
  }
  return round;
}

template <typename Is>
void count(const StartOutcome& start, double level, FlightCount& out, Is&& is) {
  out.of = start.flights.size();
  out.flights =
      static_cast<std::size_t>(std::count_if(start.flights.begin(), start.flights.end(), is));
  const twin::SuccessInterval interval = twin::success_interval(out.flights, out.of, level);
  // What was shut out once stays shut out.
  out.low = std::max(out.low, interval.low);
  out.high = std::min(out.high, interval.high);
}

/// Most frequent first.
std::vector<StoppedBy> sorted(const std::map<std::string, std::size_t>& causes) {
  std::vector<StoppedBy> out;
  out.reserve(causes.size());
  for (const auto& [cause, flights] : causes) out.push_back({cause, flights});
  std::stable_sort(out.begin(), out.end(),
                   [](const StoppedBy& a, const StoppedBy& b) { return a.flights > b.flights; });
  return out;
}

void conclude_round(const RehearsalPlan& plan, StartOutcome& start) {
  using twin::Flight;
  count(start, plan.level, start.done, [](const Flight& flight) { return flight.is_done; });
  count(start, plan.level, start.success, [](const Flight& flight) { return flight.is_success(); });
  // Whether anything is asked is the same in all flights.
  if (start.flights.front().is_seen) {
    if (!start.seen) start.seen.emplace();
    count(start, plan.level, *start.seen, [](const Flight& flight) { return *flight.is_seen; });
  }
  start.is_narrow =
      plan.narrow_enough > 0 && start.success.high - start.success.low <= plan.narrow_enough;
  std::map<std::string, std::size_t> stopped, unseen;
  for (const Flight& flight : start.flights) {
    if (!flight.is_done) ++stopped[flight.stopped_by];
    if (flight.is_seen == false) ++unseen[flight.unseen_by];
  }
  start.stopped_by = sorted(stopped);
  start.unseen_by = sorted(unseen);
}

}  // namespace

std::size_t Rehearsal::best() const noexcept {
  std::size_t best = 0;
  for (std::size_t i = 0; i < starts.size(); ++i)
    if (starts[i].success.share() > starts[best].success.share()) best = i;
  return best;
}

Rehearsal rehearse(const twin::Scenario& mission, twin::Surround surround,
                   const RehearsalPlan& plan,
                   const std::function<void(double, const Rehearsal&)>& on_progress) {
  const Clock::time_point began = Clock::now();
  surround = twin::shared_by_flights(mission, std::move(surround));
  Rehearsal rehearsal;
  rehearsal.inspections = surround.inspections;
  for (const UtcTime start : plan.starts) {
    StartOutcome& outcome = rehearsal.starts.emplace_back();
    outcome.start = start;
    outcome.by_the_limits = twin::by_the_limits(mission, surround, start, plan.flights.workers);
    if (plan.forbidden) outcome.forbidden = plan.forbidden(start);
    if (!outcome.forbidden.empty()) outcome.done.high = outcome.success.high = 0;
  }
  const auto all = static_cast<double>(plan.members * plan.starts.size());
  // One member of each first, then as many as make blocks, two at the least for two threads.
  const std::size_t more = (plan.starts.size() > 1 ? 1 : 2) * twin::block_lanes;
  for (std::size_t from = 0; from < plan.members;) {
    const std::size_t to = std::min(from == 0 ? 1 : from + more, plan.members);
    const std::vector<Due> round = round_of(rehearsal, from, to);
    if (round.empty()) break;
    if (plan.most_wall_s > 0 && from > 0 && seconds_since(began) > plan.most_wall_s) break;
    const std::size_t batches = (round.size() + twin::block_lanes - 1) / twin::block_lanes;
    std::vector<std::vector<twin::Flight>> flown(batches);
    for_all(batches, plan.threads, [&](std::size_t b) {
      const std::size_t first = b * twin::block_lanes;
      const std::size_t last = std::min(first + twin::block_lanes, round.size());
      std::vector<twin::FlightCase> cases;
      for (std::size_t i = first; i < last; ++i) cases.push_back(round[i].flown);
      flown[b] = twin::fly(mission, surround, cases, plan.flights);
    });
    for (std::size_t i = 0; i < round.size(); ++i)
      rehearsal.starts[round[i].start].flights.push_back(
          std::move(flown[i / twin::block_lanes][i % twin::block_lanes]));
    for (StartOutcome& start : rehearsal.starts)
      if (!start.is_narrow && start.forbidden.empty()) conclude_round(plan, start);
    if (from == 0) rehearsal.first_answer_s = seconds_since(began);
    from = to;
    rehearsal.wall_s = seconds_since(began);
    if (on_progress) on_progress(static_cast<double>(to * plan.starts.size()) / all, rehearsal);
  }
  return rehearsal;
}

}  // namespace slackwater::api
