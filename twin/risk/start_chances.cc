#include "twin/risk/start_chances.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fields/base/check.h"
#include "twin/risk/peak_after.h"

namespace slackwater::twin {
namespace {

constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint16_t none = std::numeric_limits<std::uint16_t>::max();

/// The first thing that stops each start, of one member.
struct FirstStops {
  std::vector<std::uint32_t> step;   ///< of the grid; `never`
  std::vector<std::uint16_t> limit;  ///< `none`
};

FirstStops no_stops(std::size_t starts) {
  return {std::vector<std::uint32_t>(starts, never), std::vector<std::uint16_t>(starts, none)};
}

/// For each step the next one, itself among them, at which a value is not within the bound.
void note_next_stop(const WatchedLimit& watched, std::span<const double> values,
                    std::vector<std::uint32_t>& next) {
  const auto note = [&](auto stops) {
    std::uint32_t found = never;
    for (std::size_t i = values.size(); i-- > 0;) {
      if (stops(values[i])) found = static_cast<std::uint32_t>(i);
      next[i] = found;
    }
  };
  const Bound bound = watched.bound;
  if (watched.may_be_missing)
    note([&](double value) { return !bound.holds(value) && !std::isnan(value); });
  else
    note([&](double value) { return !bound.holds(value); });
}

/// Of two that stop at the same step the one that was listed first stays.
void add_stops(const StartQuestion& question, const WatchedLimit& watched,
               const std::vector<std::uint32_t>& next, FirstStops& first) {
  for (std::size_t s = 0; s < question.starts.count; ++s) {
    const std::size_t from = question.starts.step_of(s);
    for (const StepRange& when : watched.when) {
      const std::uint32_t stop = next[from + when.begin];
      if (stop >= from + when.end) continue;
      if (stop < first.step[s]) {
        first.step[s] = stop;
        first.limit[s] = static_cast<std::uint16_t>(watched.limit);
      }
      break;
    }
  }
}

void merge(const FirstStops& other, FirstStops& first) {
  for (std::size_t s = 0; s < first.step.size(); ++s) {
    if (other.step[s] >= first.step[s]) continue;
    first.step[s] = other.step[s];
    first.limit[s] = other.limit[s];
  }
}

/// By member. What is the same in all is worked out once.
std::vector<FirstStops> first_stops(const StartQuestion& question) {
  std::vector<std::uint32_t> next(question.steps);
  FirstStops shared = no_stops(question.starts.count);
  for (const WatchedLimit& watched : question.watched) {
    if (watched.members.size() > 1) continue;
    note_next_stop(watched, watched.members.front(), next);
    add_stops(question, watched, next, shared);
  }
  std::vector<FirstStops> all(question.members, no_stops(question.starts.count));
  for (std::size_t m = 0; m < question.members; ++m) {
    for (const WatchedLimit& watched : question.watched) {
      if (watched.members.size() <= 1) continue;
      note_next_stop(watched, watched.members[m], next);
      add_stops(question, watched, next, all[m]);
    }
    merge(shared, all[m]);
  }
  return all;
}

/// The limit that is the first to stop most members of a start, and the median of when.
class Tally {
 public:
  explicit Tally(std::size_t limits) : members_(limits) {}

  std::optional<BindingLimit> of(const std::vector<FirstStops>& stops, std::size_t start) {
    std::fill(members_.begin(), members_.end(), 0);
    for (const FirstStops& member : stops)
      if (member.limit[start] != none) ++members_[member.limit[start]];
    const auto most = std::max_element(members_.begin(), members_.end());
    if (most == members_.end() || *most == 0) return std::nullopt;
    BindingLimit binding;
    binding.limit = static_cast<std::size_t>(most - members_.begin());
    binding.is_exceeded = true;
    binding.members = *most;
    steps_.clear();
    for (const FirstStops& member : stops)
      if (member.limit[start] == binding.limit) steps_.push_back(member.step[start]);
    const auto middle = steps_.begin() + static_cast<std::ptrdiff_t>((steps_.size() - 1) / 2);
    std::nth_element(steps_.begin(), middle, steps_.end());
    binding.step = *middle;
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
    all.push_back({peaks_after(watched.members.front(), watched.when, question.starts,
                               is_upper(watched.bound)),
                   &watched});
  }
  return all;
}

/// Completes what binds a start: how much of it is taken up, or, where nothing is exceeded, which
/// limit is nearest.
void add_share(const std::vector<Nearness>& all, std::size_t start,
               std::optional<BindingLimit>& binding) {
  const bool is_exceeded = binding && binding->is_exceeded;
  if (is_exceeded) binding->share = std::numeric_limits<double>::quiet_NaN();
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

void expect_question(const StartQuestion& question) {
  expects(question.members > 0, "a forecast has a member");
  expects(question.steps < never, "a grid whose steps can be counted");
  expects(question.limits < none, "fewer limits than can be counted");
  for (const WatchedLimit& watched : question.watched) {
    expects(watched.limit < question.limits, "a watched limit is one of the task's");
    expects(watched.members.size() == 1 || watched.members.size() == question.members,
            "a series for each member, or one for all");
    expects(watched.alpha.empty() ||
                (watched.alpha.size() == question.starts.count && is_upper(watched.bound)),
            "a factor for each start, of a limit from above");
    for (const auto& values : watched.members)
      expects(values.size() == question.steps, "a value for each step");
    for (const StepRange& when : watched.when)
      expects(question.starts.count == 0 ||
                  question.starts.step_of(question.starts.count - 1) + when.end <= question.steps,
              "the grid holds all that a start asks for");
  }
}

}  // namespace

std::vector<StartChance> start_chances(const StartQuestion& question) {
  expect_question(question);
  const std::vector<FirstStops> stops = first_stops(question);
  const std::vector<Nearness> nearness = nearness_of(question);
  Tally tally(question.limits);
  std::vector<StartChance> chances(question.starts.count);
  for (std::size_t s = 0; s < chances.size(); ++s) {
    StartChance& chance = chances[s];
    chance.by_threshold = stops.front().limit[s] == none;
    for (const FirstStops& member : stops) chance.held += member.limit[s] == none ? 1 : 0;
    chance.by_alpha = by_alpha(nearness, s, chance.by_threshold);
    chance.binding = tally.of(stops, s);
    add_share(nearness, s, chance.binding);
  }
  return chances;
}

}  // namespace slackwater::twin
