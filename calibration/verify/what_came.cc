#include "calibration/verify/what_came.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/day/surface_truth.h"
#include "fields/base/constants.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {
namespace {

constexpr Duration widest_gap = std::chrono::hours(3);

/// A quantity as it came: a moored instrument speaks where it has a value, else the analysed
/// product.
template <typename T>
class Came {
 public:
  Came(const Record<T>& record, const Knowledge& known)
      : nearest_(surface_truth(record, known)), grids_(of_grids(record, known)) {}
  [[nodiscard]] std::optional<T> at(UtcTime time) const {
    const auto value = value_at(nearest_.column, time, widest_gap);
    return value ? value : value_at(grids_.column, time, widest_gap);
  }

 private:
  static Chosen<T> of_grids(const Record<T>& record, const Knowledge& known) {
    Record<T> gridded;
    for (const auto& piece : record.pieces)
      if (!piece.origin->is_point_series) gridded.pieces.push_back(piece);
    return surface_truth(gridded, known);
  }
  Chosen<T> nearest_;
  Chosen<T> grids_;
};

/// The currents of one dataset as analysed, at the stamps and depths of the forecast.
VectorColumn currents_that_came(const ColumnData& data, const Snapshot& forecast,
                                const std::string& dataset, const Knowledge& known) {
  VectorRecord analysed;
  for (const auto& piece : data.current.pieces)
    if (piece.origin->status != DataStatus::forecast) analysed.pieces.push_back(piece);
  Choice choice;
  choice.dataset = dataset;
  std::vector<TimeCell> stamps;
  for (const UtcTime time : forecast.time) stamps.push_back(TimeCell::instant(time));
  const Chosen<Horizontal> chosen = choose(analysed, known, choice);
  if (chosen.empty()) return {};
  return at_times(at_depths(chosen.column, forecast.depth_m), stamps, widest_gap);
}

/// Sets the currents. @return how many stamps from the first on are known
std::size_t set_currents(const VectorColumn& came, const Snapshot& forecast,
                         const ForecastColumn& said, ForecastColumn& column) {
  const std::size_t levels = forecast.depth_m.size();
  for (std::size_t t = 0; t < forecast.time.size(); ++t)
    for (std::size_t k = 0; k < levels; ++k) {
      const std::size_t at = t * levels + k;
      if (said.current_status.empty() || !has_value(said.current_status[at])) continue;
      if (came.time.empty() || !came.has(t, k)) return t;
      column.current_m_s[at] = came.value[came.offset(t, k)];
    }
  return forecast.time.size();
}

std::size_t set_wind(const ColumnData& data, const Snapshot& forecast, const Knowledge& known,
                     ForecastColumn& column) {
  if (column.wind_m_s.empty()) return forecast.time.size();
  const Came<Horizontal> came(data.wind, known);
  for (std::size_t t = 0; t < forecast.time.size(); ++t) {
    const auto value = came.at(forecast.time[t]);
    if (!value) return t;
    column.wind_m_s[t] = *value;
    column.wind_source[t] = DataStatus::analysis;
  }
  return forecast.time.size();
}

std::size_t set_waves(const ColumnData& data, const Snapshot& forecast, const Knowledge& known,
                      ForecastColumn& column) {
  const Came<double> height(data.significant_height, known);
  const Came<double> period(data.peak_period, known);
  const Chosen<double> direction = surface_truth(data.wave_direction, known);
  for (std::size_t t = 0; t < column.sea.size(); ++t) {
    SeaState& sea = column.sea[t];
    if (std::isnan(sea.significant_height_m)) continue;
    const UtcTime time = forecast.time[t];
    const auto height_m = height.at(time);
    if (!height_m) return t;
    sea.significant_height_m = *height_m;
    sea.peak_period_s = period.at(time).value_or(sea.peak_period_s);
    // Directions are not averaged: the later one speaks.
    const auto later = std::find_if(
        direction.column.time.begin(), direction.column.time.end(), [&](const TimeCell& cell) {
          return cell.centre() >= time && cell.centre() - time <= widest_gap;
        });
    if (later != direction.column.time.end()) {
      const auto d = static_cast<std::size_t>(later - direction.column.time.begin());
      if (direction.column.has(d)) sea.from_direction_deg = direction.column.value[d];
    }
    column.sea_source[t] = DataStatus::analysis;
  }
  return forecast.time.size();
}

/// The first `stamps` of an array that runs over all of them.
template <typename T>
void cut(std::vector<T>& values, std::size_t stamps, std::size_t all) {
  if (!values.empty()) values.resize(values.size() / all * stamps);
}

void cut(Snapshot& snapshot, std::size_t stamps) {
  const std::size_t all = snapshot.time.size();
  for (ForecastColumn& column : snapshot.columns) {
    cut(column.current_m_s, stamps, all);
    cut(column.current_sigma_m_s, stamps, all);
    cut(column.current_status, stamps, all);
    cut(column.wind_m_s, stamps, all);
    cut(column.wind_source, stamps, all);
    cut(column.sea, stamps, all);
    cut(column.sea_source, stamps, all);
    cut(column.height_spread, stamps, all);
    cut(column.sea_level.level_m, stamps, all);
    cut(column.sea_level.sigma_m, stamps, all);
    cut(column.sea_level.source, stamps, all);
  }
  snapshot.time.resize(stamps);
}

}  // namespace

std::shared_ptr<const Snapshot> what_came(const SiteData& data, const Snapshot& forecast,
                                          const std::string& dataset, UtcTime known_by) {
  Knowledge known;
  known.values_until = known_by;
  auto came = std::make_shared<Snapshot>(forecast);
  came->members = 1;
  std::size_t stamps = forecast.time.size();
  for (ForecastColumn& column : came->columns) {
    const ColumnData* of = data.column_at(column.point);
    if (of == nullptr) return nullptr;
    column.member_m_s.clear();
    column.wind_member_m_s.clear();
    column.wind_member_number.clear();
    std::fill(column.current_sigma_m_s.begin(), column.current_sigma_m_s.end(), 0.0);
    std::fill(column.height_spread.begin(), column.height_spread.end(), 0.0);
    std::fill(column.sea_level.sigma_m.begin(), column.sea_level.sigma_m.end(), 0.0);
    const std::size_t index = static_cast<std::size_t>(&column - came->columns.data());
    stamps =
        std::min({stamps,
                  set_currents(currents_that_came(*of, forecast, dataset, known), forecast,
                               forecast.columns[index], column),
                  set_wind(*of, forecast, known, column), set_waves(*of, forecast, known, column)});
  }
  if (stamps < 2) return nullptr;
  cut(*came, stamps);
  return came;
}

}  // namespace slackwater::calibration
