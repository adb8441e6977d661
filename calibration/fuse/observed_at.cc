#include "calibration/fuse/observed_at.h"

#include <algorithm>

#include "fields/base/numbers/statistics.h"

namespace slackwater::calibration {
namespace {

Duration usual_step(const std::vector<TimeCell>& cells) {
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < cells.size(); ++i)
    steps.push_back(cells[i].centre() - cells[i - 1].centre());
  if (steps.empty()) return Duration(0);
  return upper_median(std::move(steps));
}

}  // namespace

ObservedLevel::ObservedLevel(const VectorColumn& observed, std::size_t level,
                             const FusionSettings& settings)
    : widest_gap_(settings.widest_gap), least_coverage_(settings.least_coverage) {
  for (std::size_t t = 0; t < observed.times(); ++t) {
    if (!observed.has(t, level)) continue;
    cells_.push_back(observed.time[t]);
    value_.push_back(observed.value[observed.offset(t, level)]);
  }
  step_ = usual_step(cells_);
}

std::optional<Horizontal> ObservedLevel::at(const TimeCell& cell) const {
  if (cells_.empty()) return std::nullopt;
  if (averages(cell)) return over(cell);
  return at_instant(cell.centre());
}

double ObservedLevel::noise_left(const TimeCell& cell) const {
  if (!averages(cell) || step_ <= Duration(0)) return 1;
  return std::chrono::duration<double>(step_).count() / seconds_between(cell.start, cell.end);
}

bool ObservedLevel::averages(const TimeCell& cell) const {
  // Samples rarer than the cell cannot be averaged in it.
  return cell.is_mean() && cell.end - cell.start >= step_;
}

std::optional<Horizontal> ObservedLevel::at_instant(UtcTime time) const {
  const auto above =
      std::lower_bound(cells_.begin(), cells_.end(), time,
                       [](const TimeCell& cell, UtcTime t) { return cell.centre() < t; });
  if (above == cells_.end()) return std::nullopt;
  const auto high = static_cast<std::size_t>(above - cells_.begin());
  if (cells_[high].centre() == time) return value_[high];
  if (high == 0) return std::nullopt;
  const UtcTime from = cells_[high - 1].centre();
  const UtcTime to = cells_[high].centre();
  if (to - from > widest_gap_) return std::nullopt;
  const double share = seconds_between(from, time) / seconds_between(from, to);
  return (1 - share) * value_[high - 1] + share * value_[high];
}

std::optional<Horizontal> ObservedLevel::over(const TimeCell& cell) const {
  auto sample = std::lower_bound(cells_.begin(), cells_.end(), cell.start,
                                 [](const TimeCell& one, UtcTime t) { return one.centre() < t; });
  Horizontal sum{};
  double weight = 0;
  for (; sample != cells_.end() && sample->centre() <= cell.end; ++sample) {
    // A sample on the edge speaks for both sides.
    const bool edge = sample->centre() == cell.start || sample->centre() == cell.end;
    const double share = edge ? 0.5 : 1.0;
    sum += share * value_[static_cast<std::size_t>(sample - cells_.begin())];
    weight += share;
  }
  const double expected = step_ > Duration(0) ? seconds_between(cell.start, cell.end) /
                                                    std::chrono::duration<double>(step_).count()
                                              : 1.0;
  if (weight <= 0 || weight < least_coverage_ * expected) return std::nullopt;
  return sum / weight;
}

}  // namespace slackwater::calibration
