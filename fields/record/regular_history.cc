#include "fields/record/regular_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

/// A clock beside another may be finer than the finest series by this factor, no more: hourly
/// values five minutes apart would make a clock of five minutes.
constexpr Duration::rep finest_share = 12;

std::string name_of(const HistorySeries& series) {
  return series.source.empty() ? series.name : series.source + ": " + series.name;
}

std::string step_text(Duration step) {
  const auto ms = step.count();
  if (ms % 3'600'000 == 0) return formatted("{} h", ms / 3'600'000);
  if (ms % 60'000 == 0) return formatted("{} min", ms / 60'000);
  return formatted("{:g} s", static_cast<double>(ms) / 1000);
}

/// The step of a series and the number of each of its times, counted from its first.
struct OwnSteps {
  UtcTime first{};
  Duration step{};
  std::vector<std::size_t> number;
};

/// The mean of the differences that are one step long, which are those within a tenth of the
/// shortest. Axes written as days in floating point are some milliseconds off, in single
/// precision some minutes: what is longer than a minute is a whole number of seconds.
Duration usual_step(const std::vector<UtcTime>& time) {
  Duration shortest = Duration::max();
  for (std::size_t t = 1; t < time.size(); ++t)
    shortest = std::min(shortest, time[t] - time[t - 1]);
  expects(shortest > Duration(0), "times of a history ascend");
  Duration sum{0};
  Duration::rep count = 0;
  for (std::size_t t = 1; t < time.size(); ++t) {
    const Duration one = time[t] - time[t - 1];
    if (10 * one > 11 * shortest) continue;
    sum += one;
    ++count;
  }
  const Duration mean = (sum + Duration(count / 2)) / count;
  if (mean < std::chrono::minutes(1)) return mean;
  return std::chrono::round<std::chrono::seconds>(mean);
}

OwnSteps own_steps_of(const HistorySeries& series) {
  if (series.time.size() < 2)
    refuse(name_of(series) + ": found " + (series.time.empty() ? "no time" : "one time") +
           ", expected two or more, to know the step");
  OwnSteps own;
  own.first = series.time.front();
  own.step = usual_step(series.time);
  own.number.reserve(series.time.size());
  for (std::size_t t = 0; t < series.time.size(); ++t) {
    const Duration since = series.time[t] - own.first;
    const auto number = (since + own.step / 2) / own.step;
    const Duration stray = since - number * own.step;
    if (std::abs(stray.count()) * 20 > own.step.count())
      refuse(name_of(series) + ": found times that are not regular: " + format_utc(series.time[t]) +
             " is no multiple of " + step_text(own.step) + " after " + format_utc(own.first) +
             "; expected one step from the first to the last, with gaps where values are missing: "
             "bring the series to regular steps");
    own.number.push_back(static_cast<std::size_t>(number));
  }
  return own;
}

StepClock clock_of(std::span<const HistorySeries> series, const std::vector<OwnSteps>& own) {
  StepClock clock;
  clock.first = own.front().first;
  UtcTime end = own.front().first;
  for (const OwnSteps& one : own) {
    clock.first = std::min(clock.first, one.first);
    end = std::max(end, one.first + one.step * static_cast<Duration::rep>(one.number.back() + 1));
  }
  Duration::rep step = 0;
  Duration::rep finest = std::numeric_limits<Duration::rep>::max();
  for (const OwnSteps& one : own) {
    step = std::gcd(step, std::gcd(one.step.count(), (one.first - clock.first).count()));
    finest = std::min(finest, one.step.count());
  }
  if (step * finest_share < finest) {
    std::string found;
    for (std::size_t s = 0; s < own.size(); ++s)
      found += (s == 0 ? "" : ", ") + series[s].name + " every " + step_text(own[s].step) +
               " from " + format_utc(own[s].first);
    refuse("found series whose times share no step: " + found +
           "; expected steps that divide each other: bring them to the same times");
  }
  clock.step = Duration(step);
  const auto steps = static_cast<std::size_t>((end - clock.first) / clock.step);
  if (steps > most_steps)
    refuse(formatted("found {} steps of {} from {} to {}, expected at most {}; cut the series",
                     steps, step_text(clock.step), format_utc(clock.first), format_utc(end),
                     most_steps));
  clock.steps = steps;
  return clock;
}

}  // namespace

RegularHistory on_regular_steps(std::span<const HistorySeries> series) {
  expects(!series.empty(), "a history has one series at least");
  std::vector<OwnSteps> own;
  for (const HistorySeries& one : series) {
    expects(one.time.size() == one.value.size(), "a history has a value for each time");
    own.push_back(own_steps_of(one));
  }
  RegularHistory history;
  history.clock = clock_of(series, own);
  for (std::size_t s = 0; s < series.size(); ++s) {
    std::vector<double> values(history.clock.steps, constants::nan);
    const auto offset =
        static_cast<std::size_t>((own[s].first - history.clock.first) / history.clock.step);
    const auto each = static_cast<std::size_t>(own[s].step / history.clock.step);
    for (std::size_t t = 0; t < own[s].number.size(); ++t) {
      const std::size_t at = offset + own[s].number[t] * each;
      std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(at), each, series[s].value[t]);
    }
    if (each > 1)
      history.notes.push_back(formatted("{} is given every {}: each value counts until the next",
                                        series[s].name, step_text(own[s].step)));
    history.values.push_back(std::move(values));
    history.own_step.push_back(own[s].step);
  }
  return history;
}

}  // namespace slackwater
