#include "twin/risk/start_chances.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/statistics.h"
#include "twin/risk/first_stops.h"
#include "twin/risk/peak_after.h"

namespace slackwater::twin {
namespace {

/// The limit that is the first to stop most members of a start, and the median of when.
class Tally {
 public:
  explicit Tally(std::size_t limits) : members_(limits) {}

  std::optional<BindingLimit> of(const std::vector<FirstStops>& stops, std::size_t start) {
    std::fill(members_.begin(), members_.end(), 0);
    for (const FirstStops& member : stops)
      if (member.limit[start] != no_limit) ++members_[member.limit[start]];
    const auto most = std::max_element(members_.begin(), members_.end());
    if (most == members_.end() || *most == 0) return std::nullopt;
    BindingLimit binding;
    binding.limit = static_cast<std::size_t>(most - members_.begin());
    binding.is_exceeded = true;
    binding.members = *most;
    steps_.clear();
    for (const FirstStops& member : stops)
      if (member.limit[start] == binding.limit) steps_.push_back(member.step[start]);
    binding.step = lower_median_of(std::span(steps_));
    return binding;
  }

 private:
  std::vector<std::size_t> members_;
  std::vector<std::uint32_t> steps_;
};

double share_of(const Bound& bound, double value) {
  const bool is_least = bound.side == BoundSide::at_least || bound.side == BoundSide::above;
  return is_least ? bound.value / value : value / bound.value;
}

bool is_upper(const Bound& bound) {
  return bound.side == BoundSide::at_most || bound.side == BoundSide::below;
}

/// How near the central forecast comes to one watched limit, by start.
struct Nearness {
  std::vector<Peak> peaks;
  const WatchedLimit* watched = nullptr;
};

std::vector<Nearness> nearness_of(const StartQuestion& question) {
  std::vector<Nearness> all;
  for (const WatchedLimit& watched : question.watched) {
    if (watched.is_gate) continue;
    StartSteps starts = question.starts;
    starts.first -= watched.before;
    all.push_back(
        {peaks_after(watched.members.front(), watched.when, starts, is_upper(watched.bound)),
         &watched});
  }
  return all;
}

/// Completes what binds a start: how much of it is taken up, or, where nothing is exceeded, which
/// limit is nearest.
void add_share(const std::vector<Nearness>& all, std::size_t start,
               std::optional<BindingLimit>& binding) {
  const bool is_exceeded = binding && binding->is_exceeded;
  if (is_exceeded) binding->share = constants::nan;
  for (const Nearness& near : all) {
    const Peak& peak = near.peaks[start];
    if (!peak.step) continue;
    const double share = share_of(near.watched->bound, peak.value);
    if (std::isnan(share)) continue;
    if (is_exceeded) {
      if (near.watched->limit == binding->limit && !(share <= binding->share))
        binding->share = share;
    } else if (!binding || share > binding->share) {
      binding = BindingLimit{near.watched->limit, false, 0, *peak.step, share};
    }
  }
}

/// The rule of practice. A limit without a factor counts in full.
std::optional<bool> by_alpha(const std::vector<Nearness>& all, std::size_t start,
                             bool by_threshold) {
  bool has_factor = false;
  bool allows = by_threshold;
  for (const Nearness& near : all) {
    if (near.watched->alpha.empty()) continue;
    has_factor = true;
    const double alpha = near.watched->alpha[start];
    if (std::isnan(alpha)) return std::nullopt;
    const Peak& peak = near.peaks[start];
    if (!peak.step) continue;  // all unknown: the threshold has said what that means
    Bound bound = near.watched->bound;
    bound.value *= alpha;
    allows &= bound.holds(peak.value);
  }
  if (!has_factor) return std::nullopt;
  return allows;
}

/// The same of work that is done over several visits, whose factors are the same for all starts.
std::optional<bool> split_by_alpha(const StartQuestion& question, const FirstStops& practice,
                                   std::size_t start) {
  bool has_factor = false;
  for (const WatchedLimit& watched : question.watched) {
    if (watched.alpha.empty()) continue;
    has_factor = true;
    if (std::isnan(watched.alpha[start])) return std::nullopt;
  }
  if (!has_factor) return std::nullopt;
  return practice.limit[start] == no_limit;
}

void expect_question(const StartQuestion& question) {
  expects(question.members > 0, "a forecast has a member");
  expects(question.steps < never_stopped, "a grid whose steps can be counted");
  expects(question.limits < no_limit, "fewer limits than can be counted");
  if (question.split)
    expects(question.split->by_step <= question.steps && question.split->limit < question.limits,
            "visits end within the grid, and too little time is a limit of its own");
  for (const WatchedLimit& watched : question.watched) {
    expects(watched.limit < question.limits, "a watched limit is one of the task's");
    expects(watched.before <= question.starts.first && (watched.before == 0 || !question.split),
            "the grid holds what comes before a start, of work that is done in one go");
    expects(watched.members.size() == 1 || watched.members.size() == question.members,
            "a series for each member, or one for all");
    expects(watched.alpha.empty() ||
                (watched.alpha.size() == question.starts.count && is_upper(watched.bound)),
            "a factor for each start, of a limit from above");
    for (const auto& values : watched.members)
      expects(values.size() == question.steps, "a value for each step");
    for (const StepRange& when : watched.when)
      expects(question.starts.count == 0 ||
                  question.starts.step_of(question.starts.count - 1) + when.end <=
                      question.steps + watched.before,
              "the grid holds all that a start asks for");
  }
}

}  // namespace

std::vector<StartChance> start_chances(const StartQuestion& question) {
  expect_question(question);
  const std::vector<FirstStops> stops = first_stops(question);
  const std::vector<Nearness> nearness = nearness_of(question);
  const FirstStops practice = question.split ? central_stops_with_alpha(question) : FirstStops();
  Tally tally(question.limits);
  std::vector<StartChance> chances(question.starts.count);
  for (std::size_t s = 0; s < chances.size(); ++s) {
    StartChance& chance = chances[s];
    chance.by_threshold = stops.front().limit[s] == no_limit;
    for (const FirstStops& member : stops) chance.held += member.limit[s] == no_limit ? 1 : 0;
    chance.by_alpha = question.split ? split_by_alpha(question, practice, s)
                                     : by_alpha(nearness, s, chance.by_threshold);
    chance.binding = tally.of(stops, s);
    add_share(nearness, s, chance.binding);
  }
  return chances;
}

}  // namespace slackwater::twin
