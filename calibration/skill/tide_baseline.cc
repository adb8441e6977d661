#include "calibration/skill/tide_baseline.h"

#include <Eigen/Dense>
#include <string_view>

#include "calibration/skill/history.h"
#include "fields/current/astronomy.h"
#include "fields/current/tide.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;

constexpr std::array<std::string_view, 5> constituents{"M2", "S2", "K1", "O1", "M4"};
constexpr Duration record_needed = std::chrono::days(15);

const std::array<double, constituents.size()>& speeds_rad_s() {
  static const std::array<double, constituents.size()> speeds = [] {
    std::array<double, constituents.size()> found{};
    for (std::size_t i = 0; i < constituents.size(); ++i)
      found[i] = tidal_constituent(constituents[i]).speed_rad_s;
    return found;
  }();
  return speeds;
}

/// e^{i w t} of the five constituents at a cell, averaged over it where it is a mean.
std::array<Horizontal, constituents.size()> phases_at(UtcTime reference, const TimeCell& cell) {
  std::array<Horizontal, constituents.size()> phases;
  TideFit unit;
  unit.reference = reference;
  unit.terms.resize(1);
  unit.terms[0].counter_clockwise = 1.0;
  for (std::size_t i = 0; i < constituents.size(); ++i) {
    unit.terms[0].speed_rad_s = speeds_rad_s()[i];
    phases[i] = tidal_oscillation(unit, cell);
  }
  return phases;
}

Eigen::MatrixXcd design(UtcTime reference, const VectorColumn& history,
                        const std::vector<std::size_t>& times) {
  Eigen::MatrixXcd rows(static_cast<Index>(times.size()),
                        1 + 2 * static_cast<Index>(constituents.size()));
  for (std::size_t r = 0; r < times.size(); ++r) {
    const auto row = static_cast<Index>(r);
    const auto phases = phases_at(reference, history.time[times[r]]);
    rows(row, 0) = 1.0;
    for (std::size_t i = 0; i < constituents.size(); ++i) {
      rows(row, static_cast<Index>(1 + 2 * i)) = phases[i];
      rows(row, static_cast<Index>(2 + 2 * i)) = std::conj(phases[i]);
    }
  }
  return rows;
}

/// The times of a level's values within the last 15 days; empty where its record is shorter.
std::vector<std::size_t> times_of_level(const VectorColumn& history, std::size_t level,
                                        UtcTime start, UtcTime end) {
  std::vector<std::size_t> times;
  bool reaches_back = false;
  for (std::size_t t = 0; t < history.times(); ++t) {
    if (!history.has(t, level)) continue;
    const TimeCell& cell = history.time[t];
    reaches_back = reaches_back || cell.start <= start;
    if (cell.start >= start && cell.end <= end) times.push_back(t);
  }
  if (!reaches_back) times.clear();
  return times;
}

}  // namespace

ColumnTide::ColumnTide(const VectorColumn& history, UtcDay day, UtcTime since)
    : reference_(end_of_day(day)), level_(history.levels()) {
  if (reference_ - record_needed < since) return;
  std::vector<std::size_t> factorised;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXcd> factors;
  // The table's speeds are good to 2e-8 degrees an hour, which is 1e-7 rad over 15 days: columns
  // that differ by no more are one, or the noise between them would be blown up a million times.
  factors.setThreshold(1e-6);
  for (std::size_t k = 0; k < history.levels(); ++k) {
    const std::vector<std::size_t> times =
        times_of_level(history, k, reference_ - record_needed, reference_);
    if (times.size() < unknowns) continue;
    if (times != factorised) {
      factors.compute(design(reference_, history, times));
      factorised = times;
    }
    Eigen::VectorXcd values(static_cast<Index>(times.size()));
    for (std::size_t r = 0; r < times.size(); ++r)
      values(static_cast<Index>(r)) = history.value[history.offset(times[r], k)];
    const Eigen::VectorXcd solution = factors.solve(values);
    Coefficients& coefficients = level_[k].emplace();
    for (std::size_t i = 0; i < unknowns; ++i) coefficients[i] = solution(static_cast<Index>(i));
  }
}

std::vector<Horizontal> ColumnTide::oscillation(std::span<const TimeCell> cells) const {
  std::vector<Horizontal> result(cells.size() * level_.size());
  bool any = false;
  for (const auto& level : level_) any = any || level.has_value();
  if (!any) return result;
  for (std::size_t t = 0; t < cells.size(); ++t) {
    const auto phases = phases_at(reference_, cells[t]);
    for (std::size_t k = 0; k < level_.size(); ++k) {
      if (!level_[k]) continue;
      Horizontal& sum = result[t * level_.size() + k];
      for (std::size_t i = 0; i < constituents.size(); ++i)
        sum += (*level_[k])[1 + 2 * i] * phases[i] + (*level_[k])[2 + 2 * i] * std::conj(phases[i]);
    }
  }
  return result;
}

}  // namespace slackwater::calibration
