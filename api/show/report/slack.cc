#include "api/show/report/slack.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::api {
namespace {

/// When a line between two samples passes the threshold.
UtcTime crossing(UtcTime a, UtcTime b, double at_a, double at_b, double threshold) {
  const double share = (threshold - at_a) / (at_b - at_a);
  return a + std::chrono::round<Duration>(share * std::chrono::duration<double>(b - a));
}

struct Stretch {
  UtcTime from{};
  UtcTime to{};
  bool is_cut_before = false;
  bool is_cut_after = false;
};

/// Stretches in which a series stays below the threshold.
std::vector<Stretch> stretches_below(const std::vector<UtcTime>& time,
                                     const std::vector<double>& value, double threshold) {
  std::vector<Stretch> found;
  const auto below = [&](std::size_t i) { return value[i] < threshold; };  // NaN is not
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!below(i)) continue;
    Stretch stretch;
    const bool starts_unseen = i == 0 || std::isnan(value[i - 1]);
    stretch.is_cut_before = starts_unseen;
    stretch.from =
        starts_unseen ? time[i] : crossing(time[i - 1], time[i], value[i - 1], value[i], threshold);
    while (i + 1 < time.size() && below(i + 1)) ++i;
    const bool ends_unseen = i + 1 == time.size() || std::isnan(value[i + 1]);
    stretch.is_cut_after = ends_unseen;
    stretch.to =
        ends_unseen ? time[i] : crossing(time[i], time[i + 1], value[i], value[i + 1], threshold);
    found.push_back(stretch);
  }
  return found;
}

/// The longest part of a window throughout which nine of ten futures stay below.
void find_sure(const std::vector<UtcTime>& time,
               const std::vector<std::vector<double>>& futures_m_s, double below_m_s,
               SlackWindow& window) {
  constexpr std::size_t fewest = 10;
  const std::size_t many = futures_m_s.size();
  if (many < fewest) return;
  const auto index = [&](auto at) { return static_cast<std::size_t>(at - time.begin()); };
  const std::size_t from = index(std::lower_bound(time.begin(), time.end(), window.from));
  const std::size_t to = index(std::upper_bound(time.begin(), time.end(), window.to));
  const std::size_t most_that_leave = many / 10;
  // From each time on, backwards: where each future is no longer below.
  std::vector<std::size_t> ends(many, to), sorted;
  for (std::size_t first = to; first-- > from;) {
    for (std::size_t f = 0; f < many; ++f)
      if (!(futures_m_s[f][first] < below_m_s)) ends[f] = first;
    sorted = ends;
    const auto enough = sorted.begin() + static_cast<std::ptrdiff_t>(most_that_leave);
    std::nth_element(sorted.begin(), enough, sorted.end());
    if (*enough == first) continue;
    const UtcTime last = time[*enough - 1];
    if (window.sure_from && last - time[first] < *window.sure_to - *window.sure_from) continue;
    window.sure_from = time[first];
    window.sure_to = last;
  }
}

}  // namespace

std::vector<SlackWindow> slack_windows(const std::vector<UtcTime>& time,
                                       const std::vector<double>& likely_m_s,
                                       const std::vector<std::vector<double>>& futures_m_s,
                                       double below_m_s) {
  expects(likely_m_s.size() == time.size(), "a speed for every time");
  for (const std::vector<double>& future : futures_m_s)
    expects(future.size() == time.size(), "a speed of every future for every time");
  std::vector<SlackWindow> windows;
  for (const Stretch& likely : stretches_below(time, likely_m_s, below_m_s)) {
    SlackWindow window{.from = likely.from,
                       .to = likely.to,
                       .is_cut_before = likely.is_cut_before,
                       .is_cut_after = likely.is_cut_after,
                       .sure_from = {},
                       .sure_to = {}};
    find_sure(time, futures_m_s, below_m_s, window);
    windows.push_back(window);
  }
  return windows;
}

}  // namespace slackwater::api
